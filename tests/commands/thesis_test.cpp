// soms thesis: counts against the golden tables and brute force, lists, models, and soms-view, for
// which a script stands here.
#include "soms/base/text.h"

#include "tests/commands/run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace soms::test {
namespace {

namespace fs = std::filesystem;

/// Runs `soms thesis` with JSON, each time measured once.
Json thesis(std::vector<std::string> words) {
  words.insert(words.begin(), "thesis");
  words.insert(words.end(), {"--json", "--repeat", "1", "--quiet"});
  const RunResult result = soms_run(words);
  EXPECT_EQ(result.status, 0) << result.err;
  return result.status == 0 ? Json::parse(result.out) : Json();
}

RunResult thesis_error(std::vector<std::string> words) {
  words.insert(words.begin(), "thesis");
  return soms_run(words);
}

/// A folder with a knot and a ball.
class Thesis : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(soms_run({"generate", "knot", "--triangles", "800", "-o", knot()}).status, 0);
    ASSERT_EQ(soms_run({"generate", "sphere", "--triangles", "320", "-o", ball()}).status, 0);
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] std::string knot() const { return path("knot.ply"); }

  [[nodiscard]] std::string ball() const { return path("ball.ply"); }

 private:
  TemporaryFolder folder_;
};

/// Still, moving, rule, test, algorithm.
using Key = std::array<std::string, 5>;

/// frames, root_overlap_frames, hit_frames, box_tests, entered, leaf_pairs, triangle_pairs,
/// first_tests.
using Sums = std::array<std::uint64_t, 8>;

std::map<Key, Sums> golden_rows(const std::string& file) {
  std::map<Key, Sums> rows;
  for (const auto& line : read_csv(test::data("thesis/" + file))) {
    if (line.at(0) != "static") {
      Sums sums{};
      for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] = std::stoull(line.at(5 + i));
      }
      rows[{line[0], line[1], line[2], line[3], line[4]}] = sums;
    }
  }
  return rows;
}

Sums sums_of(const Json& test) {
  Sums sums{};
  std::size_t i = 0;
  for (const char* const name : {"frames", "root_overlap_frames", "hit_frames", "box_tests",
                                 "entered", "leaf_pairs", "triangle_pairs", "first_tests"}) {
    sums[i++] = test.at(name);
  }
  return sums;
}

/// Compares every test of a run that has a golden row; returns how many have one.
std::size_t compare(const Json& run, const std::map<Key, Sums>& golden,
                    const std::string& algorithm) {
  std::size_t compared = 0;
  for (const Json& test : run.at("tests")) {
    const std::string rule = run.at("options").at("rule");
    const auto row = golden.find({test.at("still").at("name"), test.at("moving").at("name"), rule,
                                  test.at("test"), algorithm});
    if (row != golden.end()) {
      ++compared;
      EXPECT_EQ(sums_of(test), row->second) << test.at("moving") << test.at("test");
    }
  }
  return compared;
}

TEST(ThesisGolden, CountsAreThoseOfAnIndependentProgram) {
  SOMS_NEEDS_OUTSIDE_DATA("18 rows of the golden tables by the command");
  const std::string models = outside_data("")->string();
  const auto golden = golden_rows("thesis_traversal.csv");
  const auto others = golden_rows("other_objects.csv");
  const Json run = thesis({"--models", models});
  EXPECT_EQ(compare(run, golden, "enode_both"), 5U);  // four sides of the bunny, and its drive
  EXPECT_EQ(compare(run, others, "enode_both"), 12U);
  for (const Json& test : run.at("tests")) {
    EXPECT_EQ(test.at("stand_in"), test.at("test") == "drive") << test.at("moving");
  }
  EXPECT_EQ(compare(thesis({"--models", models, "--traversal", "e-node", "--descent", "larger",
                            "--rule", "spatial-median", "--test", "top"}),
                    others, "enode_larger"),
            3U);
}

