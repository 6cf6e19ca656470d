#include "soms/kinematics/link_pairs.h"

#include "soms/kinematics/print.h"

#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <vector>

namespace soms {
namespace {

using Pairs = std::vector<LinkPair>;

/// base - arm - flange (no mesh) - hand - two fingers.
Robot handed_robot() {
  Robot robot;
  const Mesh box = test::box_body({0, 0, 0}, {1, 1, 1});
  for (const char* const name : {"base", "arm", "flange", "hand", "left", "right"}) {
    robot.links.push_back({.name = name, .collisions = {box}});
  }
  robot.links[2].collisions.clear();
  const Pairs joined{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {3, 5}};
  for (const LinkPair& pair : joined) {
    robot.joints.push_back({.name = robot.links[pair.b].name, .parent = pair.a, .child = pair.b});
  }
  return robot;
}

TEST(LinkPairs, OfNeighborsAreNotCompared) {
  const Robot robot = handed_robot();
  EXPECT_EQ(neighbor_pairs(robot), (Pairs{{0, 1}, {1, 3}, {3, 4}, {3, 5}}));
  EXPECT_EQ(skipped_pairs(robot), neighbor_pairs(robot));
  EXPECT_EQ(compared_pairs(robot), (Pairs{{0, 3}, {0, 4}, {0, 5}, {1, 4}, {1, 5}, {4, 5}}));
}

TEST(LinkPairs, ThatAreListedAreNotComparedAndNoOthers) {
  Robot robot = handed_robot();
  robot.allowed = Pairs{{0, 1}, {1, 2}, {4, 5}};  // 2 has no mesh
  EXPECT_EQ(skipped_pairs(robot), (Pairs{{0, 1}, {4, 5}}));
  EXPECT_EQ(compared_pairs(robot).size(), 10U - 2U);
  robot.allowed = Pairs{};
  EXPECT_EQ(compared_pairs(robot).size(), 10U);
}

TEST(LinkPairs, OfSiblingsOnALinkWithoutMeshesAreCompared) {
  Robot robot = handed_robot();
  robot.links[3].collisions.clear();  // the fingers hang on the hand, and hang on nothing else
  EXPECT_EQ(neighbor_pairs(robot), (Pairs{{0, 1}, {1, 4}, {1, 5}}));
  EXPECT_EQ(compared_pairs(robot), (Pairs{{0, 4}, {0, 5}, {4, 5}}));
}

}  // namespace
}  // namespace soms
