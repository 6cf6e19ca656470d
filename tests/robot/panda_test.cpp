// The Panda arm of moveit_resources, by its URDF and SRDF: SOMS_DATA/robots.
#include "soms/base/print.h"
#include "soms/io/robot.h"
#include "soms/kinematics/print.h"
#include "soms/robot/print.h"
#include "soms/robot/reference/robot_query.h"
#include "soms/robot/robot_query.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace soms {
namespace {

/// States of the random ones that brute force looks at here. All 10,000 are compared by
/// `soms robot ... --random 10000 --verify`.
constexpr int kPandaStates = 60;

std::filesystem::path panda_file(const char* name) {
  return *test::outside_data(std::string("robots/") + name);
}

Robot panda(bool with_srdf) {
  RobotReadOptions options{
      .packages = {{"moveit_resources_panda_description", panda_file("panda_description")}}};
  if (with_srdf) {
    options.srdf = panda_file("panda_moveit_config/config/panda.srdf");
  }
  return read_robot(panda_file("panda_description/urdf/panda.urdf"), options);
}

std::uint32_t link_of(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.links.begin(), robot.links.end(),
                                  [&](const Link& link) { return link.name == name; });
  EXPECT_NE(found, robot.links.end()) << name;
  return static_cast<std::uint32_t>(found - robot.links.begin());
}

TEST(Panda, HasItsLinksAndJoints) {
  SOMS_NEEDS_OUTSIDE_DATA("a test of the Panda arm");
  const Robot robot = panda(true);
  EXPECT_EQ(robot.name, "panda");
  EXPECT_EQ(robot.links.size(), 12U);
  EXPECT_EQ(robot.joints.size(), 11U);
  EXPECT_EQ(Kinematics(robot).size(), 8U);  // seven, and one finger that the other follows
  EXPECT_TRUE(robot.notes.empty());
  EXPECT_TRUE(robot.links[link_of(robot, "panda_link8")].collisions.empty());
  ASSERT_EQ(robot.links[link_of(robot, "panda_link0")].collisions.size(), 1U);
  EXPECT_EQ(robot.links[link_of(robot, "panda_link0")].collisions[0].triangles.size(), 200U);
}

TEST(Panda, IsWhereItsMakersSayAtZero) {
  SOMS_NEEDS_OUTSIDE_DATA("a test of the Panda arm");
  const Robot robot = panda(false);
  const std::vector<Pose> poses = link_poses(robot, std::vector<double>(8, 0.0));
  const Vec3 flange = poses[link_of(robot, "panda_link8")].shift();
  // Denavit and Hartenberg: 0.088 along x; 0.333 + 0.316 + 0.384 - 0.107 along z.
  EXPECT_NEAR(flange.x, 0.088, 1e-9);
  EXPECT_NEAR(flange.y, 0, 1e-9);
  EXPECT_NEAR(flange.z, 0.926, 1e-9);
  EXPECT_EQ(poses[link_of(robot, "panda_link1")].shift(), (Vec3{0, 0, 0.333}));
}

TEST(Panda, LeavesOutThePairsOfItsSrdf) {
  SOMS_NEEDS_OUTSIDE_DATA("a test of the Panda arm");
  const Robot robot = panda(true);
  const RobotModel model(robot);
  EXPECT_EQ(model.skipped().size(), 34U);
  EXPECT_EQ(model.compared().size() + model.skipped().size(), 11U * 10U / 2U);
  const LinkPair never{link_of(robot, "panda_link0"), link_of(robot, "panda_link2")};
  EXPECT_TRUE(std::binary_search(model.skipped().begin(), model.skipped().end(), never));
  // Without it, each link but the root has a neighbor: the hand beyond the flange.
  EXPECT_EQ(RobotModel(panda(false)).skipped().size(), 10U);
}

TEST(Panda, IsFreeWhereItsSrdfSaysReady) {
  SOMS_NEEDS_OUTSIDE_DATA("a test of the Panda arm");
  const Robot robot = panda(true);
  const RobotModel model(robot);
  const std::vector<double> ready{0, -0.785, 0, -2.356, 0, 1.571, 0.785, 0.035};
  EXPECT_EQ(robot_contacts(model, ready).at(0).verdict, RobotVerdict::free);
  // Folded beyond its limits, the hand is in the base.
  const std::vector<double> folded{0, 1.8, 0, -3.1, 0, 3.7, 0, 0};
  const RobotAnswer answer = robot_contacts(model, folded).at(0);
  EXPECT_TRUE(answer.beyond_limits.empty());
  const std::vector<double> beyond{3, 0, 0, 1, 0, 0, 0, 0.1};
  EXPECT_EQ(robot_contacts(model, beyond).at(0).beyond_limits.size(), 4U);  // both fingers
}

TEST(Panda, AgreesWithBruteForceInRandomStates) {
  SOMS_NEEDS_OUTSIDE_DATA("60 random states of the Panda arm");
  const RobotModel model(panda(true));
  Rng rng(1);
  std::vector<double> states;
  for (int k = 0; k < kPandaStates; ++k) {
    const std::vector<double> state = random_state(model.kinematics(), rng);
    states.insert(states.end(), state.begin(), state.end());
  }
  const std::vector<RobotAnswer> answers = robot_contacts(model, states, {.distance = true});
  EXPECT_EQ(robot_contacts(model, states, {.distance = true}, {.threads = 2}), answers);
  int contacts = 0;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const RobotAnswer twin =
        reference::robot_contacts_by_brute_force(model, std::span(states).subspan(8 * k, 8), true);
    EXPECT_TRUE(reference::agrees(answers[k], twin)) << answers[k] << '\n' << twin;
    contacts += twin.verdict == RobotVerdict::contact ? 1 : 0;
    EXPECT_TRUE(answers[k].beyond_limits.empty());
  }
  EXPECT_GT(contacts, 0);
  EXPECT_LT(contacts, kPandaStates);
}

}  // namespace
}  // namespace soms
