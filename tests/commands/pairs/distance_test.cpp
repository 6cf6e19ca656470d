#include "apps/soms/pairs/distance_verify.h"
#include "tests/commands/near.h"
#include "tests/report/reading.h"
#include "tests/support/pipe.h"

#include <cmath>
#include <csignal>
#include <limits>
#include <tuple>
#include <utility>

namespace soms::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Json> distances(std::vector<std::string> words) {
  return near_answers("distance", std::move(words));
}

TEST(DistanceVerb, AnswersInTheSchema) {
  const Json answer = distances({"--pose", "5 0 0"}).at(0);
  EXPECT_EQ(answer.at("schema"), "soms.distance/2");
  EXPECT_EQ(answer.at("pose"), 0);
  EXPECT_EQ(answer.at("lower"), 3);
  EXPECT_EQ(answer.at("upper"), 3);
  EXPECT_EQ(answer.at("coverage"), "complete");
  EXPECT_EQ(answer.at("triangles").size(), 2U);
  // Of A, which was moved, then of B, both in the world.
  EXPECT_EQ(answer.at("point_a").at(0), 4);
  EXPECT_EQ(answer.at("point_b").at(0), 1);
  EXPECT_EQ(answer.at("point_a").at(1), answer.at("point_b").at(1));
  EXPECT_EQ(answer.at("point_a").at(2), answer.at("point_b").at(2));
  for (const char* key : {"node_tests", "triangle_tests", "exact_tests"}) {
    EXPECT_TRUE(answer.at("cost").contains(key)) << key;
  }
  for (const char* key : {"verified", "timed_out", "notes", "warnings"}) {
    EXPECT_FALSE(answer.contains(key)) << key;
  }
}

TEST(DistanceVerb, GivesTheDoublesNextToADistanceThatIsNone) {
  const Json answer = distances({"--pose", "4 4 0.5"}).at(0);  // the root of 8
  const double lower = answer.at("lower");
  const double upper = answer.at("upper");
  EXPECT_LE(lower, std::sqrt(8.0));
  EXPECT_GE(upper, std::sqrt(8.0));
  EXPECT_LE(upper, std::nextafter(lower, kInfinity));
}

TEST(DistanceVerb, WritesNumbersThatReadBackExactly) {
  const TemporaryFolder folder;
  for (const double x : {0.1, 1.0 / 3, 1e-3, 12345678.901234567, std::nextafter(1.0, 2)}) {
    const std::string tip = Json(x).dump() + " 0 0";
    const std::string a = file_of(folder, "a.off", triangle_off("0 0 0", "-1 0 0", "-1 1 0"));
    const std::string b = file_of(folder, "b.off", triangle_off(tip, tip, tip));
    const RunResult result = soms_run({"distance", a, b, "--json"});
    const Json answer = json_lines(result.out).at(0);
    EXPECT_EQ(answer.at("lower").get<double>(), x) << result.out;
    EXPECT_EQ(answer.at("upper").get<double>(), x) << result.out;
    EXPECT_EQ(answer.at("point_b").at(0).get<double>(), x) << result.out;
  }
}

TEST(DistanceVerb, DrawsTheNearestPointsOnItsPage) {
  const TemporaryFolder folder;
  const std::string poses = file_of(folder, "p.csv", "x,y,z\n5,0,0\n2,0,0\n3,0,0\n9,0,0\n");
  const std::string path = (folder.path() / "page.html").string();
  const RunResult result =
      soms_run({"distance", box(), box(), "--pose", poses, "--at-most", "6", "-o", path});
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string page = read_text(path);
  const Json scene = scene_of(page);
  EXPECT_EQ(scene["gaps"]["lengths"], (std::vector<std::string>{"0", "1", "3"}))
      << "the nearest first; what is farther has none";
  EXPECT_EQ(scene["gaps"]["all"], 3);
  const std::vector<std::uint32_t> words = words_of(element(page, "gaps"));
  const std::vector<float> floats = floats_of(element(page, "gaps"));
  ASSERT_EQ(words.size(), 3U * 26U);
  for (const auto& [gap, pose, from, to] : {std::tuple(1U, 2U, 2.0, 1.0), {2U, 0U, 4.0, 1.0}}) {
    EXPECT_EQ(words[26 * gap + 4], pose);
    const double origin = scene["origin"][0];
    EXPECT_NEAR(origin + static_cast<double>(floats[26 * gap + 5]), from, 1e-5);
    EXPECT_NEAR(origin + static_cast<double>(floats[26 * gap + 8]), to, 1e-5);
  }
  EXPECT_EQ(scene["contacts"]["all"], 1) << "the pose with overlap";
  EXPECT_EQ(scene["contacts"]["one"], "pose with overlap");
  EXPECT_EQ(scene["rows"], 1);
  EXPECT_EQ(scene["complete"], true);
  EXPECT_NE(page.find("<tr><td><a href=\"#gap=2\">0</a></td><td>3</td>"), std::string::npos);
  EXPECT_NE(page.find("<dd>4 poses: the least distance is 0 at pose 1; 1 with overlap; 1 farther "
                      "than 6</dd>"),
            std::string::npos);
  EXPECT_NE(page.find("Distance by pose"), std::string::npos);
}

