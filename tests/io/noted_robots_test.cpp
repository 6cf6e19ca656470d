// What URDF and SRDF files say that can change no answer is a note, and the robot is the same.
#include "soms/geometry/closedness.h"
#include "soms/io/print.h"
#include "soms/io/robot.h"
#include "soms/kinematics/print.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::test {
namespace {

std::filesystem::path noted(const std::string& name) {
  return test::data("robots/noted/" + name);
}

/// The only note, which must have these words.
void expect_note(const Robot& robot, const std::string& words) {
  ASSERT_EQ(robot.notes.size(), 1U);
  EXPECT_NE(robot.notes.front().find(words), std::string::npos) << robot.notes.front();
}

TEST(NotedRobots, AStateOfARootJointThatIsNotThereIsNoted) {
  const std::string urdf = noted("floating_srdf.urdf").string();
  const Robot robot = read_robot(urdf, {.srdf = noted("floating.srdf")});
  expect_note(robot, "values of joints that the robot does not have: 1, in line 2");
  ASSERT_EQ(robot.states.size(), 1U);
  EXPECT_EQ(robot.states[0].values, (std::vector<std::pair<std::uint32_t, double>>{{1, 2.0}}));
  EXPECT_EQ(robot.states[0].unknown, std::vector<std::string>{"root_joint"});
  // A virtual joint says so itself.
  const Robot said = read_robot(urdf, {.srdf = noted("floating_vj.srdf")});
  EXPECT_TRUE(said.notes.empty());
  EXPECT_EQ(said.states[0].values, robot.states[0].values);
  expect_refused(
      [&] {
        static_cast<void>(read_robot(urdf, {.srdf = noted("floating.srdf"), .strict = true}));
      },
      ErrorKind::bad_file, "values of joints that the robot does not have");
}

TEST(NotedRobots, APairOfAToolThatIsNotThereIsNoted) {
  const Robot robot = read_robot(noted("floating_srdf.urdf"), {.srdf = noted("tool_srdf.srdf")});
  expect_note(robot, "entries of links that the robot does not have: 1, in line 2");
  EXPECT_EQ(robot.allowed, std::vector<LinkPair>());
}

TEST(NotedRobots, AFixedJointThatMimicsIsNoted) {
  const Robot robot = read_robot(noted("fixed_mimic.urdf"));
  expect_note(robot, "<mimic> of fixed joints: 1, in line 7");
  ASSERT_EQ(robot.joints.size(), 3U);
  EXPECT_FALSE(robot.joints[1].mimic);
}

TEST(NotedRobots, SizesOfZeroAreFlatAndClosed) {
  for (const char* const file : {"flat_cylinder.urdf", "box_zero.urdf", "sphere_zero.urdf"}) {
    SCOPED_TRACE(file);
    const Robot robot = read_robot(noted(file));
    expect_note(robot, "sizes of 0, which make a shape flat, a segment or a point: 1, in line");
    const Mesh& mesh = robot.links[0].collisions.at(0);
    EXPECT_TRUE(closedness(mesh).whole.closed);
    const Vec3 extent = bounds(mesh).extent();
    EXPECT_EQ(std::min({extent.x, extent.y, extent.z}), 0);
  }
}

TEST(NotedRobots, EntriesOfUnknownLinksAndJointsChangeNothing) {
  for (const auto& [file, words] : {std::pair{"link1_unknown.srdf", "entries of links"},
                                    {"link2_unknown.srdf", "entries of links"},
                                    {"default_unknown.srdf", "entries of links"},
                                    {"enable_unknown.srdf", "entries of links"},
                                    {"same_link.srdf", "pairs of a link with itself"},
                                    {"state_joint_unknown.srdf", "values of joints"}}) {
    SCOPED_TRACE(file);
    Robot robot = read_robot(test::data("robots/arm.urdf"));
    read_semantics(robot, noted(file));
    expect_note(robot, words);
    EXPECT_EQ(robot.allowed, std::vector<LinkPair>());
  }
}

/// The SRDF file of a robot with lines before its end.
Robot read_with(const std::string& more) {
  std::string text = content_of(test::data("robots/arm.srdf"));
  const std::size_t end = text.rfind("</robot>");
  text.insert(end, more);
  Robot robot = read_robot(test::data("robots/arm.urdf"));
  read_semantics(robot, std::as_bytes(std::span(text)), "arm.srdf");
  return robot;
}

/// Whatever such lines are added, all but the notes stays.
TEST(NotedRobots, AnyLinesOfWhatIsNotThereChangeNothing) {
  const std::vector<std::string> lines{
      R"(<disable_collisions link1="no such" link2="boom" reason="Never"/>)",
      R"(<disable_collisions link1="boom" link2="boom"/>)",
      R"(<enable_collisions link1="left" link2="no such"/>)",
      R"(<disable_default_collisions link="no such"/>)"};
  const Robot plain = read_with("");
  EXPECT_TRUE(plain.notes.empty());
  for_each_case("noted robots", 200, [&](Rng& rng) {
    std::string more;
    for (std::uint64_t count = 1 + rng.below(5); count > 0; --count) {
      more += lines[rng.below(lines.size())] + "\n";
    }
    Robot robot = read_with(more);
    EXPECT_FALSE(robot.notes.empty());
    EXPECT_LE(robot.notes.size(), 2U);
    robot.notes = plain.notes;
    EXPECT_EQ(robot, plain) << more;
  });
}

}  // namespace
}  // namespace soms::test
