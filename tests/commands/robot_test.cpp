#include "tests/commands/run.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

std::string arm_urdf() {
  return test::data("robots/arm.urdf").string();
}

std::string arm_srdf() {
  return test::data("robots/arm.srdf").string();
}

RunResult robot_run(std::vector<std::string> words, const std::string& states = {}) {
  words.insert(words.begin(), {"robot", arm_urdf()});
  if (!states.empty()) {
    words.insert(words.end(), {"--states", "-"});
  }
  return soms_run(std::move(words), states);
}

/// The objects of the states, and the last one.
struct RobotLines {
  std::vector<Json> states;
  Json totals;
};

RobotLines robot_lines(const RunResult& result) {
  RobotLines lines{json_lines(result.out), {}};
  if (!lines.states.empty()) {
    lines.totals = lines.states.back();
    lines.states.pop_back();
  }
  return lines;
}

/// A wall at x = 0.5, beyond the column and within the boom.
class Wall {
 public:
  Wall() {
    write_text(path(),
               "o wall\nv 0.5 -3 -3\nv 0.5 3 -3\nv 0.5 3 3\nv 0.5 -3 3\nf 1 2 3\nf 1 3 4\n");
  }

  [[nodiscard]] std::string path() const { return (folder_.path() / "cell.obj").string(); }

  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_.path() / name).string();
  }

 private:
  TemporaryFolder folder_;
};

const std::string kStates = "turn,lift,wrist,grip\n0,0.1,0,0.03\n3,0.1,0,0.03\n0,0.9,0,0.03\n";

TEST(RobotVerb, AnswersInTheSchema) {
  const Wall wall;
  const RunResult result = robot_run({"--srdf", arm_srdf(), "--cell", wall.path(), "--off-cell",
                                      "base", "--distance", "--path", "--verify", "--json"},
                                     kStates);
  EXPECT_EQ(result.status, 0) << result.err;
  const RobotLines lines = robot_lines(result);
  ASSERT_EQ(lines.states.size(), 3U);
  const Json& first = lines.states[0];
  EXPECT_EQ(first.at("schema"), "soms.robot/1");
  EXPECT_EQ(first.at("state"), 0);
  EXPECT_EQ(first.at("verdict"), "contact");
  EXPECT_EQ(first.at("verified"), true);
  ASSERT_EQ(first.at("contacts").size(), 1U);
  EXPECT_EQ(first.at("contacts")[0].at("a").at("link"), "boom");
  EXPECT_EQ(first.at("contacts")[0].at("b").at("cell").at("part"), "wall");
  EXPECT_EQ(first.at("contacts")[0].at("surfaces_meet"), true);
  EXPECT_EQ(first.at("gap").at("distance"), Json({0.0, 0.0}));
  const Json& second = lines.states[1];
  EXPECT_EQ(second.at("verdict"), "free");
  EXPECT_EQ(second.at("gap").at("a").at("link"), "left");
  EXPECT_EQ(second.at("gap").at("points").size(), 2U);
  EXPECT_EQ(lines.states[2].at("out_of_limits"), Json({"lift"}));
  EXPECT_EQ(lines.totals.at("states"), 3);
  EXPECT_EQ(lines.totals.at("free"), 1);
  EXPECT_EQ(lines.totals.at("contact"), 2);
  EXPECT_EQ(lines.totals.at("out_of_limits"), 1);
  EXPECT_EQ(lines.totals.at("joints_out_of_limits"), Json({{"lift", 1}}));
  EXPECT_EQ(lines.totals.at("pairs").at(0).at("states"), 2);
  EXPECT_FALSE(first.contains("way"));
  EXPECT_EQ(second.at("way").at("verdict"), "started");
  const Json& way = lines.states[2].at("way");
  EXPECT_EQ(way.at("from"), 1);
  EXPECT_EQ(way.at("verdict"), "contact");
  EXPECT_LT(way.at("lower").get<double>(), way.at("upper").get<double>());
  EXPECT_EQ(way.at("a").at("link"), "right");
  EXPECT_EQ(way.at("b").at("cell").at("part"), "wall");
  EXPECT_EQ(lines.totals.at("path").at("first_contact"), 0);
  EXPECT_EQ(lines.totals.at("path").at("contact"), 2);
  EXPECT_EQ(lines.totals.at("path").at("blocked").at("from"), 0);
  EXPECT_EQ(lines.totals.at("least_gap").at("state"), 0);
  EXPECT_EQ(lines.totals.at("compared").at("link_pairs"), 5);
  EXPECT_EQ(lines.totals.at("compared").at("not_compared_by"), "srdf");
  EXPECT_EQ(lines.totals.at("open"), Json({"wall of the cell"}));
  EXPECT_EQ(lines.totals.at("verified"), true);
  EXPECT_EQ(lines.totals.at("coverage"), "complete");
}