TEST(ThesisGolden, AModelOfAFileIsTurnedUprightAndCountsAlike) {
  SOMS_NEEDS_OUTSIDE_DATA("6 rows of the golden tables by the command");
  const auto golden = golden_rows("thesis_traversal.csv");
  const auto others = golden_rows("other_objects.csv");
  for (const auto& [file, name] :
       {std::pair("bun_zipper_res4.ply", "bunny"), std::pair("venus.ply", "venus")}) {
    for (const char* const test : {"right", "left", "top"}) {
      const Json run =
          thesis({outside_data("ply")->string() + "/" + file, "--up", "y", "--test", test});
      ASSERT_EQ(run.at("tests").size(), 1U);
      const Key key{name, name, "soms", test, "enode_both"};
      Sums sums = sums_of(run.at("tests")[0]);
      Sums expected = golden.count(key) > 0 ? golden.at(key) : others.at(key);
      // Turning reverses an axis, so that other pairs of leaves come first; all else is alike.
      sums.back() = expected.back() = 0;
      EXPECT_EQ(sums, expected) << name << ", " << test;
    }
  }
}

TEST_F(Thesis, FindsInEveryFrameWhatOverlapFindsThere) {
  for (const char* const test : {"right", "top", "back", "drive"}) {
    const Json run = thesis({knot(), ball(), "--test", test});
    const Json& one = run.at("tests").at(0);
    std::string poses = "x,y,z\n";
    for (const Json& row : one.at("rows")) {
      const Json& at = row.at("offset");
      poses += shortest(at[0]) + "," + shortest(at[1]) + "," + shortest(at[2]) + "\n";
    }
    write_text(path("poses.csv"), poses);
    const RunResult overlap = soms_run(
        {"overlap",     knot(),     ball(),         "--pose-b", path("poses.csv"), "--json",
         "--no-pairs",  "--verify", "--rule",       "soms",     "--midpoint",      "thesis",
         "--leaf",      "1",        "--empty-side", "stop",     "--levels",        "15",
         "--traversal", "e-node",   "--quiet"});
    ASSERT_EQ(overlap.status, 0) << overlap.err;  // compared with brute force
    const std::vector<Json> answers = json_lines(overlap.out);
    ASSERT_EQ(answers.size(), one.at("rows").size());
    std::uint64_t contacts = 0;
    for (std::size_t k = 0; k < answers.size(); ++k) {
      const Json& row = one.at("rows")[k];
      EXPECT_EQ(row.at("contacts"), answers[k].at("count")) << test << ", frame " << k;
      contacts += answers[k].at("count").get<std::uint64_t>();
      if (std::string(test) != "drive") {  // whose scene has 13 levels
        const Json& cost = answers[k].at("cost");
        EXPECT_EQ(row.at("box_tests"), cost.at("node_tests"));
        for (const char* const name :
             {"entered", "leaf_pairs", "triangle_pairs", "first_tests", "triangle_tests"}) {
          EXPECT_EQ(row.at(name), cost.at(name)) << name;
        }
      }
    }
    EXPECT_EQ(one.at("last_contacts"), answers.back().at("count"));
    EXPECT_EQ(one.at("contacts"), contacts);
    EXPECT_GT(contacts, 0U) << test;
  }
}

TEST_F(Thesis, SumsItsFramesUp) {
  const Json run = thesis({knot(), "--test", "left"});
  EXPECT_EQ(run.at("schema"), "soms.thesis/1");
  const Json& one = run.at("tests").at(0);
  EXPECT_EQ(one.at("first_root_frame"), 32U);
  std::map<std::string, std::uint64_t> first;
  std::uint64_t box_tests = 0;
  std::vector<double> times;
  for (const Json& row : one.at("rows")) {
    const std::uint64_t k = row.at("frame");
    box_tests += row.at("box_tests").get<std::uint64_t>();
    if (row.at("root_overlap").get<bool>()) {
      times.push_back(row.at("collision_ms"));
    }
    if (row.at("leaf_pairs") > 0) {
      first.emplace("leaf", k);
    }
    if (row.at("contacts") > 0) {
      first.emplace("contact", k);
    }
  }
  EXPECT_EQ(one.at("box_tests"), box_tests);
  EXPECT_EQ(one.at("first_leaf_frame"), first.at("leaf"));
  EXPECT_EQ(one.at("first_contact_frame"), first.at("contact"));
  EXPECT_EQ(one.at("root_overlap_frames"), times.size());
  EXPECT_EQ(times.size(), 17U);
  const double mean = std::accumulate(times.begin(), times.end(), 0.0) / 17;
  std::sort(times.begin(), times.end());
  EXPECT_NEAR(one.at("mean_ms"), mean, 1e-9);
  EXPECT_EQ(one.at("median_ms"), times[8]);
  EXPECT_EQ(one.at("max_ms"), times[16]);
  EXPECT_NEAR(one.at("fps"), 1000 / mean, 1e-6 * 1000 / mean);
  const std::string word = 1000 / mean > 60 ? "above" : 1000 / mean < 30 ? "below" : "within";
  EXPECT_EQ(one.at("interactive"), word);
}

