#include "tests/commands/near.h"
#include "tests/support/pipe.h"

#include <algorithm>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

const std::string kRays = "ox,oy,oz,dx,dy,dz\n";
const std::string kLimitedRays = "ox,oy,oz,dx,dy,dz,length\n";
const std::string kSegments = "x0,y0,z0,x1,y1,z1\n";

/// Asks about rays, or segments, beside the box [-1, 1]^3.
RunResult ask(const std::string& rows, std::vector<std::string> words = {}) {
  const bool segments = rows.find("x0") != std::string::npos;
  words.insert(words.begin(), {"ray", box(), segments ? "--segments" : "--rays", "-"});
  return soms_run(words, rows);
}

/// Answers of a run that must succeed and have nothing to remark, each a JSON object.
std::vector<Json> ray_answers(const std::string& rows, std::vector<std::string> words = {}) {
  words.emplace_back("--json");
  const RunResult result = ask(rows, std::move(words));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return json_lines(result.out);
}

std::vector<Json> hits_of(const std::vector<Json>& answers) {
  std::vector<Json> hits;
  for (const Json& answer : answers) {
    hits.push_back(answer.at("hit"));
  }
  return hits;
}

/// The bracket of t.
Json t_of(const Json& hit) {
  return Json::array({hit.at("lower"), hit.at("upper")});
}

TEST(RayVerb, AnswersInTheSchema) {
  const std::vector<Json> answers = ray_answers(kRays + "0.25,0.5,3,0,0,-1\n5,0,3,0,0,-1\n");
  ASSERT_EQ(answers.size(), 2U);
  const Json& hit = answers[0];
  EXPECT_EQ(hit.at("schema"), "soms.ray/2");
  EXPECT_EQ(hit.at("ray"), 0);
  EXPECT_EQ(hit.at("hit"), true);
  EXPECT_EQ(t_of(hit), Json({2, 2}));
  EXPECT_EQ(hit.at("point"), Json({0.25, 0.5, 1}));
  EXPECT_EQ(hit.at("front"), true);
  EXPECT_TRUE(hit.at("triangle").is_number_unsigned());
  EXPECT_EQ(hit.at("coverage"), "complete");
  for (const char* key : {"node_tests", "triangle_tests", "exact_tests"}) {
    EXPECT_TRUE(hit.at("cost").contains(key)) << key;
  }
  for (const char* key : {"hits", "count", "verified", "timed_out", "notes"}) {
    EXPECT_FALSE(hit.contains(key)) << key;
  }
  const Json& miss = answers[1];
  EXPECT_EQ(miss.at("ray"), 1);
  EXPECT_EQ(miss.at("hit"), false);
  EXPECT_EQ(t_of(miss), Json({nullptr, nullptr}));
  for (const char* key : {"triangle", "point", "front"}) {
    EXPECT_FALSE(miss.contains(key)) << key;
  }
}

TEST(RayVerb, CountsTInUnitsOfTheDirectionUpToTheLength) {
  const std::vector<Json> answers =
      ray_answers(kLimitedRays +
                  "0,0.5,3,0,0,-0.5,inf\n0,0.5,3,0,0,-2,1\n0,0.5,3,0,0,-2,0.999\n"
                  "0,0.5,1,0,0,1,0\n0,0.5,2,0,0,1,0\n");
  EXPECT_EQ(hits_of(answers), (std::vector<Json>{true, true, false, true, false}));
  EXPECT_EQ(t_of(answers[0]), Json({4, 4}));
  EXPECT_EQ(t_of(answers[1]), Json({1, 1}));
  EXPECT_EQ(t_of(answers[3]), Json({0, 0}));
}

TEST(RayVerb, HasSegmentsWithBothEnds) {
  const std::vector<Json> answers =
      ray_answers(kSegments +
                  "0,0.5,3,0,0.5,-1\n0,0.5,3,0,0.5,1\n0,0.5,3,0,0.5,2\n"
                  "0,0.5,1,0,0.5,1\n0,0,0,0.5,0,0\n");
  EXPECT_EQ(hits_of(answers), (std::vector<Json>{true, true, false, true, false}));
  EXPECT_EQ(t_of(answers[0]), Json({0.5, 0.5}));
  EXPECT_EQ(t_of(answers[1]), Json({1, 1}));
  EXPECT_EQ(answers[4].at("ray"), 4);
}

TEST(RayVerb, TakesColumnsInAnyOrder) {
  const Json answer =
      ray_answers("length,dz,dy,dx,oz,oy,ox\n\n# a remark\n9,-1,0,0,3,0.5,0.25\n").at(0);
  EXPECT_EQ(answer.at("point"), Json({0.25, 0.5, 1}));
  EXPECT_EQ(ray_answers("z1,y1,x1,x0,y0,z0\n0,0.5,0,0,0.5,3\n").at(0).at("point"),
            Json({0, 0.5, 1}));
}