TEST(RobotVerb, SaysItInWords) {
  const Wall wall;
  const RunResult result =
      robot_run({"--cell", wall.path(), "--off-cell", "base", "--path"}, kStates);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out,
            "arm: 6 links, 5 with collision meshes; 4 joints move by themselves\n"
            "6 pairs of links compared, 4 not (joint neighbors, or excluded by an option)\n"
            "cylinders and spheres are meshes that exceed them by at most 0.000483857238\n"
            "cell: 1 part, compared with 4 links\n"
            "not closed, so that what lies in it is undecided: wall of the cell\n"
            "state 0: contact: boom and cell: wall\n"
            "state 1: free\n"
            "  from state 1: contact at 0.614646724 of the way: right and cell: wall\n"
            "state 2: contact: boom and cell: wall; out of limits: lift\n"
            "3 states: 1 free, 2 with contact; 1 out of limits\n"
            "  boom and cell: wall: 2 states\n"
            "path: blocked at state 0\n");
}

TEST(RobotVerb, ProvesWhatIsBetweenStates) {
  const Wall wall;
  const auto path = [&](const std::string& states, const std::string& option) {
    return robot_run({"--cell", wall.path(), "--off-cell", "base", "--path", option},
                     "turn,lift,wrist,grip\n" + states);
  };
  // From one side of the wall to the other, by free states.
  const std::string both = "3,0.1,0,0.03\n1.8,0.1,0,0.03\n-1.8,0.1,0,0.03\n";
  const RunResult through = path(both, "--fail-if=contact");
  EXPECT_EQ(through.status, 1);
  EXPECT_NE(through.out.find("3 states: 3 free"), std::string::npos) << through.out;
  EXPECT_NE(through.out.find("path: blocked between states 1 and 2, at 0."), std::string::npos);
  const RunResult free = path("3,0.1,0,0.03\n1.8,0.1,0,0.03\n", "--fail-if=contact");
  EXPECT_EQ(free.status, 0);
  EXPECT_NE(free.out.find("path: free, between its states too\n"), std::string::npos) << free.out;
  EXPECT_EQ(path("3,0.1,0,0.03\n", "--fail-if=contact").status, 0);
}

// A block of rows ends anywhere: the way to the first state of a block begins in the one before.
TEST(RobotVerb, FollowsAPathThroughBlocks) {
  std::string states = "turn,lift,wrist,grip\n";
  for (int k = 0; k < 3000; ++k) {
    states += k % 2 == 0 ? "1.8,0.1,0,0.03\n" : "-1.8,0.1,0,0.03\n";
  }
  const Wall wall;
  const RobotLines lines = robot_lines(
      robot_run({"--cell", wall.path(), "--off-cell", "base", "--path", "--json"}, states));
  ASSERT_EQ(lines.states.size(), 3000U);
  EXPECT_EQ(lines.totals.at("path").at("contact"), 2999);
  for (std::size_t k = 1; k < 3000; ++k) {
    ASSERT_EQ(lines.states[k].at("way").at("from"), k - 1);
  }
}