TEST_F(Thesis, RunsTheExperimentOfTheThesisOnStandIns) {
  const Json run = thesis({});
  std::map<std::string, std::string> tests;
  for (const Json& test : run.at("tests")) {
    tests[test.at("moving").at("name")] += test.at("test").get<std::string>() + " ";
    EXPECT_EQ(test.at("stand_in"), true);
    EXPECT_FALSE(test.at("first_root_frame").is_null());
  }
  const std::map<std::string, std::string> expected{{"bunny", "right left top bottom "},
                                                    {"venus", "right left top bottom "},
                                                    {"teapot", "right left top bottom "},
                                                    {"bunny500", "drive "}};
  EXPECT_EQ(tests, expected);
  EXPECT_EQ(run.at("tests").back().at("still").at("level"), 13U);
  EXPECT_EQ(run.at("options").at("levels"), 15);
  EXPECT_EQ(thesis({"--test", "all"}).at("tests").size(), 19U);
  EXPECT_EQ(thesis({"--test", "drive"}).at("tests").size(), 1U);
  EXPECT_EQ(thesis({"--test", "front"}).at("tests").size(), 3U);
}

TEST_F(Thesis, WritesItsFramesAsCsvAndItsDocumentToFiles) {
  const RunResult result =
      soms_run({"thesis", knot(), ball(), "--csv", path("a.csv"), "-o", path("b.csv"), "-o",
                path("c.json"), "--json", "--repeat", "1"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read_text(path("c.json")), result.out);
  EXPECT_EQ(read_text(path("a.csv")), read_text(path("b.csv")));
  const Json run = Json::parse(result.out);
  const auto rows = read_csv(path("a.csv"));
  ASSERT_EQ(rows.size(), 1 + 4 * 49U);
  const std::vector<std::string>& head = rows.front();
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Json& test = run.at("tests").at((i - 1) / 49);
    const Json& frame = test.at("rows").at((i - 1) % 49);
    ASSERT_EQ(rows[i].size(), head.size());
    EXPECT_EQ(rows[i][0], "knot");
    EXPECT_EQ(rows[i][1], "ball");
    EXPECT_EQ(rows[i][2], test.at("test"));
    for (std::size_t c = 0; c < head.size(); ++c) {
      if (const auto cell = frame.find(head[c]); cell != frame.end() && cell->is_number()) {
        EXPECT_EQ(std::stod(rows[i][c]), cell->get<double>()) << head[c];
      }
    }
  }
}

TEST_F(Thesis, PrintsATableOfFramesAndWhatItComesTo) {
  const RunResult some = soms_run({"thesis", knot(), "--test", "right", "--repeat", "1"});
  ASSERT_EQ(some.status, 0) << some.err;
  EXPECT_NE(some.out.find("comes from the right at its like"), std::string::npos) << some.out;
  EXPECT_NE(some.out.find("rule soms, midpoint thesis, empty side stop"), std::string::npos);
  EXPECT_NE(some.out.find("traversal e-node, descent both"), std::string::npos);
  EXPECT_NE(some.out.find("roots overlap first in frame 32"), std::string::npos);
  EXPECT_NE(some.out.find("the 30 to 60 that the thesis calls interactive"), std::string::npos);
  EXPECT_NE(some.out.find("\n     48"), std::string::npos);
  EXPECT_EQ(some.out.find("\n     31"), std::string::npos);
  const RunResult all =
      soms_run({"thesis", knot(), "--test", "right", "--frames", "all", "--repeat", "1"});
  EXPECT_NE(all.out.find("\n     31"), std::string::npos);
  const RunResult four = soms_run({"thesis", knot(), "--repeat", "1"});
  for (const char* const test : {"right", "left", "top", "bottom"}) {
    EXPECT_NE(four.out.find(std::string("knot   ") + test), std::string::npos) << four.out;
  }
  EXPECT_NE(four.out.find("of 4 tests, "), std::string::npos);
}