TEST(RayVerb, SaysOnlyWhetherAnythingIsHit) {
  const std::vector<Json> answers =
      ray_answers(kRays + "0.25,0.5,3,0,0,-1\n5,0,3,0,0,-1\n", {"--any"});
  EXPECT_EQ(hits_of(answers), (std::vector<Json>{true, false}));
  for (const char* key : {"triangle", "point", "front", "hits"}) {
    EXPECT_FALSE(answers[0].contains(key)) << key;
  }
}

TEST(RayVerb, ListsAllPlacesOnRequest) {
  const std::vector<Json> answers = ray_answers(
      kRays + "0.25,0.5,3,0,0,-1\n0,0,3,0,0,-1\n-3,0.5,1,1,0,-0\n5,0,3,0,0,-1\n0,0,0,1,0,0\n",
      {"--all"});
  ASSERT_EQ(answers.size(), 5U);
  const Json& through = answers[0].at("hits");
  ASSERT_EQ(through.size(), 2U);
  EXPECT_EQ(t_of(through[0]), Json({2, 2}));
  EXPECT_EQ(through[0].at("kind"), "enter");
  EXPECT_EQ(through[0].at("triangles").size(), 1U);
  EXPECT_EQ(t_of(through[1]), Json({4, 4}));
  EXPECT_EQ(through[1].at("kind"), "leave");
  EXPECT_EQ(answers[0].at("count"), 2);
  const Json& diagonal = answers[1].at("hits");
  ASSERT_EQ(diagonal.size(), 2U) << "both halves of a side are one place";
  EXPECT_EQ(diagonal[0].at("triangles").size(), 2U);
  EXPECT_LT(diagonal[0].at("triangles")[0], diagonal[0].at("triangles")[1]);
  EXPECT_EQ(answers[1].at("count"), 4);
  int depth = 0;
  for (const Json& place : answers[2].at("hits")) {
    depth += place.at("kind") == "enter" ? 1 : place.at("kind") == "leave" ? -1 : 0;
  }
  EXPECT_EQ(depth, 0) << "along a side";
  EXPECT_EQ(answers[3].at("hit"), false);
  EXPECT_EQ(answers[3].at("hits"), Json::array());
  EXPECT_EQ(answers[3].at("count"), 0);
  EXPECT_EQ(answers[4].at("hits")[0].at("kind"), "leave") << "from inside";
}

TEST(RayVerb, SkipsATriangle) {
  const std::string ray = kRays + "0.25,0.5,1,0,0,-1\n";
  const Json on = ray_answers(ray).at(0);
  EXPECT_EQ(t_of(on), Json({0, 0}));
  const Json next =
      ray_answers(ray, {"--skip", std::to_string(on.at("triangle").get<int>())}).at(0);
  EXPECT_EQ(t_of(next), Json({2, 2}));
  EXPECT_EQ(next.at("front"), false);
  const RunResult none = ask(ray, {"--skip", "12"});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("12"), std::string::npos) << none.err;
}

TEST(RayVerb, FollowsThePose) {
  EXPECT_EQ(t_of(ray_answers(kRays + "0,0.5,9,0,0,-1\n", {"--pose", "0 0 4"}).at(0)), Json({4, 4}));
}

TEST(RayVerb, FailsIfSomethingIsHitOnRequest) {
  const std::string hit = kSegments + "5,5,5,6,6,6\n0,0,5,0,0,-5\n";
  const std::string free = kSegments + "5,5,5,6,6,6\n";
  for (const std::vector<std::string>& mode : {std::vector<std::string>{}, {"--any"}, {"--all"}}) {
    std::vector<std::string> words = mode;
    EXPECT_EQ(ask(hit, words).status, 0);
    words.insert(words.end(), {"--fail-if", "hit"});
    EXPECT_EQ(ask(hit, words).status, 1);
    EXPECT_EQ(ask(free, words).status, 0);
  }
}

