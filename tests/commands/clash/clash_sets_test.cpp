// Sets, groups, tolerance and journal of `soms clash`.
#include "tests/commands/run.h"
#include "tests/support/support.h"

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

std::string clash_file(const std::string& name) {
  return test::data("clash/" + name).string();
}

/// Runs `clash` on the two disciplines of a building.
RunResult building(std::vector<std::string> words) {
  words.insert(words.begin(),
               {"clash", clash_file("structure.obj"), clash_file("services.gltf"), "--quiet"});
  return soms_run(words);
}

Json totals_of(const RunResult& result) {
  EXPECT_EQ(result.status, 0) << result.err;
  return json_lines(result.out).back();
}

/// The cell of the matrix for two sets; 0 where there is none.
std::uint64_t cell(const Json& totals, const std::string& a, const std::string& b) {
  for (const Json& found : totals.at("by_sets")) {
    if (found.at("a") == a && found.at("b") == b) {
      return found.at("pairs").get<std::uint64_t>();
    }
  }
  return 0;
}

TEST(ClashSets, AreTheFilesUnlessNamed) {
  const Json totals = totals_of(building({"--json"}));
  const std::uint64_t between = cell(totals, "services", "structure");
  EXPECT_GE(between, 260U);
  EXPECT_GT(cell(totals, "structure", "structure"), 0U);
  EXPECT_EQ(between + cell(totals, "structure", "structure") + cell(totals, "services", "services"),
            totals.at("pairs"));
  // The matrix of one file against the other is the list of the two sets.
  EXPECT_EQ(totals_of(building({"--json", "--between", "structure,services"})).at("pairs"),
            between);
}

TEST(ClashSets, AreNamedByPatterns) {
  const Json totals = totals_of(building({"--json", "--set", "beams=Beam*", "--set", "ducts=Duct*",
                                          "--between", "beams,ducts", "--verify"}));
  ASSERT_EQ(totals.at("by_sets").size(), 1U);
  EXPECT_EQ(totals.at("pairs"), totals.at("by_sets")[0].at("pairs"));
  EXPECT_EQ(totals.at("verified"), true);
  for (const Json& row : json_lines(building({"--json", "--set", "beams=Beam*", "--set",
                                              "ducts=Duct*", "--between", "beams,ducts"})
                                        .out)) {
    if (row.contains("key")) {
      EXPECT_NE(row.at("a").at("set"), row.at("b").at("set"));
    }
  }
}

TEST(ClashSets, ThatNobodyBelongsToAreRefused) {
  const RunResult result = building({"--between", "structure,pipework"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("services"), std::string::npos) << result.err;
  EXPECT_EQ(building({"--between", "structure"}).status, 2);
  EXPECT_EQ(building({"--set", "=x"}).status, 2);
  EXPECT_EQ(building({"--set", "slabs"}).status, 2);
  const RunResult nothing = building({"--set", "ducts=duct*"});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_NE(nothing.err.find("case-sensitive"), std::string::npos) << nothing.err;
}

TEST(ClashGroups, CountEachClashOnce) {
  for (const char* const by : {"a", "b", "parent", "type", "set", "cell=2.5"}) {
    const RunResult result = building({"--json", "--group-by", by});
    const std::vector<Json> lines = json_lines(result.out);
    const Json totals = totals_of(result);
    std::map<std::string, std::uint64_t> counts;
    for (const Json& row : lines) {
      if (row.contains("key")) {
        ++counts[row.at("group").get<std::string>()];
      }
    }
    std::uint64_t before = lines.size();
    EXPECT_EQ(totals.at("by_group").size(), counts.size()) << by;
    for (const Json& group : totals.at("by_group")) {
      EXPECT_EQ(group.at("pairs"), counts[group.at("group").get<std::string>()]) << by;
      EXPECT_LE(group.at("pairs"), before);
      before = group.at("pairs").get<std::uint64_t>();
    }
  }
  EXPECT_NE(building({"--group-by", "set"}).out.find("services and services: "), std::string::npos);
  EXPECT_EQ(building({"--group-by", "color"}).status, 2);
  EXPECT_EQ(building({"--group-by", "cell=0"}).status, 2);
}

TEST(ClashTolerance, RemovesWhatIsNotDeeperAndSaysHowMuch) {
  std::uint64_t deep = 0;
  std::uint64_t shallow = 0;
  std::uint64_t touching = 0;
  for (const Json& row : json_lines(building({"--json"}).out)) {
    if (!row.contains("key")) {
      continue;
    }
    touching += row.at("class") == "touching" ? 1U : 0U;
    if (row.contains("depth")) {
      ++(row.at("depth") <= 0.1 ? shallow : deep);
    }
  }
  EXPECT_GT(deep, 0U);
  EXPECT_GT(shallow, 0U);
  EXPECT_GT(touching, 0U);
  const Json totals = totals_of(building({"--json", "--tolerance", "0.1"}));
  EXPECT_EQ(totals.at("removed").at("tolerance"), shallow + touching);
  EXPECT_EQ(totals.at("pairs"), deep);
  EXPECT_EQ(totals.at("unknown_depth"), 0);
  EXPECT_EQ(building({"--tolerance", "-1"}).status, 2);
  EXPECT_EQ(building({"--tolerance", "inf"}).status, 2);
}

/// All that a list says but for costs.
std::vector<Json> without_cost(const std::string& text) {
  std::vector<Json> lines = json_lines(text);
  lines.back().erase("cost");
  lines.back().erase("resumed");
  return lines;
}

TEST(ClashJournal, GoesOnWhereItEnded) {
  const TemporaryFolder folder;
  const std::string journal = (folder.path() / "clash.journal").string();
  const RunResult plain = building({"--json", "--clearance", "0.5"});
  const RunResult first = building({"--json", "--clearance", "0.5", "--journal", journal});
  EXPECT_EQ(without_cost(first.out), without_cost(plain.out));
  const std::string whole = read_text(journal);
  // As after a crash in the middle of a line: what stands before it is kept.
  const std::size_t second_block = whole.find('\n', whole.find('\n') + 1) + 1;
  ASSERT_LT(second_block, whole.size());
  for (const std::size_t end : {second_block, second_block + 40, whole.size() - 1, whole.size()}) {
    write_text(journal, whole.substr(0, end));
    const RunResult again = building({"--json", "--clearance", "0.5", "--journal", journal});
    EXPECT_EQ(without_cost(again.out), without_cost(plain.out));
    EXPECT_GT(json_lines(again.out).back().at("resumed"), 0);
    EXPECT_EQ(read_text(journal), whole);
  }
}

TEST(ClashJournal, IsOfTheSameModelsAndOptions) {
  const TemporaryFolder folder;
  const std::string journal = (folder.path() / "clash.journal").string();
  ASSERT_EQ(building({"--journal", journal}).status, 0);
  const RunResult other = building({"--journal", journal, "--clearance", "1"});
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("of other models or options"), std::string::npos) << other.err;
  write_text(journal, "no journal\n");
  EXPECT_EQ(building({"--journal", journal}).status, 3);
  EXPECT_EQ(building({"--journal", (folder.path() / "missing" / "x").string()}).status, 5);
}

}  // namespace
}  // namespace soms::test
