#include "apps/soms/pairs/near_page.h"
#include "tests/commands/near.h"
#include "tests/report/reading.h"
#include "tests/support/pipe.h"

#include <cmath>
#include <csignal>
#include <limits>
#include <sstream>
#include <tuple>
#include <utility>

namespace soms::test {
namespace {

std::vector<Json> answers_within(const std::string& clearance, std::vector<std::string> words) {
  words.insert(words.end(), {"--clearance", clearance});
  return near_answers("within", std::move(words));
}

TEST(WithinVerb, AnswersInTheSchema) {
  const Json near = answers_within("1.5", {"--pose", "3.5 0 0"}).at(0);
  EXPECT_EQ(near.at("schema"), "soms.within/2");
  EXPECT_EQ(near.at("pose"), 0);
  EXPECT_EQ(near.at("within"), true);
  EXPECT_EQ(near.at("triangles").size(), 2U);
  EXPECT_EQ(near.at("point_a").at(0), 2.5);
  EXPECT_EQ(near.at("point_b").at(0), 1);
  EXPECT_EQ(near.at("coverage"), "complete");
  EXPECT_TRUE(near.at("cost").contains("node_tests"));
  EXPECT_EQ(near.at("at_least"), 0);
  const Json far = answers_within("1", {"--pose", "3.5 0 0"}).at(0);
  EXPECT_EQ(far.at("within"), false);
  EXPECT_GE(far.at("at_least").get<double>(), 1);
  EXPECT_LE(far.at("at_least").get<double>(), 1.5);
  EXPECT_FALSE(far.contains("triangles"));
  EXPECT_FALSE(far.contains("point_a"));
}

TEST(WithinVerb, DecidesExactly) {
  EXPECT_EQ(answers_within("1.4999999999999998", {"--pose", "3.5 0 0"}).at(0).at("within"), false);
  EXPECT_EQ(answers_within("1.5", {"--pose", "3.5 0 0"}).at(0).at("within"), true);
  // The root of 8 is no double: it lies between these two.
  EXPECT_EQ(answers_within("2.82842712474619", {"--pose", "4 4 0.5"}).at(0).at("within"), false);
  EXPECT_EQ(answers_within("2.8284271247461903", {"--pose", "4 4 0.5"}).at(0).at("within"), true);
  // Clearance 0 asks for overlap.
  EXPECT_EQ(answers_within("0", {"--pose", "2 0 0"}).at(0).at("within"), true);
  EXPECT_EQ(answers_within("0", {"--pose", "2.0000000000000004 0 0"}).at(0).at("within"), false);
}

TEST(WithinVerb, RoundsAClearanceToTheNearestDouble) {
  EXPECT_EQ(answers_within("1e-400", {"--pose", "2 0 0"}).at(0).at("within"), true);
  const Json apart = answers_within("1e-400", {"--pose", "2.5 0 0"}).at(0);
  EXPECT_EQ(apart.at("within"), false);
  EXPECT_EQ(answers_within("-0", {"--pose", "2.5 0 0"}).at(0), apart);
  EXPECT_FALSE(
      std::signbit(answers_within("-0", {"--pose", "2.5 0 0"}).at(0).at("at_least").get<double>()));
}

TEST(WithinVerb, IsAboutSurfaces) {
  EXPECT_EQ(answers_within("0.5", {"--scale", "0.5"}).at(0).at("within"), true);
  EXPECT_EQ(answers_within("0.4", {"--scale", "0.5"}).at(0).at("within"), false);
}

TEST(WithinVerb, NeedsAClearance) {
  const RunResult none = soms_run({"within", box(), box()});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("--clearance is required"), std::string::npos) << none.err;
  const std::vector<std::pair<const char*, const char*>> cases{
      {"-1", "--clearance -1; give a length of 0 or more"},
      {"nan", "--clearance nan; give a finite number"},
      {"inf", "--clearance inf; give a finite number"},
      {"1,5", "--clearance 1,5; give a finite number, with a decimal point"},
      {"", "--clearance ; give a finite number"}};
  for (const auto& [value, message] : cases) {
    const RunResult result = soms_run({"within", box(), box(), "--clearance", value});
    EXPECT_EQ(result.status, 2) << value;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

TEST(WithinVerb, NamesThePairForPeople) {
  const TwoWalls walls;
  const RunResult near = soms_run({"within", walls.a, walls.b, "--clearance", "1.5"});
  EXPECT_EQ(near.out, "within 1.5: triangle 1 (near) of " + walls.a +
                          " at (1, 1, 0) and triangle 0 of " + walls.b + " at (1, 1, 1)\n");
  EXPECT_TRUE(soms_run({"within", walls.a, walls.b, "--clearance", "0.5"})
                  .out.starts_with("not within 0.5: the distance is "));
}

TEST(WithinVerb, FailsOnRequestWhereTheClearanceIsNotKept) {
  const auto status = [](const std::string& clearance, const std::string& pose) {
    return soms_run({"within", box(), box(), "--clearance", clearance, "--pose", pose, "--fail-if",
                     "within"})
        .status;
  };
  EXPECT_EQ(status("3", "5 0 0"), 1);
  EXPECT_EQ(status("2", "5 0 0"), 0);
  EXPECT_EQ(soms_run({"within", box(), box(), "--clearance", "1", "--fail-if", "overlap"}).status,
            2);
}

// "Not within" is no proof that the clearance is kept where rows are left.
TEST(WithinVerb, DoesNotPassWhenTimeIsUp) {
  const TemporaryFolder folder;
  const RunResult result = run_with_time(
      [&](const std::string& seconds) {
        const EndlessPipe poses(folder.path() / seconds, "x,y,z", "5,0,0");
        return soms_run({"within", box(), box(), "--clearance", "2", "--pose", poses.path(),
                         "--fail-if", "within", "--timeout", seconds});
      },
      [](const RunResult& run) { return !run.out.empty(); });
  EXPECT_EQ(result.status, 4) << result.err;
  EXPECT_NE(result.err.find("out of time after"), std::string::npos) << result.err;
}

TEST(WithinVerb, OfAnEmptyModelIsFalse) {
  const std::string empty = data("nasty/empty_mesh.ply").string();
  const RunResult result =
      soms_run({"within", empty, box(), "--allow-empty", "--clearance", "9", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json_lines(result.out).at(0).at("within"), false);
  EXPECT_TRUE(json_lines(result.out).at(0).at("at_least").is_null());
  EXPECT_EQ(soms_run({"within", empty, box(), "--allow-empty", "--clearance", "9"}).out,
            "not within 9: a model has no triangles\n");
}

TEST(WithinVerb, AnswersRowsOfPoses) {
  const TemporaryFolder folder;
  const std::string poses = file_of(folder, "poses.csv", "x,y,z\n5,0,0\n2.5,0,0\n0.5,0,0\n9,0,0\n");
  const std::vector<Json> answers = answers_within("1", {"--pose", poses});
  ASSERT_EQ(answers.size(), 4U);
  for (std::size_t k = 0; k < answers.size(); ++k) {
    EXPECT_EQ(answers[k].at("pose"), k);
    EXPECT_EQ(answers[k].at("within"), k == 1 || k == 2) << k;
  }
  const std::string csv = (folder.path() / "answers.csv").string();
  const RunResult text =
      soms_run({"within", box(), box(), "--clearance", "1", "--pose", poses, "-o", csv});
  EXPECT_TRUE(
      text.out.starts_with("  pose  within 1          triangle of A         triangle of B\n"
                           "     0  no\n     1  yes               "))
      << text.out;
  EXPECT_TRUE(text.out.ends_with("4 poses: 2 within 1 (the first at pose 1), 2 not\n")) << text.out;
  const std::string table = read_text(csv);
  EXPECT_TRUE(table.starts_with("pose,within,at_least,triangle_a,")) << table;
  EXPECT_NE(table.find("\n1,true,0,"), std::string::npos) << table;
}

TEST(WithinVerb, VerifiesByBruteForce) {
  EXPECT_EQ(answers_within("1.5", {"--verify", "--pose", "3.5 0 0"}).at(0).at("verified"), true);
  EXPECT_EQ(answers_within("1", {"--verify", "--pose", "3.5 0 0"}).at(0).at("verified"), true);
}

/// Two parallel triangles at z = 0, one of each model, so that the pair that is named is known; and
/// poses that lift the first.
struct TwoSheets {
  TemporaryFolder folder;
  std::string sheet = file_of(folder, "sheet.off", triangle_off("0 0 0", "1 0 0", "0 1 0"));
  std::string poses = file_of(folder, "p.csv", "x,y,z\n0,0,3\n0,0,1\n0,0,0\n0,0,0.25\n");
  std::string page = (folder.path() / "page.html").string();
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(WithinVerb, DrawsThePairThatProvesItOnItsPage) {
  const TwoSheets sheets;
  const RunResult result = soms_run({"within", sheets.sheet, sheets.sheet, "--clearance", "1",
                                     "--pose", sheets.poses, "-o", sheets.page});
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string page = read_text(sheets.page);
  const Json scene = scene_of(page);
  EXPECT_EQ(scene["gaps"]["lengths"], (std::vector<std::string>{"0", "0.25", "1"}))
      << "the nearest first; a pose that is not within has none";
  EXPECT_EQ(scene["gaps"]["all"], 3);
  const std::vector<std::uint32_t> words = words_of(element(page, "gaps"));
  const std::vector<float> floats = floats_of(element(page, "gaps"));
  ASSERT_EQ(words.size(), 3U * 26U);
  const double origin = scene["origin"][2];
  for (const auto& [gap, pose, z] : {std::tuple(0U, 2U, 0.0), {1U, 3U, 0.25}, {2U, 1U, 1.0}}) {
    EXPECT_EQ(words[26 * gap + 4], pose);
    EXPECT_NEAR(origin + static_cast<double>(floats[26 * gap + 7]), z, 1e-5);
    EXPECT_NEAR(origin + static_cast<double>(floats[26 * gap + 10]), 0, 1e-5);
  }
  EXPECT_EQ(scene["contacts"]["all"], 0);
  EXPECT_TRUE(contains(page, "<section id=\"view\" class=\"touches no-list\">"))
      << "what touches without being named is not known";
  EXPECT_EQ(scene["complete"], true);
  EXPECT_TRUE(contains(page, "<tr><td><a href=\"#gap=2\">1</a></td><td>yes, at most 1</td>"));
  EXPECT_TRUE(contains(page, "<tr><td>0</td><td>no, at least 1</td>")) << "a pose without a line";
  EXPECT_TRUE(contains(page, "<dd>4 poses: 3 within 1 (the first at pose 1), 1 not</dd>"));
  EXPECT_TRUE(contains(page, "<dt>poses</dt><dd>4: 3 within 1, 1 not</dd>"));
  EXPECT_TRUE(contains(page, "within 1 by pose"));
}

TEST(WithinVerb, SaysOnItsPageWhatIsApart) {
  const TwoSheets sheets;
  ASSERT_EQ(soms_run({"within", sheets.sheet, sheets.sheet, "--clearance", "2", "--pose", "0 0 3",
                      "-o", sheets.page})
                .status,
            0);
  const std::string page = read_text(sheets.page);
  EXPECT_EQ(scene_of(page)["gaps"]["all"], 0);
  EXPECT_TRUE(contains(page, "<dd>not within 2: the distance is more than that</dd>"));
  EXPECT_TRUE(contains(page, "<tr><td>0</td><td>no, at least 2</td>"));
  EXPECT_FALSE(contains(page, "within 2 by pose")) << "a plot of one pose";
}

// The square of this length is no double.
TEST(WithinVerb, ShowsATinyLength) {
  const TwoSheets sheets;
  ASSERT_EQ(soms_run({"within", sheets.sheet, sheets.sheet, "--clearance", "1", "--pose",
                      "0 0 1e-200", "-o", sheets.page})
                .status,
            0);
  EXPECT_TRUE(contains(read_text(sheets.page), "<td>yes, at most 1e-200</td>"));
}

TEST(WithinVerb, ListsAsManyPosesAsItsPageHasRoomFor) {
  const TwoSheets sheets;
  std::string rows = "x,y,z\n";
  for (int k = 0; k < 1500; ++k) {
    rows += k % 3 == 0 ? "0,0,0.5\n" : "0,0,7\n";
  }
  ASSERT_EQ(soms_run({"within", sheets.sheet, sheets.sheet, "--clearance", "1", "--pose",
                      file_of(sheets.folder, "many.csv", rows), "-o", sheets.page})
                .status,
            0);
  const std::string page = read_text(sheets.page);
  EXPECT_EQ(scene_of(page)["gaps"]["all"], 500);
  EXPECT_TRUE(contains(page, "1,000 of 1,500 poses. Poses within the clearance come first"));
  EXPECT_TRUE(contains(page, "<tr><td>749</td><td>no, at least 1</td>"));
  EXPECT_FALSE(contains(page, "<tr><td>751</td>"));
  EXPECT_TRUE(contains(page, "at another pose, in 2 poses each."));
}

TEST(WithinVerb, RefusesAPageThatIsAnotherFile) {
  const TwoSheets sheets;
  const auto status = [&](const std::string& page, const std::string& csv) {
    return soms_run(
               {"within", sheets.sheet, sheets.sheet, "--clearance", "1", "-o", page, "-o", csv})
        .status;
  };
  EXPECT_EQ(status(sheets.page, sheets.page + ".html"), 2);
  EXPECT_EQ(status(sheets.page + ".svg", sheets.page + ".csv"), 2);
  EXPECT_NE(status(sheets.page + "/no/page.html", sheets.page + ".csv"), 0);
}

// A pose that time cut short, and a model without triangles: neither has a pair.
TEST(NearPage, SaysWhatItDoesNotKnow) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const command::PairReport report{.a = mesh, .b = mesh};
  command::NearPage page(
      {{Shape(mesh)}, "a", {Shape(mesh)}, "b"},
      {.column = "within 1", .named = "yes, at most ", .apart = "no, at least "});
  page.add({}, {.at_least = 0.25, .coverage = Coverage::cut});
  page.add({}, {.at_least = std::numeric_limits<double>::infinity()});
  std::ostringstream out;
  page.write(out, report, {.rows = 2, .undecided = 1}, "answer");
  EXPECT_TRUE(contains(out.str(), "<td>undecided, at least 0.25</td>"));
  EXPECT_TRUE(contains(out.str(), "<td>no: a model has no triangles</td>"));
  EXPECT_EQ(scene_of(out.str())["complete"], false);
}

TEST(WithinVerb, WarnsOfGapsBeyondTheClearance) {
  const RunResult far =
      soms_run({"within", box(), box(), "--clearance", "5", "--pose", "90 0 0", "--json"});
  EXPECT_EQ(json_lines(far.out).at(0).at("warnings").at(0).at("kind"), "boxes_apart");
  EXPECT_NE(far.err.find("warning: the boxes of "), std::string::npos) << far.err;
  const RunResult expected =
      soms_run({"within", box(), box(), "--clearance", "88", "--pose", "90 0 0", "--json"});
  EXPECT_FALSE(json_lines(expected.out).at(0).contains("warnings"));
  EXPECT_EQ(expected.err, "");
}

TEST(WithinVerb, EndsCleanlyWhenInterrupted) {
  const TemporaryFolder folder;
  const EndlessPipe poses(folder.path() / "poses", "x,y,z", "5,0,0");
  Child child({command().string(), "within", box(), box(), "--clearance", "1", "--pose",
               poses.path(), "--json"},
              folder.path());
  ASSERT_TRUE(child.wait_for_output(100'000));
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  EXPECT_FALSE(json_lines(result.out).empty());
  EXPECT_NE(result.err.find("soms within: "), std::string::npos) << result.err;
}

TEST(WithinVerb, IsWhatOverlapAsksWithAClearance) {
  const TemporaryFolder folder;
  const std::string poses = file_of(folder, "poses.csv", "x,y,z\n5,0,0\n2.5,0,0\n0.5,0,0\n");
  for (const char* form : {"--json", "--quiet", "--verify"}) {
    EXPECT_EQ(soms_run({"overlap", box(), box(), "--clearance", "1", "--pose", poses, form}).out,
              soms_run({"within", box(), box(), "--clearance", "1", "--pose", poses, form}).out);
  }
  const std::string page = (folder.path() / "page.html").string();
  ASSERT_EQ(
      soms_run({"overlap", box(), box(), "--clearance", "1", "--pose", poses, "-o", page}).status,
      0);
  EXPECT_NE(read_text(page).find("3 poses: 2 within 1 (the first at pose 1), 1 not"),
            std::string::npos);
  const auto status = [](std::vector<std::string> words) {
    words.insert(words.begin(), {"overlap", box(), box(), "--pose", "5 0 0"});
    return soms_run(words).status;
  };
  EXPECT_EQ(status({"--clearance", "3", "--fail-if", "within"}), 1);
  EXPECT_EQ(status({"--clearance", "2", "--fail-if", "within"}), 0);
}

TEST(WithinVerb, RefusesWhatOverlapCannotAskWithAClearance) {
  const std::vector<std::vector<std::string>> cases{{"--any"},
                                                    {"--first"},
                                                    {"--all"},
                                                    {"--limit", "3"},
                                                    {"--no-pairs"},
                                                    {"--by", "part"},
                                                    {"--tree", "descent=both"},
                                                    {"--tree", "traversal=a-first"},
                                                    {"--fail-if", "overlap"}};
  for (std::vector<std::string> words : cases) {
    words.insert(words.begin(), {"overlap", box(), box(), "--clearance", "1"});
    const RunResult result = soms_run(words);
    EXPECT_EQ(result.status, 2) << words[5];
    EXPECT_NE(result.err.find("--clearance"), std::string::npos) << result.err;
  }
  const RunResult idle = soms_run({"overlap", box(), box(), "--fail-if", "within"});
  EXPECT_EQ(idle.status, 2);
  EXPECT_NE(idle.err.find("also give --clearance D"), std::string::npos) << idle.err;
  EXPECT_EQ(soms_run({"overlap", box(), box(), "--clearance", "-1"}).status, 2);
}

}  // namespace
}  // namespace soms::test