TEST(RayVerb, PrintsATableForPeople) {
  const std::string rays = kRays + "0.25,0.5,3,0,0,-1\n5,0,3,0,0,-1\n";
  const RunResult first = ask(rays);
  EXPECT_NE(first.out.find("    ray  t                 triangle              side   at\n"
                           "      0  2                 "),
            std::string::npos)
      << first.out;
  EXPECT_NE(first.out.find("  front  (0.25, 0.5, 1)\n"
                           "      1  none\n"
                           "2 rays: 1 hit, 1 free\n"),
            std::string::npos)
      << first.out;
  EXPECT_EQ(ask(rays, {"--any"}).out,
            "    ray  hit\n"
            "      0  yes\n"
            "      1  no\n"
            "2 rays: 1 hit, 1 free\n");
  EXPECT_EQ(ask(rays, {"--all"}).out,
            "    ray  triangles  crossings\n"
            "      0          2  enter at 2, leave at 4\n"
            "      1          0\n"
            "2 rays: 1 hit, 1 free; 2 crossings, 2 triangles\n");
  EXPECT_EQ(ask(kSegments + "5,5,5,6,6,6\n", {"--any"}).out,
            "segment  hit\n"
            "      0  no\n"
            "1 segment: 0 hit, 1 free\n");
  std::string many = kRays;
  for (int i = 0; i < 3000; ++i) {
    many += "5,0,3,0,0,-1\n";
  }
  const RunResult result = ask(many, {"--any"});
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 23);
  EXPECT_NE(result.out.find("   and 2,980 rays more; --json lists all\n"), std::string::npos)
      << result.out;
}

TEST(RayVerb, WritesCsv) {
  const TemporaryFolder folder;
  const std::string csv = (folder.path() / "out.csv").string();
  const std::string rays = kRays + "0.25,0.5,3,0,0,-1\n5,0,3,0,0,-1\n";
  ASSERT_EQ(ask(rays, {"-o", csv}).status, 0);
  const auto first = read_csv(csv);
  ASSERT_EQ(first.size(), 3U);
  EXPECT_EQ(first[0].size(), 12U);
  EXPECT_EQ(first[1][1], "true");
  EXPECT_EQ(first[1][2], "2");
  EXPECT_EQ(first[1][10], "true");
  EXPECT_EQ(first[1][11], "complete");
  EXPECT_EQ(first[2][1], "false");
  EXPECT_EQ(first[2][2], "inf");
  EXPECT_EQ(first[2][4], "");
  ASSERT_EQ(ask(rays, {"--any", "-o", csv}).status, 0);
  EXPECT_EQ(read_text(csv), "ray,hit,coverage\n0,true,complete\n1,false,complete\n");
  ASSERT_EQ(ask(kRays + "0,0,3,0,0,-1\n", {"--all", "-o", csv}).status, 0);
  const auto all = read_csv(csv);
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[0].size(), 9U);
  EXPECT_EQ(all[1][1], "0");
  EXPECT_EQ(all[2][1], "0");
  EXPECT_EQ(all[3][1], "1");
  EXPECT_EQ(all[1][4], "enter");
  EXPECT_EQ(all[3][4], "leave");
}

TEST(RayVerb, VerifiesByBruteForce) {
  const TemporaryFolder folder;
  const std::string knot = (folder.path() / "knot.ply").string();
  ASSERT_EQ(soms_run({"generate", "knot", "--triangles", "500", "-o", knot}).status, 0);
  const std::string rays = file_of(folder, "r.csv",
                                   kLimitedRays +
                                       "0,0,9,0.1,0.1,-1,inf\n2,1,0.5,-1,-0.5,0,inf\n"
                                       "1e6,0,0,-1,0,0,inf\n-3,1e-9,2,1,0,-1,2.5\n");
  const std::string segments =
      file_of(folder, "s.csv", kSegments + "0,0,9,0,0,-9\n3,2,1,-3,-2,0\n");
  for (const std::vector<std::string>& mode :
       {std::vector<std::string>{}, {"--any"}, {"--all"}, {"--all", "--skip", "17"}}) {
    for (const auto& [option, file, count] :
         {std::tuple("--rays", rays, 4), std::tuple("--segments", segments, 2)}) {
      std::vector<std::string> words{
          "ray", knot, option, file, "--verify", "--pose", "0.1 0.2 0.3 0.8 0 0.6 0"};
      words.insert(words.end(), mode.begin(), mode.end());
      const RunResult result = soms_run(words);
      EXPECT_EQ(result.status, 0) << result.err;
      const std::string n = std::to_string(count);
      EXPECT_NE(result.out.find("verified by brute force: " + n + " of " + n + " answers equal\n"),
                std::string::npos)
          << result.out;
    }
  }
  EXPECT_EQ(ray_answers(kRays + "0.25,0.5,3,0,0,-1\n", {"--verify"}).at(0).at("verified"), true);
}

TEST(RayVerb, AnswersAlikeForAnyNumberOfThreads) {
  std::string rows = kRays;
  for (int k = 0; k < 2000; ++k) {
    rows += "3," + std::to_string(0.001 * k) + "," + std::to_string(k % 7) + ",-1,-0.25,-0.5\n";
  }
  for (const std::string mode : {"--any", "--all", "--allow-empty"}) {
    const RunResult one = ask(rows, {"--json", mode, "--threads", "1"});
    EXPECT_EQ(one.status, 0);
    EXPECT_EQ(ask(rows, {"--json", mode, "--threads", "3"}).out, one.out);
  }
}