TEST(RobotVerb, TakesStatesOfManyForms) {
  const auto verdicts = [](const RunResult& result) {
    EXPECT_EQ(result.status, 0) << result.err;
    std::vector<std::string> words;
    for (const Json& state : robot_lines(result).states) {
      words.push_back(state.at("verdict"));
    }
    return words;
  };
  const Wall wall;
  const std::vector<std::string> cell{"--cell", wall.path(), "--off-cell", "base", "--json"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), cell.begin(), cell.end());
    return more;
  };
  using Words = std::vector<std::string>;
  EXPECT_EQ(verdicts(robot_run(with({}), "0,0.1,0,0.03\n3,0.1,0,0.03\n")),
            (Words{"contact", "free"}));
  EXPECT_EQ(verdicts(robot_run(with({}), "grip,turn,wrist,lift\n0.03,3,0,0.1\n")), Words{"free"});
  EXPECT_EQ(
      verdicts(robot_run(with({"--home", "zero", "--ignore-pair", "left,right"}), "turn\n0\n3\n")),
      (Words{"contact", "free"}));
  const RunResult home = robot_run(with({"--home", "up", "--srdf", arm_srdf()}), "turn\n0\n");
  EXPECT_EQ(verdicts(home), Words{"contact"});
  EXPECT_NE(home.err.find("joints without a column, as --home has them: lift, wrist, grip"),
            std::string::npos);
}

TEST(RobotVerb, DrawsRandomStatesBySeed) {
  const auto run = [](const std::string& seed, const std::string& threads) {
    return robot_run(
               {"--random", "50", "--seed", seed, "--threads", threads, "--distance", "--json"})
        .out;
  };
  EXPECT_EQ(run("1", "1"), run("1", "2"));
  EXPECT_NE(run("1", "1"), run("2", "1"));
  EXPECT_EQ(robot_lines(robot_run({"--random", "50", "--json"})).totals.at("out_of_limits"), 0);
}

TEST(RobotVerb, LeavesOutPairsOnRequest) {
  const auto compared = [](std::vector<std::string> words) {
    words.insert(words.end(), {"--random", "1", "--json"});
    return robot_lines(robot_run(std::move(words))).totals.at("compared").at("link_pairs");
  };
  EXPECT_EQ(compared({}), 6);
  EXPECT_EQ(compared({"--ignore-pair", "left,right"}), 5);
  EXPECT_EQ(compared({"--srdf", arm_srdf()}), 5);
  EXPECT_EQ(compared({"--srdf", arm_srdf(), "--ignore-pair", "right,left"}), 4);
}

TEST(RobotVerb, PlacesTheRobotInTheCell) {
  const Wall wall;
  const auto verdict = [&](const std::string& base) {
    return robot_lines(
               robot_run({"--cell", wall.path(), "--base", base, "--json"}, "0,0.1,0,0.03\n"))
        .states.at(0)
        .at("verdict");
  };
  EXPECT_EQ(verdict("0 0 0"), "contact");
  EXPECT_EQ(verdict("1.1 0 0"), "free");
}

TEST(RobotVerb, FailsOnRequest) {
  const Wall wall;
  const std::vector<std::string> cell{"--cell", wall.path(), "--off-cell",
                                      "base",   "--fail-if", "contact"};
  EXPECT_EQ(robot_run(cell, "3,0.1,0,0.03\n").status, 0);
  EXPECT_EQ(robot_run(cell, "3,0.1,0,0.03\n0,0.1,0,0.03\n").status, 1);
}