TEST_F(Thesis, TakesTheOptionsOfTrees) {
  const Json three = thesis({knot(), "--test", "right", "--level", "3"});
  EXPECT_EQ(three.at("tests")[0].at("still").at("level"), 3U);
  EXPECT_EQ(three.at("tests")[0].at("still").at("level_boxes"), 4U);
  const Json same = thesis({knot(), "--test", "right", "--levels", "3"});
  EXPECT_EQ(same.at("tests")[0].at("box_tests"), three.at("tests")[0].at("box_tests"));
  const Json fast = thesis({knot(), "--test", "right", "--rule", "fast", "--traversal", "larsson"});
  EXPECT_EQ(fast.at("options").at("rule"), "fast");
  EXPECT_EQ(fast.at("options").at("traversal"), "larsson");
  const Json usual = thesis({knot(), "--test", "right"});
  EXPECT_EQ(fast.at("tests")[0].at("contacts"), usual.at("tests")[0].at("contacts"));
  EXPECT_NE(fast.at("tests")[0].at("box_tests"), usual.at("tests")[0].at("box_tests"));
}

TEST_F(Thesis, NumbersLevelsFromThatOfTheRoot) {
  const Json from_0 = thesis({knot(), "--test", "right", "--level", "3", "--root-level", "0"});
  EXPECT_EQ(from_0.at("options").at("root_level"), 0);
  EXPECT_EQ(from_0.at("tests")[0].at("still").at("level"), 3);
  EXPECT_EQ(from_0.at("tests")[0].at("still").at("level_boxes"), 8U);
  const Json from_1 = thesis({knot(), "--test", "right", "--level", "4"});
  EXPECT_EQ(from_1.at("options").at("root_level"), 1);
  EXPECT_EQ(from_1.at("tests")[0].at("still").at("level"), 4);
  EXPECT_EQ(from_1.at("tests")[0].at("box_tests"), from_0.at("tests")[0].at("box_tests"));
  EXPECT_EQ(from_1.at("options").at("axis_from"), nullptr);
  EXPECT_EQ(from_1.at("options").at("c_vertex"), 2);
  const Json outer = thesis({knot(), "--test", "right", "--axis-from", "outer"});
  EXPECT_EQ(outer.at("options").at("axis_from"), "outer");
}

TEST_F(Thesis, WarnsOfUnitsThatMayDiffer) {
  const std::string meters = data("frames/duct.gltf").string();
  const std::vector<std::string> words{"thesis", knot(),   meters,     "--test",
                                       "right",  "--json", "--repeat", "1"};
  const RunResult result = soms_run(words);
  ASSERT_EQ(result.status, 0) << result.err;
  const Json warnings = Json::parse(result.out).at("warnings");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].at("kind"), "unit_unknown");
  EXPECT_NE(result.err.find("unit"), std::string::npos) << result.err;
  std::vector<std::string> strict = words;
  strict.emplace_back("--strict");
  EXPECT_EQ(soms_run(strict).status, 3);
  EXPECT_FALSE(thesis({knot(), ball(), "--test", "right"}).contains("warnings"));
}

TEST_F(Thesis, RefusesWhatItCannotDo) {
  const auto says = [&](std::vector<std::string> words, int status, const std::string& what) {
    const RunResult result = thesis_error(std::move(words));
    EXPECT_EQ(result.status, status) << what << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
  };
  says({knot(), "--test", "rihgt"}, 2, "did you mean right?");
  says({path("kont.ply")}, 3, "kont.ply");
  says({knot(), ball(), ball()}, 2, "");
  says({knot(), "--models", path("")}, 2, "--models has no effect beside A");
  says({"--up", "y"}, 2, "--up has no effect without A");
  says({knot(), "--scale-b", "2"}, 2, "--scale-b has no effect without B");
  says({knot(), "--traversal", "fast"}, 2, "--traversal fast");
  says({knot(), "--traversal", "larsson", "--descent", "larger"}, 2, "--descent has no effect");
  says({knot(), "--level", "3", "--levels", "3"}, 2, "--level");
  says({knot(), "-o", path("a.txt")}, 2, ".csv");
  says({"--models", path("nowhere")}, 3, "nowhere");
  write_text(path("empty.off"), "OFF\n0 0 0\n");
  says({path("empty.off")}, 3, "give a model with faces");
  says({knot(), path("empty.off")}, 3, "give a model with faces");
  const RunResult piped = soms_run({"thesis", "-", "--view"}, "OFF\n0 0 0\n");
  EXPECT_EQ(piped.status, 2) << piped.err;
}