TEST(RayVerb, NamesWhatIsWrongWithRows) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"",
       "standard input: no header and no rays; begin with ox,oy,oz,dx,dy,dz or "
       "ox,oy,oz,dx,dy,dz,length"},
      {"ox,oy,oz\n1,2,3\n", "line 1: the header \"ox,oy,oz\" is not known; begin with ox,oy"},
      {"ox,oy,oz,dx,dy,dz,id\n", "remove the column \"id\""},
      {kRays + "0,0,0,1,0\n", "line 2: 5 numbers, but the header has 6"},
      {kRays + "0,0,0,1,zero,0\n", "line 2: dy is \"zero\", not a number"},
      {kRays + "0,0,0,1,inf,0\n", "line 2: dy is \"inf\", not a finite number"},
      {kLimitedRays + "0,0,0,1,0,0,nan\n", "line 2: length is \"nan\", not a finite number"},
      {kRays + "0,0,0,1,0,0\n0,0,0,0,-0,0\n", "standard input: ray 1: the direction is zero"},
      {kLimitedRays + "0,0,0,1,0,0,-2\n", "ray 0: length is -2, which is negative"},
      {kRays + "0,1e200,0,1,0,0\n", "ray 0: oy exceeds 2^300"}};
  for (const auto& [rows, message] : cases) {
    const RunResult result = soms_run({"ray", box(), "--rays", "-", "--json"}, rows);
    EXPECT_EQ(result.status, 3) << rows;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  }
  const RunResult segment = ask(kSegments + "0,0,0,0,0,1e200\n");
  EXPECT_EQ(segment.status, 3);
  EXPECT_NE(segment.err.find("segment 0: z1 exceeds 2^300"), std::string::npos) << segment.err;
}

TEST(RayVerb, RefusesWrongUsage) {
  const auto expect_refused = [](const RunResult& result, int status, const std::string& text) {
    EXPECT_EQ(result.status, status);
    EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
  };
  const std::string ray = kRays + "0,0,0,1,0,0\n";
  expect_refused(soms_run({"ray", box()}), 2, "neither --rays nor --segments is given");
  expect_refused(soms_run({"ray", box(), "--rays", "a.csv", "--segments", "b.csv"}), 2, "both");
  expect_refused(ask(ray, {"--any", "--all"}), 2, "--any and --all");
  expect_refused(ask(ray, {"--skip", "-1"}), 2, "--skip");
  expect_refused(ask(ray, {"--fail-if", "miss"}), 2, "--fail-if");
  expect_refused(ask(ray, {"-o", "out.txt"}), 2, "-o out.txt; use one of the extensions .csv");
  expect_refused(ask(ray, {"--pose", "1 2"}), 2, "--pose");
  expect_refused(soms_run({"ray", "-", "--rays", "-"}, ray), 2, "standard input is given twice");
  expect_refused(soms_run({"ray", box(), "--rays", "/nowhere/r.csv"}), 3, "/nowhere/r.csv");
  expect_refused(soms_run({"ray", "/nowhere/m.ply", "--rays", "-"}, ray), 3, "/nowhere/m.ply");
}

TEST(RayVerb, AnswersTheRowsBeforeAFaultyOne) {
  const RunResult result = ask(kRays + "0,0,3,0,0,-1\n0,0,3,0,0,0\n", {"--json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(json_lines(result.out).size(), 1U);
}

TEST(RayVerb, HitsNothingOfAnEmptyModel) {
  const TemporaryFolder folder;
  const std::string empty = file_of(folder, "empty.off", "OFF\n0 0 0\n");
  const std::string rays = file_of(folder, "r.csv", kRays + "0,0,0,1,0,0\n");
  EXPECT_EQ(soms_run({"ray", empty, "--rays", rays}).status, 3);
  const RunResult result = soms_run({"ray", empty, "--rays", rays, "--allow-empty", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json_lines(result.out).at(0).at("hit"), false);
}

// A program that gives a ray and waits is answered before the next one.
TEST(RayVerb, StopsWhenTimeIsUpWithWhatItHas) {
  const TemporaryFolder folder;
  const RunResult result = run_with_time(
      [&](const std::string& seconds) {
        const EndlessPipe rays(folder.path() / seconds, "ox,oy,oz,dx,dy,dz", "0,0,3,0,0,-1");
        return soms_run({"ray", box(), "--rays", rays.path(), "--json", "--timeout", seconds});
      },
      [](const RunResult& run) { return !run.out.empty(); });
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("out of time after"), std::string::npos) << result.err;
  EXPECT_EQ(json_lines(result.out).at(0).at("hit"), true);
}

}  // namespace
}  // namespace soms::test
