// Lists that were written by somebody else: every member of another type, absent or damaged is an
// error that names file and line, and never an end of the program.
#include "soms/base/error.h"
#include "soms/base/hash.h"
#include "soms/clash/part_keys.h"

#include "apps/rows/json_list.h"
#include "apps/soms/clash/clash_baseline.h"
#include "apps/soms/clash/clash_journal.h"
#include "apps/soms/clash/clash_looked_at.h"
#include "apps/soms/clash/clash_output.h"
#include "apps/soms/clash/clash_sets.h"
#include "tests/commands/run.h"
#include "tests/support/json_mutations.h"
#include "tests/support/support.h"

#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace soms::test {
namespace {

using ListJson = nlohmann::ordered_json;

constexpr int kChanges = 5000;

std::string list_data(const std::string& name) {
  return test::data("lists/" + name).string();
}

TEST(ChangedLists, ABaselineWhoseSchemaIsAListIsAnErrorWithItsLine) {
  const RunResult result =
      soms_run({"clash", list_data("two.obj"), "--against", list_data("pipe.obj"), "--baseline",
                list_data("baseline-schema-array.json")});
  EXPECT_EQ(result.status, 3) << result.err;
  EXPECT_NE(result.err.find("baseline-schema-array.json, line 1, schema: expected a text"),
            std::string::npos)
      << result.err;
}

TEST(ChangedLists, AJournalWhoseSchemaIsAListIsAnErrorWithItsLine) {
  const TemporaryFolder folder;
  const std::string journal = (folder.path() / "journal").string();
  write_text(journal, read_text(list_data("journal-schema-array")));
  const RunResult result = soms_run(
      {"clash", list_data("two.obj"), "--against", list_data("pipe.obj"), "--journal", journal});
  EXPECT_EQ(result.status, 3) << result.err;
  EXPECT_NE(result.err.find("journal, line 1: no journal of soms clash"), std::string::npos)
      << result.err;
}

TEST(ChangedLists, OfUtf16AreErrorsThatSayIt) {
  const TemporaryFolder folder;
  const std::string list = (folder.path() / "list").string();
  for (const std::string& mark : {std::string("\xff\xfe"), std::string("\xfe\xff")}) {
    for (const char* const option : {"--ignore-pairs", "--baseline", "--journal"}) {
      write_text(list, mark + std::string("w\0,\0p\0\n\0", 8));
      const RunResult result = soms_run(
          {"clash", list_data("two.obj"), "--against", list_data("pipe.obj"), option, list});
      EXPECT_EQ(result.status, 3) << result.err;
      EXPECT_NE(result.err.find(option + (" " + list) + ": text in UTF-16"), std::string::npos)
          << result.err;
    }
  }
}

/// A model of two boxes' shells, in parts, as `clash` holds it.
command::ClashModels models_of_parts() {
  Mesh mesh;
  mesh.source = "made";
  for (const double shift : {0.0, 0.5}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      mesh.vertices.push_back({corner.x + shift / 2, corner.y + shift / 4, corner.z});
    }
    mesh.parts.push_back({.name = shift == 0 ? "wall" : "pipe",
                          .first = static_cast<std::uint32_t>(mesh.triangles.size()),
                          .count = 4});
    for (const auto& [a, b, c] :
         {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
      mesh.triangles.push_back({first + a, first + b, first + c});
    }
  }
  command::ClashModels models;
  models.a.meshes.push_back(mesh);
  models.a.parts = part_bodies(mesh);
  std::vector<MeshPart> named;
  for (const PartBody& part : models.a.parts) {
    named.push_back({models.a.meshes.front(), &part});
  }
  models.a.keys = part_keys(named);
  models.a.mesh = {0, 0};
  models.a.labels = {"wall", "pipe"};
  models.a.sets = {"walls", "pipes"};
  return models;
}

/// A list of the clash of these models, without the end's last line break.
std::vector<ListJson> list_of(const command::ClashModels& models) {
  command::ClashReport report{.models = models};
  const ClashList found = clashes(models.a.parts);
  for (const Clash& clash : found.clashes) {
    report.rows.push_back(
        {.clash = clash, .key = clash_key(models.a.keys[clash.a], models.a.keys[clash.b])});
    ++report.by_kind[static_cast<std::size_t>(clash.kind)];
  }
  report.removed = {{"touching", 0}};
  std::ostringstream text;
  command::JsonListWriter list(text, "list.jsonl");
  command::write_clashes_as_json(report, false, list);
  std::vector<ListJson> objects;
  std::istringstream lines(text.str());
  for (std::string line; std::getline(lines, line);) {
    objects.push_back(ListJson::parse(line));
  }
  return objects;
}

std::string text_of(const ListJson& object) {
  return object.dump(-1, ' ', false, ListJson::error_handler_t::replace);
}

std::string text_of_list(const std::vector<ListJson>& objects, bool document) {
  std::ostringstream text;
  command::JsonListWriter list(text, document ? "a.json" : "a.jsonl");
  for (std::size_t k = 0; k + 1 < objects.size(); ++k) {
    list.add_text(text_of(objects[k]));
  }
  if (objects.back().is_object()) {
    list.finish(command::parse_json(text_of(objects.back()), 100).value);
  } else {
    list.add_text(text_of(objects.back()));
  }
  return text.str();
}

/// Bytes flipped, left out or doubled.
std::string with_changed_bytes(std::string text, Rng& rng) {
  for (std::uint64_t changes = 1 + rng.below(3); changes > 0 && !text.empty(); --changes) {
    const std::size_t at = rng.below(text.size());
    switch (rng.below(3)) {
      case 0:
        text[at] = static_cast<char>(rng.below(256));
        break;
      case 1:
        text.erase(at, 1 + rng.below(8));
        break;
      default:
        text.insert(at, text.substr(at, 1 + rng.below(8)));
    }
  }
  return text;
}

/// How often a changed file was taken and how often refused, by an error that names it.
struct Outcomes {
  int taken = 0;
  int refused = 0;
  int with_line = 0;
};

void read_changed(const std::filesystem::path& file, const std::string& text,
                  const std::function<void(const std::string&)>& read, Outcomes& outcomes) {
  write_text(file, text);
  try {
    read(file.string());
    ++outcomes.taken;
  } catch (const Error& error) {
    ++outcomes.refused;
    EXPECT_TRUE(error.kind() == ErrorKind::bad_file || error.kind() == ErrorKind::usage) << text;
    EXPECT_NE(error.place().find(file.filename().string()), std::string::npos) << error.what();
    EXPECT_FALSE(error.remedy().empty());
    outcomes.with_line += error.place().find(", line ") != std::string::npos ? 1 : 0;
  }
}

/// Looks at all that a list which was taken leads to.
void use_baseline(const command::ClashBaseline& baseline, const command::ClashModels& models) {
  command::ClashSetOptions sets;
  sets.between = {{"walls", "walls"}};
  for (const std::optional<double>& within : {std::optional<double>(), std::optional(0.5)}) {
    command::ClashReport report{.models = models};
    baseline.compare({}, command::LookedAt(models, sets, within), report);
    baseline.compare(
        {}, [](const command::Json&) { return true; }, report);
    std::ostringstream out;
    command::write_clashes_as_csv(report, out);
    command::JsonListWriter list(out, "out.json");
    command::write_clashes_as_json(report, false, list);
    const command::ListedClashes listed(report);
    for (std::size_t k = 0; k < listed.size(); ++k) {
      static_cast<void>(command::side_label(listed.at(k).row, "a"));
    }
  }
}

TEST(ChangedLists, Baselines) {
  const TemporaryFolder folder;
  const command::ClashModels models = models_of_parts();
  const std::vector<ListJson> whole = list_of(models);
  ASSERT_GE(whole.size(), 2U);
  for (const bool document : {false, true}) {
    Outcomes outcomes;
    const std::filesystem::path file = folder.path() / (document ? "old.json" : "old.jsonl");
    const auto read = [&](const std::string& name) {
      const command::ClashBaseline baseline(name, {"touching"});
      use_baseline(baseline, models);
    };
    read_changed(file, text_of_list(whole, document), read, outcomes);
    ASSERT_EQ(outcomes.taken, 1);
    for_each_case("changed baseline", kChanges, [&](Rng& rng) {
      std::vector<ListJson> objects = whole;
      for (std::uint64_t changes = 1 + rng.below(2); changes > 0; --changes) {
        mutate(objects[rng.below(objects.size())], rng);
      }
      std::string text = text_of_list(objects, document);
      if (rng.below(3) == 0) {
        text = with_changed_bytes(text, rng);
      }
      read_changed(file, text, read, outcomes);
    });
    EXPECT_GT(outcomes.taken, kChanges / 50);
    EXPECT_GT(outcomes.refused, kChanges / 2);
    EXPECT_GT(outcomes.with_line, document ? 0 : kChanges / 2);
  }
}

TEST(ChangedLists, IgnoredPairs) {
  const TemporaryFolder folder;
  const command::ClashModels models = models_of_parts();
  const ClashList found = clashes(models.a.parts);
  ASSERT_FALSE(found.clashes.empty());
  const std::string whole =
      "# what nobody wants to see\nwall,pipe\n\"a, b\",[a-z]*\n*duct?,\"q\"\"q\"\n";
  Outcomes outcomes;
  for_each_case("changed pairs", kChanges, [&](Rng& rng) {
    read_changed(
        folder.path() / "pairs.csv", with_changed_bytes(whole, rng),
        [&](const std::string& name) {
          const command::IgnoredPairs pairs(name);
          static_cast<void>(pairs.match(models, found.clashes.front()));
        },
        outcomes);
  });
  EXPECT_GT(outcomes.taken, kChanges / 10);
  EXPECT_EQ(outcomes.with_line, outcomes.refused);
  EXPECT_GT(outcomes.refused, kChanges / 10);
}

/// A line of a journal whose sum is right whatever it holds.
std::string summed(const std::string& text) {
  Fnv1a hash;
  for (const char c : text) {
    hash.add_byte(static_cast<std::uint8_t>(c));
  }
  return command::key_text(hash.value()) + ' ' + text + '\n';
}

TEST(ChangedLists, Journals) {
  const TemporaryFolder folder;
  const command::ClashModels models = models_of_parts();
  const std::vector<PartNumbers> candidates{{0, 1}};
  const std::filesystem::path file = folder.path() / "journal";
  const auto read = [&](const std::string& name) {
    const command::ClashJournal journal(name, models, {}, candidates);
    ASSERT_LE(journal.kept().done, candidates.size());
    for (const Clash& clash : journal.kept().clashes) {
      ASSERT_LT(clash.a, models.a.parts.size());
      ASSERT_LT(clash.b, models.a.parts.size());
      ASSERT_LE(clash.kind, ClashKind::undecided);
      ASSERT_LE(clash.relation, Relation::undecided);
      ASSERT_FALSE(soms::name(clash.kind).empty());
    }
  };
  {
    command::ClashJournal journal(file.string(), models, {}, candidates);
    journal.add(1, clashes(models.a.parts));
  }
  const std::string whole = read_text(file);
  const std::size_t end = whole.find('\n') + 1;
  const ListJson block = ListJson::parse(whole.substr(whole.find(' ', end) + 1));
  Outcomes outcomes;
  int kept = 0;
  for_each_case("changed journal", kChanges, [&](Rng& rng) {
    ListJson changed = block;
    mutate(changed, rng);
    std::string text = whole.substr(0, end) + summed(text_of(changed));
    if (rng.below(4) == 0) {
      text = with_changed_bytes(text, rng);
    }
    read_changed(file, text, read, outcomes);
    kept += outcomes.taken > 0 && read_text(file).size() > end ? 1 : 0;
  });
  EXPECT_GT(outcomes.taken, kChanges / 2);
  EXPECT_GT(outcomes.refused, kChanges / 50);
  EXPECT_GT(kept, kChanges / 50);
}

/// One clash that is there now, of a list that an older one was filtered from.
struct FilteredList {
  TemporaryFolder folder;
  std::string model = list_data("two.obj");
  std::string other = list_data("pipe.obj");
  std::string old = (folder.path() / "old.json").string();

