#include "tests/commands/near.h"
#include "tests/support/pipe.h"

#include <cmath>
#include <csignal>
#include <limits>
#include <string>
#include <vector>

namespace soms::test {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Asks about points beside the box [-1, 1]^3.
RunResult ask_about(const std::string& rows, std::vector<std::string> words) {
  words.insert(words.begin(), {"closest", box(), "--points", "-"});
  return soms_run(words, "x,y,z\n" + rows);
}

/// Answers of a run that must succeed and have nothing to remark, each a JSON object.
std::vector<Json> closest_answers(const std::string& rows, std::vector<std::string> words = {}) {
  words.emplace_back("--json");
  const RunResult result = ask_about(rows, std::move(words));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return json_lines(result.out);
}

TEST(ClosestVerb, AnswersInTheSchema) {
  const Json answer = closest_answers("0.25,0.5,3\n").at(0);
  EXPECT_EQ(answer.at("schema"), "soms.closest/2");
  EXPECT_EQ(answer.at("row"), 0);
  EXPECT_EQ(answer.at("lower"), 2);
  EXPECT_EQ(answer.at("upper"), 2);
  EXPECT_EQ(answer.at("point"), Json({0.25, 0.5, 1}));
  EXPECT_EQ(answer.at("feature"), "face");
  EXPECT_TRUE(answer.at("triangle").is_number_unsigned());
  EXPECT_EQ(answer.at("coverage"), "complete");
  for (const char* key : {"node_tests", "triangle_tests", "exact_tests"}) {
    EXPECT_TRUE(answer.at("cost").contains(key)) << key;
  }
  for (const char* key : {"hits", "verified", "timed_out", "notes"}) {
    EXPECT_FALSE(answer.contains(key)) << key;
  }
}

TEST(ClosestVerb, SaysOnWhichSideWhereRequested) {
  const std::string rows = "0,0,0.5\n0,0,3\n0,0,1\n";
  const std::vector<Json> answers = closest_answers(rows, {"--signed", "--verify"});
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].at("side"), "inside");
  EXPECT_EQ(answers[0].at("lower"), 0.5);
  EXPECT_EQ(answers[0].at("verified"), true);
  EXPECT_EQ(answers[1].at("side"), "outside");
  EXPECT_EQ(answers[2].at("side"), "on");
  EXPECT_FALSE(closest_answers(rows).at(0).contains("side"));
  EXPECT_EQ(ask_about("0,0,0.5\n", {"--signed"}).out.rfind("distance 0.5, inside: triangle ", 0),
            0U);
  EXPECT_EQ(ask_about("0,0,0\n", {"--signed", "--at-most", "0.25"}).out,
            "farther than 0.25, inside\n");
  const TemporaryFolder folder;
  const std::string csv = (folder.path() / "a.csv").string();
  EXPECT_EQ(ask_about(rows, {"--signed", "-o", csv}).status, 0);
  const auto table = read_csv(csv);
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table[0].back(), "side");
  EXPECT_EQ(table[1].back(), "inside");
  EXPECT_EQ(table[3].back(), "on");
}

TEST(ClosestVerb, NeedsAClosedModelForSidesAndNoList) {
  const TemporaryFolder folder;
  const std::string sheet = file_of(folder, "sheet.off", triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const RunResult open =
      soms_run({"closest", sheet, "--points", "-", "--signed"}, "x,y,z\n0,0,1\n");
  EXPECT_EQ(open.status, 3);
  EXPECT_NE(open.err.find("3 edges belong to an odd number"), std::string::npos) << open.err;
  EXPECT_NE(open.err.find("leave out --signed"), std::string::npos) << open.err;
  EXPECT_EQ(ask_about("0,0,0\n", {"--signed", "--nearest", "2"}).status, 2);
}

TEST(ClosestVerb, NamesFeatures) {
  const std::vector<Json> answers = closest_answers("3,0.25,3\n2,2,2\n1,1,1\n");
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].at("feature"), "edge");
  EXPECT_EQ(answers[1].at("feature"), "vertex");
  EXPECT_EQ(answers[1].at("point"), Json({1, 1, 1}));
  const double lower = answers[1].at("lower");
  EXPECT_EQ(answers[1].at("upper").get<double>(), std::nextafter(lower, kEndless));
  EXPECT_EQ(answers[2].at("upper"), 0);
  EXPECT_EQ(answers[2].at("row"), 2);
}