TEST_F(Thesis, SaysWhichModelsOfAFolderAreMissing) {
  const RunResult result =
      soms_run({"thesis", "--models", path(""), "--test", "right", "--repeat", "1"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("bun_zipper_res4.ply is not in"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("stand-in"), std::string::npos) << result.out;
}

/// A script in the place of soms-view that writes its words and the picture that it is to draw.
std::string viewer_in(const fs::path& folder) {
  const fs::path path = folder / "viewer";
  write_text(path,
             "#!/bin/sh\necho \"$@\" >> '" + (folder / "said").string() +
                 "'\nwhile [ $# -gt 0 ]; do case $1 in --output) echo > \"$2\";; esac; shift; "
                 "done\nexit ${STATUS:-0}\n");
  fs::permissions(path, fs::perms::owner_all);
  return path.string();
}

TEST_F(Thesis, DrawsChosenFramesBySomsView) {
  const TemporaryFolder folder;
  const std::string line = "export SOMS_VIEW='" + viewer_in(folder.path()) + "'; $soms thesis '" +
                           knot() + "' --test right --repeat 1 --json --picture '" +
                           (folder.path() / "pictures").string() + "'";
  const RunResult result = shell(line);
  ASSERT_EQ(result.status, 0) << result.err;
  const Json run = Json::parse(result.out);
  const std::uint64_t contact = run.at("tests")[0].at("first_contact_frame");
  std::vector<std::string> expected{"knot_right_32.png", "knot_right_48.png",
                                    "knot_right_" + std::to_string(contact) + ".png"};
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(files_in(folder.path() / "pictures"), expected);
  const std::string said = read_text(folder.path() / "said");
  EXPECT_EQ(said.find("render"), 0U);
  for (const std::string& words :
       {knot() + " --mover " + knot(), std::string("--thesis --tree rule=soms,levels=15,leaf=1,"),
        std::string("traversal=e-node,descent=both "), std::string("--test right --frame 48"),
        std::string("--trace")}) {
    EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
  }
  EXPECT_EQ(shell("export STATUS=7; " + line).status, 7);
}

TEST_F(Thesis, OpensAWindowBySomsView) {
  const TemporaryFolder folder;
  const std::string call = "export SOMS_VIEW='" + viewer_in(folder.path()) + "'; $soms thesis ";
  EXPECT_EQ(
      shell(call + "'" + knot() + "' '" + ball() + "' --scale-b 0.5 --test top --level 4 --view")
          .status,
      0);
  const std::string said = read_text(folder.path() / "said");
  EXPECT_EQ(said.find("view " + knot() + " --mover " + ball()), 0U) << said;
  for (const char* const words : {"--mover-scale 0.5", "levels=4", "--test top --run"}) {
    EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
  }
  // Models that are made are written for it.
  EXPECT_EQ(shell(call + "--view").status, 0);
  EXPECT_NE(read_text(folder.path() / "said").find("bunny.ply --up y --mover-up y"),
            std::string::npos);
}

TEST_F(Thesis, NeedsSomsViewForPicturesAndWindows) {
  for (const char* const option : {"--view", "--picture pictures"}) {
    const RunResult result = shell("export SOMS_VIEW=/nowhere/soms-view; $soms thesis '" + knot() +
                                   "' --test right " + option);
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.err.find("SOMS_VIEW does not name a program"), std::string::npos)
        << result.err;
    EXPECT_EQ(result.out, "");
  }
}

}  // namespace
}  // namespace soms::test