  RunResult run(const std::vector<std::string>& words) const {
    std::vector<std::string> all = {"clash", model, "--against", other};
    all.insert(all.end(), words.begin(), words.end());
    return soms_run(all);
  }
};

TEST(ChangedLists, AListThatLacksRowsByAFilterIsNoBaselineWithoutIt) {
  const FilteredList list;
  ASSERT_EQ(list.run({"-o", list.old}).status, 0);
  const std::string kind =
      Json::parse(read_text(list.old)).at("rows").at(0).at("class").get<std::string>();
  ASSERT_EQ(list.run({"-o", list.old, "--ignore-class", kind}).status, 0);
  const RunResult bare = list.run({"--baseline", list.old});
  EXPECT_EQ(bare.status, 2) << bare.err;
  EXPECT_NE(bare.err.find("also give --ignore-class " + kind), std::string::npos) << bare.err;
  EXPECT_EQ(list.run({"--baseline", list.old, "--ignore-class", kind}).status, 0);
}

TEST(ChangedLists, AListByStatusIsNoBaseline) {
  const FilteredList list;
  const std::string active = (list.folder.path() / "active.jsonl").string();
  ASSERT_EQ(list.run({"-o", list.old}).status, 0);
  ASSERT_EQ(list.run({"--baseline", list.old, "--status", "new", "-o", active}).status, 0);
  const RunResult result = list.run({"--baseline", active, "--status", "new"});
  EXPECT_EQ(result.status, 2) << result.err;
  EXPECT_NE(result.err.find("filtered by --status"), std::string::npos) << result.err;
}

TEST(ChangedLists, WhatAListLacksOrHasTwiceIsAnError) {
  const FilteredList list;
  ASSERT_EQ(list.run({"-o", list.old}).status, 0);
  const Json whole = Json::parse(read_text(list.old));
  const auto expect_refused = [&](const std::string& text, const std::string& words) {
    write_text(list.old, text);
    const RunResult result = list.run({"--baseline", list.old});
    EXPECT_EQ(result.status, 3) << words;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  };
  Json changed = whole;
  changed.erase("coverage");
  expect_refused(changed.dump(), "coverage is missing");
  for (const Json& side : {Json(), Json::object()}) {
    changed = whole;
    changed["rows"][0]["b"] = side;
    expect_refused(changed.dump(), "rows[0]: b is no part of a file");
  }
  std::string lines;
  for (const Json& row : whole["rows"]) {
    lines += row.dump() + "\n";
  }
  changed = whole;
  changed.erase("rows");
  lines += changed.dump() + "\n";
  write_text(list.old, lines);
  EXPECT_EQ(list.run({"--baseline", list.old}).status, 0);
  expect_refused(lines + lines, "something follows the end of the list");
}

/// The document that a verb writes to .json, and the lines that it writes to .jsonl and prints.
void expect_both_forms(std::vector<std::string> words) {
  const TemporaryFolder folder;
  const std::filesystem::path document = folder.path() / "out.json";
  const std::filesystem::path lines = folder.path() / "out.jsonl";
  words.insert(words.end(), {"-o", document.string(), "-o", lines.string(), "--json"});
  const RunResult result = soms_run(words);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read_text(lines), result.out);
  const std::vector<Json> objects = json_lines(read_text(lines));
  Json whole = Json::parse(read_text(document));
  ASSERT_GE(objects.size(), 2U);
  const Json rows = whole.at("rows");
  EXPECT_EQ(rows, Json(std::vector<Json>(objects.begin(), objects.end() - 1)));
  whole.erase("rows");
  EXPECT_EQ(whole, objects.back());
}