TEST(RobotVerb, WritesCsvAndJson) {
  const Wall wall;
  const RunResult result =
      robot_run({"--cell", wall.path(), "--off-cell", "base", "--json", "-o", wall.file("a.csv"),
                 "-o", wall.file("a.jsonl"), "--distance", "--at-most", "0.001"},
                kStates);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read_text(wall.file("a.jsonl")), result.out);
  EXPECT_EQ(read_text(wall.file("a.csv")),
            "state,verdict,contacts,pairs,out_of_limits,gap_lower,gap_upper,gap_a,gap_b\n"
            "0,contact,1,boom | cell: wall,,0,0,boom,cell: wall\n"
            "1,free,0,,,0.001,inf,,\n"
            "2,contact,1,boom | cell: wall,lift,0,0,boom,cell: wall\n");
}

TEST(RobotVerb, RefusesStatesOutsideOfLimitsWhereItIsStrict) {
  const RunResult result = robot_run({"--strict"}, kStates);
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("state 2: joint lift is 0.9, outside of its limits 0 and 0.7"),
            std::string::npos)
      << result.err;
}

void expect_robot_refused(const RunResult& result, int status, const std::string& words) {
  EXPECT_EQ(result.status, status) << result.out;
  EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
}

TEST(RobotVerb, RefusesWhatMakesNoSense) {
  expect_robot_refused(robot_run({}), 2, "no states are given");
  expect_robot_refused(robot_run({"--random", "1"}, kStates), 2, "both give the states");
  expect_robot_refused(robot_run({"--random", "1", "--home", "zero"}), 2, "--home has no effect");
  expect_robot_refused(robot_run({"--random", "1", "--at-most", "1"}), 2,
                       "--at-most has no effect");
  expect_robot_refused(robot_run({"--random", "1", "--off-cell", "base"}), 2, "has no effect");
  expect_robot_refused(robot_run({"--random", "1", "--ignore-pair", "base"}), 2,
                       "is no pair of links");
  expect_robot_refused(robot_run({"--random", "1", "--ignore-pair", "base,leg"}), 2,
                       "leg is no link of the robot");
  expect_robot_refused(robot_run({"--random", "1", "--package", "x"}), 2, "is no package");
  expect_robot_refused(robot_run({"--random", "1", "-o", "a.png"}), 2, "-o");
  expect_robot_refused(robot_run({"--home", "down"}, kStates), 2, "give one of zero");
  expect_robot_refused(robot_run({}, "time,turn\n0,0\n"), 3, "line 1: the column \"time\"");
  expect_robot_refused(robot_run({}, "turn\n0\n"), 3, "--home zero");
  expect_robot_refused(robot_run({}, "0,0,0,0\n0,0,0\n"), 3, "line 2: 3 numbers for 4 joints");
  expect_robot_refused(robot_run({}, "0,1e300,0,0\n"), 3, "state 0: link ");
  expect_robot_refused(soms_run({"robot", "none.urdf", "--random", "1"}), 3, "none.urdf");
  expect_robot_refused(soms_run({"robot", "arm.xacro", "--random", "1"}), 3, "run xacro");
  expect_robot_refused(
      soms_run({"robot", test::data("robots/bad/mesh_package.urdf").string(), "--random", "1"}), 3,
      "--package NAME=DIR");
}

TEST(RobotVerb, TellsUrdfFromSrdf) {
  const RunResult result = robot_run({"--srdf", arm_urdf(), "--random", "2"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("a URDF file, not an SRDF file"), std::string::npos) << result.err;
}

TEST(RobotVerb, AnswersTheRowsBeforeABadOne) {
  const RunResult result = robot_run({"--json"}, "0,0,0,0.03\n1,0,0,0.03\nx,0,0,0\n");
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(json_lines(result.out).size(), 2U);
}

TEST(RobotVerb, KeepsWhatIsDoneWhereItIsInterrupted) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "q.jsonl").string();
  Child child({test::command().string(), "robot", arm_urdf(), "--random", "1000000000", "--json",
               "-o", file},
              folder.path());
  ASSERT_TRUE(child.wait_for_lines(5));
  child.send_until_it_ends(SIGINT);
  EXPECT_EQ(child.wait().status, 130);
  const std::vector<Json> lines = json_lines(read_text(file));
  ASSERT_GT(lines.size(), 5U);
  EXPECT_EQ(lines.back().at("interrupted"), true);
  EXPECT_EQ(lines.back().at("coverage"), "cut");
  EXPECT_EQ(lines.back().at("states"), lines.size() - 1);
}