TEST(DistanceVerb, HoldsTheNearestOfManyPosesOnItsPage) {
  const TemporaryFolder folder;
  std::string rows = "x,y,z\n";
  for (int k = 0; k < 5000; ++k) {
    rows += std::to_string(5000 - k) + ",0,0\n";
  }
  const std::string path = (folder.path() / "page.html").string();
  ASSERT_EQ(
      soms_run({"distance", box(), box(), "--pose", file_of(folder, "p.csv", rows), "-o", path})
          .status,
      0);
  const Json scene = scene_of(read_text(path));
  EXPECT_EQ(scene["gaps"]["listed"], 1000);
  EXPECT_EQ(scene["gaps"]["all"], 5000);
  EXPECT_EQ(scene["gaps"]["lengths"][0], "0");
  EXPECT_EQ(scene["gaps"]["lengths"][999], "998") << "1,000 from middle to middle";
  EXPECT_EQ(scene["contacts"]["all"], 2);
  EXPECT_EQ(scene["steps"]["count"], 5000);
  const std::vector<int> kept = scene["steps"]["kept"];
  EXPECT_EQ(std::vector<int>(kept.begin(), kept.begin() + 3), (std::vector<int>{0, 4, 8}));
  EXPECT_EQ(std::vector<int>(kept.end() - 1000, kept.end() - 997),
            (std::vector<int>{4000, 4001, 4002}));
}

TEST(DistanceVerb, RefusesAPageThatIsAnotherFile) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "x").string();
  EXPECT_EQ(soms_run({"distance", box(), box(), "--report", path, "--csv", path}).status, 2);
  EXPECT_EQ(soms_run({"distance", box(), box(), "-o", path + ".svg"}).status, 2);
  EXPECT_NE(soms_run({"distance", box(), box(), "-o", path + "/no/page.html"}).status, 0);
}

TEST(DistanceVerb, IsZeroExactlyWhereTrianglesOverlap) {
  const Json touching = distances({"--pose", "2 0 0"}).at(0);
  EXPECT_EQ(touching.at("lower"), 0);
  EXPECT_EQ(touching.at("upper"), 0);
  const RunResult first =
      soms_run({"overlap", box(), box(), "--pose", "2 0 0", "--first", "--json"});
  EXPECT_EQ(touching.at("triangles"), json_lines(first.out).at(0).at("pairs").at(0));
  const Json apart = distances({"--pose", "2.0000000000000004 0 0"}).at(0);
  EXPECT_EQ(apart.at("lower").get<double>(), 0x1p-51);
}

TEST(DistanceVerb, OfABodyInsideAnotherIsThatOfTheSurfaces) {
  const Json answer = distances({"--scale", "0.5"}).at(0);
  EXPECT_EQ(answer.at("lower"), 0.5);
  EXPECT_EQ(answer.at("upper"), 0.5);
}

