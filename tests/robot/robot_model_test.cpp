#include "soms/robot/robot_model.h"

#include "soms/base/error.h"
#include "soms/kinematics/print.h"
#include "soms/robot/print.h"

#include "tests/robot/robots.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace soms {
namespace {

using Pairs = std::vector<LinkPair>;

TEST(RobotModel, ComparesPairsThatAreNotAllowed) {
  Robot robot = test::sliding_robot({test::cube(1), test::cube(1), test::cube(1)});
  EXPECT_EQ(RobotModel(robot).compared(), (Pairs{{1, 2}, {1, 3}, {2, 3}}));
  robot.allowed = Pairs{{1, 3}};
  const RobotModel model(robot);
  EXPECT_EQ(model.compared(), (Pairs{{1, 2}, {2, 3}}));
  EXPECT_EQ(model.skipped(), (Pairs{{1, 3}}));
  const RobotModel less(robot, {}, {.ignored = {{3, 2}, {1, 3}}});
  EXPECT_EQ(less.compared(), (Pairs{{1, 2}}));
  EXPECT_EQ(less.skipped(), (Pairs{{1, 3}, {2, 3}}));
  EXPECT_TRUE(less.compares(0, 1));
  EXPECT_FALSE(less.compares(1, 2));
}

TEST(RobotModel, ComparesLinksWithTheCellButThoseThatAreOffIt) {
  const Robot robot = test::sliding_robot({test::cube(1), test::cube(1)});
  const std::vector<Mesh> cell{test::cube(2), test::open_cube(3)};
  const RobotModel model(robot, cell, {.off_cell = {1}});
  ASSERT_EQ(model.cell_bodies().size(), 2U);
  EXPECT_TRUE(model.cell_bodies()[0].part.closed);
  EXPECT_FALSE(model.cell_bodies()[1].part.closed);
  EXPECT_EQ(model.on_cell(), (std::vector<std::uint32_t>{2}));
  EXPECT_FALSE(model.compares(0, 2));
  EXPECT_TRUE(model.compares(1, 2));
  EXPECT_FALSE(model.compares(2, 3));  // parts of the cell
  EXPECT_EQ(model.pair_of(1, 3), (RobotPair{2, true, 1}));
}

TEST(RobotModel, DividesMeshesIntoTheirParts) {
  Mesh mesh = test::joined(test::cube(1), test::open_cube(2));
  mesh.parts = {{.name = "inner", .first = 0, .count = 12},
                {.name = "outer", .first = 12, .count = 11}};
  const RobotModel model(test::sliding_robot({mesh}));
  ASSERT_EQ(model.link_bodies().size(), 2U);
  EXPECT_EQ(model.link_bodies()[0].name, "inner");
  EXPECT_EQ(model.link_bodies()[1].owner, 1U);
  EXPECT_EQ(model.link_bodies()[1].part.odd_edges, 3U);
  EXPECT_EQ(model.link_bodies()[1].connected.size(), 1U);
}

TEST(RobotModel, RefusesLinksThatDoNotExist) {
  const Robot robot = test::sliding_robot({test::cube(1)});
  EXPECT_THROW(RobotModel(robot, {}, {.ignored = {{1, 2}}}), Error);
  EXPECT_THROW(RobotModel(robot, {}, {.off_cell = {2}}), Error);
  Robot many{.name = "many", .links = {{.name = "root"}}};
  for (std::uint32_t k = 1; k <= 4097; ++k) {
    many.links.push_back({.name = std::to_string(k), .collisions = {test::cube(1)}});
    many.joints.push_back({.name = std::to_string(k), .parent = 0, .child = k});
  }
  EXPECT_THROW(RobotModel{many}, Error);
  Pose mirrored;
  mirrored.m[0] = -1;
  EXPECT_THROW(RobotModel(robot, {}, {.base = mirrored}), Error);
}

}  // namespace
}  // namespace soms