TEST(ChangedLists, JsonIsOneDocumentAndJsonlIsLinesOfEveryVerb) {
  expect_both_forms({"clash", list_data("two.obj"), "--against", list_data("pipe.obj")});
  expect_both_forms({"robot", data("robots/arm.urdf").string(), "--random", "3"});
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "path.csv").string();
  write_text(path, "x,y,z\n0,0,0\n1,0,0\n2,0,0\n");
  expect_both_forms({"clearance", box(), "--profile", box(), "--path", path});
}

TEST(ChangedLists, BothFormsAreBaselines) {
  const FilteredList list;
  const std::string lines = (list.folder.path() / "old.jsonl").string();
  ASSERT_EQ(list.run({"-o", list.old, "-o", lines}).status, 0);
  const RunResult first = list.run({"--baseline", list.old, "--json"});
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(first.out, list.run({"--baseline", lines, "--json"}).out);
  EXPECT_EQ(json_lines(first.out).back().at("by_status").at("new"), 0);
  // Other programs write it again on one line, or over many.
  const Json whole = Json::parse(read_text(list.old));
  for (const int indent : {-1, 2}) {
    write_text(list.old, whole.dump(indent));
    EXPECT_EQ(list.run({"--baseline", list.old, "--json"}).out, first.out);
  }
  write_text(list.old, "\xef\xbb\xbf\n" + read_text(lines) + "\n\n");
  EXPECT_EQ(list.run({"--baseline", list.old, "--json"}).out, first.out);
}

TEST(ChangedLists, NoDepthOfNestingEndsTheProgram) {
  const FilteredList list;
  for (const std::size_t depth : {65U, 1'000'000U}) {
    for (const bool document : {false, true}) {
      const std::string nested = std::string(depth, '[') + std::string(depth, ']');
      const std::string row =
          R"({"schema":"soms.clash/1","key":"0000000000000000","x":)" + nested + "}";
      write_text(list.old, document ? "{\"rows\":[\n" + row + "\n]}" : row + "\n");
      const RunResult result = list.run({"--baseline", list.old});
      EXPECT_EQ(result.status, 3);
      EXPECT_NE(result.err.find("nested more than 64 levels deep"), std::string::npos)
          << result.err;
    }
  }
}

}  // namespace
}  // namespace soms::test