TEST(DistanceVerb, NamesTheTrianglesOfTheFile) {
  const TwoWalls walls;
  const RunResult json = soms_run({"distance", walls.a, walls.b, "--json"});
  const Json answer = json_lines(json.out).at(0);
  EXPECT_EQ(answer.at("triangles"), Json::array({1, 0}));
  EXPECT_EQ(answer.at("point_a"), Json::array({1, 1, 0}));
  EXPECT_EQ(answer.at("point_b"), Json::array({1, 1, 1}));
  const RunResult text = soms_run({"distance", walls.a, walls.b});
  EXPECT_EQ(text.out, "distance 1: triangle 1 (near) of " + walls.a +
                          " at (1, 1, 0) and triangle 0 of " + walls.b + " at (1, 1, 1)\n");
  // With the arguments exchanged so are the columns.
  const Json back = json_lines(soms_run({"distance", walls.b, walls.a, "--json"}).out).at(0);
  EXPECT_EQ(back.at("triangles"), Json::array({0, 1}));
  EXPECT_EQ(back.at("point_a"), Json::array({1, 1, 1}));
  EXPECT_EQ(back.at("point_b"), Json::array({1, 1, 0}));
}

TEST(DistanceVerb, SaysNoMoreThanFartherBeyondTheLimit) {
  const Json near = distances({"--pose", "5 0 0", "--at-most", "3"}).at(0);
  EXPECT_EQ(near.at("lower"), 3);
  EXPECT_EQ(near.at("farther"), false);
  const Json far = distances({"--pose", "5 0 0", "--at-most", "2.9999999999999996"}).at(0);
  EXPECT_EQ(far.at("farther"), true);
  EXPECT_GE(far.at("lower").get<double>(), 2.9999999999999996);
  EXPECT_LE(far.at("lower").get<double>(), 3);
  EXPECT_TRUE(far.at("upper").is_null());
  EXPECT_EQ(far.at("coverage"), "complete");
  for (const char* key : {"triangles", "point_a", "point_b"}) {
    EXPECT_FALSE(far.contains(key)) << key;
  }
  EXPECT_EQ(soms_run({"distance", box(), box(), "--pose", "5 0 0", "--at-most", "1"}).out,
            "farther than 1\n");
}

TEST(DistanceVerb, RefusesALimitThatIsNone) {
  for (const char* value : {"-1", "-1e-300", "nan", "inf", "1,5", "x", ""}) {
    const RunResult result = soms_run({"distance", box(), box(), "--at-most", value});
    EXPECT_EQ(result.status, 2) << value;
    EXPECT_NE(result.err.find("soms distance: --at-most"), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
  }
  EXPECT_EQ(distances({"--at-most", "0"}).at(0).at("upper"), 0);
}

TEST(DistanceVerb, OfAnEmptyModelIsInfinite) {
  const std::string empty = data("nasty/empty_mesh.ply").string();
  EXPECT_EQ(soms_run({"distance", empty, box()}).status, 3);
  const RunResult result = soms_run({"distance", box(), empty, "--allow-empty", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const Json answer = json_lines(result.out).at(0);
  EXPECT_TRUE(answer.at("lower").is_null());
  EXPECT_TRUE(answer.at("upper").is_null());
  EXPECT_FALSE(answer.contains("triangles"));
  EXPECT_EQ(soms_run({"distance", box(), empty, "--allow-empty"}).out,
            "no distance: a model has no triangles\n");
}

TEST(DistanceVerb, AnswersRowsOfPosesInTheirOrder) {
  const TemporaryFolder folder;
  std::string rows = "x,y,z\n";
  for (int k = 0; k < 300; ++k) {
    rows += std::to_string(3 + k % 7) + ",0,0\n";
  }
  const std::string poses = file_of(folder, "poses.csv", rows);
  const std::vector<Json> answers = distances({"--pose", poses});
  ASSERT_EQ(answers.size(), 300U);
  for (std::size_t k = 0; k < answers.size(); ++k) {
    ASSERT_EQ(answers[k].at("pose"), k);
    ASSERT_EQ(answers[k].at("lower"), 1 + k % 7);
  }
  const auto lines = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"distance", box(), box(), "--json", "--pose", poses};
    words.insert(words.end(), more.begin(), more.end());
    return soms_run(words).out;
  };
  EXPECT_EQ(lines({"--threads", "1"}), lines({"--threads", "3"}));
  // The other body moves the other way.
  const std::vector<Json> others = distances({"--pose-b", poses});
  EXPECT_EQ(others.at(8).at("upper"), 2);
  EXPECT_EQ(others.at(8).at("point_b").at(0), 3);
}

TEST(DistanceVerb, PrintsATableAndTotalsForPeople) {
  const TemporaryFolder folder;
  const std::string few = file_of(folder, "few.csv", "x,y,z\n7,0,0\n2.5,0,0\n0.5,0,0\n");
  const RunResult table = soms_run({"distance", box(), box(), "--pose", few, "--at-most", "4"});
  EXPECT_TRUE(
      table.out.starts_with("  pose  distance          triangle of A         triangle of B\n"
                            "     0  > 4\n"
                            "     1  0.5               "))
      << table.out;
  EXPECT_NE(
      table.out.find("3 poses: the least distance is 0 at pose 2; 1 with overlap; 1 farther than "
                     "4\n"),
      std::string::npos)
      << table.out;
  std::string rows = "x,y,z\n";
  for (int k = 0; k < 1000; ++k) {
    rows += std::to_string(3 + k) + ",0,0\n";
  }
  const std::string many = file_of(folder, "many.csv", rows);
  const std::string out = soms_run({"distance", box(), box(), "--pose", many}).out;
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 23);
  EXPECT_TRUE(
      out.ends_with("   and 980 poses more; --json lists all\n1,000 poses: the least "
                    "distance is 1 at pose 0, the greatest 1000 at pose 999\n"))
      << out;
}