TEST(RobotVerb, EndsByTimeWithWhatIsDone) {
  const RunResult result = run_with_time(
      [](const std::string& seconds) {
        return robot_run({"--random", "1000000000", "--json", "--timeout", seconds});
      },
      [](const RunResult& run) { return run.out.size() > 1000; });
  EXPECT_EQ(result.status, 0) << result.err;
  const RobotLines lines = robot_lines(result);
  EXPECT_EQ(lines.totals.at("timed_out"), true);
  EXPECT_NE(result.err.find("out of time after"), std::string::npos);
}

TEST(RobotVerb, TakesANamedStateOfJointsThatAreNotThereWhereItNeedsNone) {
  const std::string folder = test::data("robots/noted").string();
  const RunResult result =
      soms_run({"robot", folder + "/floating_srdf.urdf", "--srdf", folder + "/floating.srdf",
                "--states", "-", "--home", "half_sitting"},
               "x\n0\n");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("; 1 joint moves by itself\n"), std::string::npos) << result.out;
  EXPECT_NE(result.err.find("values of joints that the robot does not have: 1"), std::string::npos)
      << result.err;
}

/// A value that may be meant for a joint of another name is no reason to call that joint 0.
TEST(RobotVerb, RefusesANamedStateWhoseJointMayBeMisspelled) {
  const TemporaryFolder folder;
  const std::string srdf = (folder.path() / "arm.srdf").string();
  write_text(srdf,
             "<robot name=\"arm\"><group_state name=\"up\" group=\"all\">"
             "<joint name=\"Lift\" value=\"0.6\"/><joint name=\"grip\" value=\"0.03\"/>"
             "<joint name=\"wrist\" value=\"0\"/></group_state></robot>");
  const auto run = [&](const std::string& states) {
    return soms_run({"robot", arm_urdf(), "--srdf", srdf, "--states", "-", "--home", "up"}, states);
  };
  const RunResult refused = run("turn\n0\n");
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_NE(refused.err.find("a value of \"Lift\", a joint that the robot does not have, and none "
                             "of \"lift\""),
            std::string::npos)
      << refused.err;
  EXPECT_EQ(run("turn,lift\n0,0.1\n").status, 0);
}

TEST(RobotVerb, FindsPackagesByRosPackagePath) {
  const TemporaryFolder folder;
  const std::string meshes = (folder.path() / "shapes").string();
  const RunResult made = shell("mkdir " + meshes + " && $soms generate sphere --triangles 80 -o " +
                               meshes + "/ball.off");
  ASSERT_EQ(made.status, 0) << made.err;
  const std::string urdf = (folder.path() / "sub.urdf").string();
  write_text(urdf,
             "<robot name=\"r\"><link name=\"a\"><collision><geometry><mesh "
             "filename=\"package://balls/ball.off\"/></geometry></collision></link></robot>");
  EXPECT_EQ(soms_run({"robot", urdf, "--random", "1"}).status, 3);
  EXPECT_EQ(soms_run({"robot", urdf, "--random", "1", "--package", "balls=" + meshes}).status, 0);
  // In a folder that is not above the file, and not beside one that is.
  const std::string folders = folder.path().string();
  const std::string line = "cd " + folders + " && mkdir -p ros && mv shapes ros/balls && ";
  EXPECT_EQ(shell(line + "ROS_PACKAGE_PATH=/nowhere:" + folders + "/ros $soms robot sub.urdf " +
                  "--random 1")
                .status,
            0);
  EXPECT_EQ(shell("cd " + folders + " && ROS_PACKAGE_PATH= $soms robot sub.urdf --random 1").status,
            3);
}

}  // namespace
}  // namespace soms::test
