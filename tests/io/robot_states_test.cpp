#include "soms/io/robot_states.h"

#include "soms/base/error.h"
#include "soms/io/robot.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace soms::test {
namespace {

using Rows = std::vector<std::vector<double>>;

/// turn, lift, wrist, grip.
const Kinematics& arm_joints() {
  static const Kinematics kinematics(read_robot(data("robots/arm.urdf")));
  return kinematics;
}

Rows states_of(const std::string& text, std::optional<std::vector<double>> home = std::nullopt) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "q.csv";
  write_content(file, text);
  RobotStateReader reader(file, arm_joints(), std::move(home));
  Rows rows;
  while (const auto state = reader.next()) {
    EXPECT_TRUE(reader.ready());
    rows.emplace_back(state->begin(), state->end());
  }
  return rows;
}

void expect_bad(const std::string& text, const std::string& words,
                ErrorKind kind = ErrorKind::bad_file) {
  expect_refused([&] { static_cast<void>(states_of(text)); }, kind, words);
}

TEST(RobotStateReader, ReadsRowsWithoutAHeader) {
  EXPECT_EQ(states_of("1,2,3,4\n5, 6 ,7,8\n"), (Rows{{1, 2, 3, 4}, {5, 6, 7, 8}}));
  EXPECT_EQ(states_of("# none\n\n1,2,3,4\n# more\n5,6,7,8"), (Rows{{1, 2, 3, 4}, {5, 6, 7, 8}}));
}

TEST(RobotStateReader, ReadsColumnsInAnyOrder) {
  EXPECT_EQ(states_of("grip,lift,turn,wrist\n4,2,1,3\r\n8,6,5,7\n"),
            (Rows{{1, 2, 3, 4}, {5, 6, 7, 8}}));
}

TEST(RobotStateReader, TakesNumbersThatNameAllColumnsForAHeader) {
  const TemporaryFolder folder;
  const std::filesystem::path urdf = folder.path() / "numbers.urdf";
  std::string text = R"(<robot name="r"><link name="a"/><link name="b"/><link name="c"/>)";
  for (const auto& [name, parent, child] : {std::array{"1", "a", "b"}, std::array{"2", "b", "c"}}) {
    text += std::string(R"(<joint type="continuous" name=")") + name + R"("><parent link=")" +
            parent + R"("/><child link=")" + child + R"("/><axis xyz="0 0 1"/></joint>)";
  }
  write_content(urdf, text + "</robot>");
  const Kinematics joints(read_robot(urdf));
  const auto states = [&](const std::string& rows) {
    const std::filesystem::path file = folder.path() / "q.csv";
    write_content(file, rows);
    RobotStateReader reader(file, joints);
    Rows found;
    while (const auto state = reader.next()) {
      found.emplace_back(state->begin(), state->end());
    }
    return found;
  };
  EXPECT_EQ(states("2,1\n5,3\n"), (Rows{{3, 5}}));
  EXPECT_EQ(states("3,1\n5,3\n"), (Rows{{3, 1}, {5, 3}}));
}

TEST(RobotStateReader, TakesJointsWithoutAColumnFromHome) {
  EXPECT_EQ(states_of("lift\n0.5\n", std::vector<double>{9, 8, 7, 6}), (Rows{{9, 0.5, 7, 6}}));
  EXPECT_EQ(states_of("turn,lift,wrist,grip\n1,2,3,4\n", std::vector<double>{9, 8, 7, 6}),
            (Rows{{1, 2, 3, 4}}));
  expect_bad("lift,turn,wrist\n0.5,1,2\n", "line 1: no column for the joint \"grip\"");
  expect_bad("lift\n0.5\n", "\"turn\" and 2 more");
}

TEST(RobotStateReader, RefusesColumnsThatAreNoMovableJoints) {
  expect_bad("time,turn,lift,wrist,grip\n0,1,2,3,4\n", "the column \"time\" is no joint");
  expect_bad("turn,lift,wrist,grip,grip_too\n1,2,3,4,4\n", "follows \"grip\"");
  expect_bad("turn,lift,wrist,grip,turn\n1,2,3,4,1\n", "occurs twice");
}

TEST(RobotStateReader, NamesTheLineOfABadRow) {
  expect_bad("1,2,3,4\n1,2,3\n", "q.csv, line 2: 3 numbers for 4 joints");
  expect_bad("1,2,3\n", "line 1: 3 numbers for 4 joints");
  expect_bad("turn,lift,wrist,grip\n1,2,3,4,5\n", "line 2: 5 numbers for 4 joints");
  expect_bad("1,2,3,4\n1,2,x,4\n", "line 2: wrist is \"x\", not a number");
  expect_bad("1,2,3,4\n1,2,inf,4\n", "line 2: wrist", ErrorKind::not_finite);
  expect_bad("1,2,3,4\n1,2,1e999,4\n", "line 2: wrist", ErrorKind::not_finite);
  expect_bad("nan,2,3,4\n", "line 1: turn", ErrorKind::not_finite);
  expect_bad("", "no states");
  expect_bad("# nothing\n", "no states");
}

TEST(RobotStateReader, ReadsArraysOfNumpy) {
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 4), }";
  header.resize(117, ' ');
  header += '\n';
  std::string file = "\x93NUMPY";
  file += std::string("\x01\x00", 2) + bytes_of(header.size(), 2) + header;
  for (int k = 1; k <= 8; ++k) {
    file += bytes_of(static_cast<double>(k));
  }
  EXPECT_EQ(states_of(file), (Rows{{1, 2, 3, 4}, {5, 6, 7, 8}}));
}

TEST(RobotStateReader, RefusesAHomeOfAnotherWidth) {
  expect_refused(
      [] {
        static_cast<void>(states_of("lift\n1\n", std::vector<double>{1, 2}));
      },
      ErrorKind::usage, "home");
}

TEST(RobotStateReader, TakesSemicolonsBetweenCells) {
  EXPECT_EQ(states_of("turn;lift;wrist;grip\n1;2;3;4.5\n"), (Rows{{1, 2, 3, 4.5}}));
  EXPECT_EQ(states_of("1;2;3;4.5\n0;0;0;1\n"), (Rows{{1, 2, 3, 4.5}, {0, 0, 0, 1}}));
  expect_bad("turn;lift;wrist;grip\n0,5;2;3;4\n", "write a decimal point in place of the comma");
}

TEST(RobotStateReader, GivesNoStateOfAHeaderAlone) {
  EXPECT_TRUE(states_of("turn,lift,wrist,grip\n").empty());
}

}  // namespace
}  // namespace soms::test