TEST(DistanceVerb, NamesTheRowAtFault) {
  const TemporaryFolder folder;
  const std::string poses = file_of(folder, "poses.csv", "x,y,z\n5,0,0\n6,0,0\n1e300,0,0\n");
  const RunResult result = soms_run({"distance", box(), box(), "--pose", poses, "--json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(json_lines(result.out).size(), 2U);
  EXPECT_NE(result.err.find(poses + ": pose 2: "), std::string::npos) << result.err;
  EXPECT_EQ(soms_run({"distance", box(), box(), "--pose", "nowhere.csv"}).status, 3);
  EXPECT_EQ(soms_run({"distance", box(), "nothing.ply"}).status, 3);
  EXPECT_EQ(soms_run({"distance", "-", "-"}).status, 2);
}

TEST(DistanceVerb, WritesATable) {
  const TwoWalls walls;
  const std::string csv = (walls.folder.path() / "answers.csv").string();
  const std::string poses = file_of(walls.folder, "poses.csv", "x,y,z\n0,0,0\n0,0,-99\n");
  ASSERT_EQ(
      soms_run({"distance", walls.a, walls.b, "--pose", poses, "--at-most", "9", "-o", csv}).status,
      0);
  const std::string text = read_text(csv);
  EXPECT_TRUE(
      text.starts_with("pose,lower,upper,farther,triangle_a,part_a,name_a,triangle_b,"
                       "part_b,name_b,point_a_x,point_a_y,point_a_z,point_b_x,point_b_y,"
                       "point_b_z,coverage\n"
                       "0,1,1,false,1,1,near,0,,,1,1,0,1,1,1,complete\n1,"))
      << text;
  EXPECT_TRUE(text.ends_with(",inf,true,,,,,,,,,,,,,complete\n")) << text;
  const RunResult other = soms_run({"distance", box(), box(), "--csv", "table.html"});
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find(".csv"), std::string::npos) << other.err;
}

TEST(DistanceVerb, WarnsOfAxesAndUnitsButNotOfGaps) {
  const std::string hall = data("frames/hall.obj").string();
  const std::string duct = data("frames/duct.gltf").string();
  const auto kinds = [](const RunResult& result) {
    std::vector<std::string> found;
    const Json answer = json_lines(result.out).at(0);
    for (const Json& warning : answer.at("warnings")) {
      found.push_back(warning.at("kind"));
    }
    return found;
  };
  const RunResult result = soms_run({"distance", hall, duct, "--pose", "900 0 0", "--json"});
  EXPECT_EQ(kinds(result), (std::vector<std::string>{"axis_unknown", "unit_unknown"}));
  EXPECT_EQ(soms_run({"distance", hall, duct, "--strict"}).status, 3);
  EXPECT_EQ(soms_run({"distance", box(), box(), "--pose", "900 0 0", "--strict"}).status, 0);
}

TEST(DistanceVerb, VerifiesByBruteForce) {
  EXPECT_EQ(distances({"--verify", "--pose", "5 0 0"}).at(0).at("verified"), true);
  const RunResult text = soms_run({"distance", box(), box(), "--verify", "--at-most", "1"});
  EXPECT_EQ(text.status, 0);
  EXPECT_NE(text.out.find("verified by brute force: 1 of 1 answer equal\n"), std::string::npos);
}

TEST(DistanceVerb, KeepsWhatWasAnsweredWhenTimeIsUp) {
  const TemporaryFolder folder;
  const RunResult result = run_with_time(
      [&](const std::string& seconds) {
        const EndlessPipe poses(folder.path() / seconds, "x,y,z", "5,0,0");
        return soms_run(
            {"distance", box(), box(), "--pose", poses.path(), "--json", "--timeout", seconds});
      },
      [](const RunResult& run) { return run.status != 4; });
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("out of time after"), std::string::npos) << result.err;
  const std::vector<Json> answers = json_lines(result.out);
  ASSERT_FALSE(answers.empty());
  for (std::size_t k = 0; k + 1 < answers.size(); ++k) {
    ASSERT_EQ(answers[k].at("coverage"), "complete");
    ASSERT_EQ(answers[k].at("lower"), 3);
  }
}