TEST(ClosestVerb, FollowsThePose) {
  EXPECT_EQ(closest_answers("0,0,0\n", {"--pose", "4 0 0"}).at(0).at("lower"), 3);
}

TEST(ClosestVerb, SaysFarther) {
  const std::vector<Json> answers = closest_answers("0,0,3\n0,0,9\n", {"--at-most", "2"});
  EXPECT_EQ(answers.at(0).at("farther"), false);
  EXPECT_EQ(answers.at(1).at("farther"), true);
  EXPECT_EQ(answers.at(1).at("lower"), 2);
  for (const char* key : {"triangle", "point", "feature"}) {
    EXPECT_FALSE(answers.at(1).contains(key)) << key;
  }
}

TEST(ClosestVerb, ListsTheNearestTriangles) {
  const std::vector<Json> answers = closest_answers("0,0,3\n0,0,0\n", {"--nearest", "3"});
  const Json& hits = answers.at(0).at("hits");
  ASSERT_EQ(hits.size(), 3U);
  EXPECT_EQ(hits[0].at("lower"), 2);
  EXPECT_EQ(hits[1].at("lower"), 2) << "both halves of a side";
  EXPECT_LT(hits[0].at("triangle"), hits[1].at("triangle"));
  EXPECT_GT(hits[2].at("lower"), 2);
  EXPECT_FALSE(answers.at(0).contains("lower"));
  EXPECT_EQ(answers.at(1).at("hits").size(), 3U);
  EXPECT_EQ(
      closest_answers("0,0,3\n", {"--nearest", "3", "--at-most", "2"}).at(0).at("hits").size(), 2U);
}

TEST(ClosestVerb, ListsAllTrianglesWithinARadius) {
  EXPECT_EQ(closest_answers("0,0,0\n", {"--radius", "1"}).at(0).at("hits").size(), 12U);
  EXPECT_EQ(closest_answers("0,0,0\n", {"--radius", "0.5"}).at(0).at("hits").size(), 0U);
  EXPECT_EQ(closest_answers("0,0,0\n", {"--radius", "1", "--nearest", "5"}).at(0).at("hits").size(),
            5U);
}

TEST(ClosestVerb, PrintsASentenceOrATable) {
  const RunResult one = ask_about("0.25,0.5,3\n", {});
  EXPECT_NE(one.out.find("distance 2: triangle "), std::string::npos) << one.out;
  EXPECT_NE(one.out.find("at (0.25, 0.5, 1), inside its face\n"), std::string::npos) << one.out;
  const RunResult many = ask_about("0,0,3\n0,0,1\n0,0,9\n", {"--at-most", "2"});
  EXPECT_NE(many.out.find("3 points: the least distance is 0 at point 1; "
                          "1 on the surface; 1 farther than 2\n"),
            std::string::npos)
      << many.out;
  EXPECT_NE(ask_about("0,0,3\n", {"--nearest", "2"}).out.find("2 triangles\n"), std::string::npos);
}

TEST(ClosestVerb, WritesCsv) {
  const TemporaryFolder folder;
  const std::string csv = (folder.path() / "out.csv").string();
  ASSERT_EQ(ask_about("0,0,3\n0,0,9\n", {"--at-most", "2", "-o", csv}).status, 0);
  const auto rows = read_csv(csv);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].size(), 12U);
  EXPECT_EQ(rows[1][1], "2");
  EXPECT_EQ(rows[1][10], "edge") << "above a diagonal";
  EXPECT_EQ(rows[1][11], "complete");
  EXPECT_EQ(rows[2][3], "true");
  EXPECT_EQ(rows[2][4], "");
  ASSERT_EQ(ask_about("0,0,3\n0,0,9\n", {"--nearest", "2", "-o", csv}).status, 0);
  EXPECT_EQ(read_csv(csv).size(), 5U);
}