TEST(DistanceVerb, EndsCleanlyWhenInterrupted) {
  const TemporaryFolder folder;
  const EndlessPipe poses(folder.path() / "poses", "x,y,z", "5,0,0");
  Child child({command().string(), "distance", box(), box(), "--pose", poses.path(), "--json"},
              folder.path());
  ASSERT_TRUE(child.wait_for_output(100'000));
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  EXPECT_EQ(result.out.back(), '\n');
  EXPECT_FALSE(json_lines(result.out).empty());  // every line is whole
  EXPECT_NE(result.err.find("poses are answered"), std::string::npos) << result.err;
}

TEST(DistanceVerb, EndsQuietlyWhenItsReaderGoes) {
  const TemporaryFolder folder;
  const std::string status = (folder.path() / "status").string();
  const EndlessPipe poses(folder.path() / "poses", "x,y,z", "5,0,0");
  const RunResult result =
      shell("{ $soms distance '" + box() + "' '" + box() + "' --json --pose '" + poses.path() +
            "'; echo $? > '" + status + "'; } | head -n 1");
  EXPECT_EQ(read_text(status), "0\n");
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(json_lines(result.out).size(), 1U);
}

TEST(DistanceVerify, AllowsWhatBruteForceAllows) {
  const double next = std::nextafter(3.0, 4.0);
  const Distance truth{.distance = {3, next}, .triangles = TrianglePair{4, 5}};
  EXPECT_TRUE(command::agrees(truth, truth, kInfinity));
  Distance other = truth;
  other.triangles = TrianglePair{4, 6};
  EXPECT_FALSE(command::agrees(other, truth, kInfinity));
  other = truth;
  other.distance.upper = 3;
  EXPECT_FALSE(command::agrees(other, truth, kInfinity));
}

TEST(DistanceVerify, AllowsFartherOnlyBeyondTheLimit) {
  const double next = std::nextafter(3.0, 4.0);
  const Distance truth{.distance = {3, next}, .triangles = TrianglePair{4, 5}};
  Distance farther{.distance = {3, kInfinity}, .farther = true};
  EXPECT_TRUE(command::agrees(farther, truth, 2));
  EXPECT_TRUE(command::agrees(farther, truth, 3));  // between the two doubles
  EXPECT_FALSE(command::agrees(farther, truth, next));
  farther.distance.lower = 1;  // is no bound above the limit
  EXPECT_FALSE(command::agrees(farther, truth, 2));
  farther.distance.lower = next;  // is above the distance
  EXPECT_FALSE(command::agrees(farther, truth, 2));
  farther.distance.lower = 3;
  farther.triangles = TrianglePair{4, 5};
  EXPECT_FALSE(command::agrees(farther, truth, 2));
}

TEST(DistanceVerify, AllowsACutAnswerThatHoldsTheDistance) {
  const Distance truth{.distance = {3, 3}, .triangles = TrianglePair{4, 5}};
  Distance cut{.distance = {0, kInfinity}, .coverage = Coverage::cut};
  EXPECT_TRUE(command::agrees(cut, truth, kInfinity));
  cut.distance = {2, 5};
  EXPECT_TRUE(command::agrees(cut, truth, kInfinity));
  cut.distance = {3.5, 5};
  EXPECT_FALSE(command::agrees(cut, truth, kInfinity));
  cut.distance = {2, 2.5};
  EXPECT_FALSE(command::agrees(cut, truth, kInfinity));
}

}  // namespace
}  // namespace soms::test