TEST(ClosestVerb, VerifiesByBruteForce) {
  const TemporaryFolder folder;
  const std::string knot = (folder.path() / "knot.ply").string();
  ASSERT_EQ(soms_run({"generate", "knot", "--triangles", "500", "-o", knot}).status, 0);
  const std::string points =
      file_of(folder, "p.csv", "x,y,z\n0,0,0\n2,1,0.5\n1e6,0,0\n-3,1e-9,2\n");
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"--nearest", "7"}, {"--radius", "2"}, {"--at-most", "1.5"}}) {
    std::vector<std::string> words{
        "closest", knot, "--points", points, "--verify", "--pose", "0.1 0.2 0.3 0.8 0 0.6 0"};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult result = soms_run(words);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("verified by brute force: 4 of 4 answers equal\n"), std::string::npos)
        << result.out;
  }
}

TEST(ClosestVerb, AnswersAlikeForAnyNumberOfThreads) {
  std::string rows;
  for (int k = 0; k < 2000; ++k) {
    rows += std::to_string(0.01 * k) + "," + std::to_string(k % 7) + ",0.5\n";
  }
  const RunResult one = ask_about(rows, {"--json", "--threads", "1"});
  EXPECT_EQ(one.status, 0);
  EXPECT_EQ(ask_about(rows, {"--json", "--threads", "3"}).out, one.out);
}

TEST(ClosestVerb, RefusesBadInput) {
  const auto expect_refused = [](const RunResult& result, int status, const std::string& text) {
    EXPECT_EQ(result.status, status);
    EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
  };
  expect_refused(soms_run({"closest", box()}), 2, "--points");
  expect_refused(soms_run({"closest", box(), "--points", "-"}, "a,b\n1,2\n"), 3, "x,y,z");
  expect_refused(soms_run({"closest", box(), "--points", "-"}, ""), 3, "x,y,z");
  expect_refused(ask_about("1,2\n", {}), 3, "line 2");
  expect_refused(ask_about("1,2,nan\n", {}), 3, "line 2");
  expect_refused(ask_about("0,0,0\n1e300,0,0\n", {}), 3, "point 1: x exceeds 2^300");
  expect_refused(ask_about("0,0,0\n", {"--radius", "-1"}), 2, "--radius");
  expect_refused(ask_about("0,0,0\n", {"--radius", "1", "--at-most", "2"}), 2, "--at-most");
  expect_refused(ask_about("0,0,0\n", {"--nearest", "0"}), 2, "--nearest");
  expect_refused(ask_about("0,0,0\n", {"--pose", "1 2"}), 2, "--pose");
  expect_refused(soms_run({"closest", "-", "--points", "-"}), 2, "standard input is given twice");
  expect_refused(soms_run({"closest", box(), "--points", "/nowhere/p.csv"}), 3, "/nowhere/p.csv");
}

TEST(ClosestVerb, AnswersTheRowsBeforeAFaultyOne) {
  const RunResult result = ask_about("0,0,3\n0,0\n", {"--json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(json_lines(result.out).size(), 1U);
}

TEST(ClosestVerb, AcceptsAnEmptyModelWhereAllowed) {
  const TemporaryFolder folder;
  const std::string empty = file_of(folder, "empty.off", "OFF\n0 0 0\n");
  const std::string points = file_of(folder, "p.csv", "x,y,z\n0,0,0\n");
  EXPECT_EQ(soms_run({"closest", empty, "--points", points}).status, 3);
  const RunResult result =
      soms_run({"closest", empty, "--points", points, "--allow-empty", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(json_lines(result.out).at(0).at("lower").is_null());
}

}  // namespace
}  // namespace soms::test
