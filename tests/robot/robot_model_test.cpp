#include "soms/robot/robot_model.h"

#include "soms/base/error.h"
#include "soms/kinematics/print.h"
#include "soms/robot/print.h"
#include "soms/robot/robot_query.h"

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

TEST(RobotModel, CarriesWhatIsAttached) {
  const RobotModel model(test::sliding_robot({test::cube(0.5), test::cube(0.5), test::cube(0.5)}));
  const RobotAttachment part{.name = "part",
                             .link = 1,
                             .meshes = {test::cube(0.5)},
                             .pose = Pose::translation(0, 1.5, 0),
                             .touching = {3}};
  const RobotModel carrying = model.with_attached(part);
  EXPECT_EQ(carrying.link_names().back(), "part");
  EXPECT_EQ(carrying.kinematics().size(), 3U);
  EXPECT_EQ(carrying.compared(), (Pairs{{1, 2}, {1, 3}, {2, 3}, {2, 4}}));
  EXPECT_EQ(carrying.skipped(), (Pairs{{1, 4}, {3, 4}}));
  EXPECT_EQ(carrying.on_cell(), (std::vector<std::uint32_t>{1, 2, 3, 4}));
  EXPECT_TRUE(carrying.compares(1, 3));
  EXPECT_FALSE(carrying.compares(0, 3));
  EXPECT_FALSE(carrying.compares(2, 3));
  EXPECT_EQ(&carrying.link_bodies()[0].part.body.shape.layout(),
            &model.link_bodies()[0].part.body.shape.layout());
  // It hits the cell where the robot alone does not, at the place that it is carried to.
  const std::vector<Mesh> cell{test::box_body({5, 1.9, -1}, {6, 3, 1})};
  const std::vector<double> state{5, 9, 15};
  EXPECT_EQ(robot_contacts(model.with_cell(cell), state)[0].verdict, RobotVerdict::free);
  const RobotAnswer hit = robot_contacts(carrying.with_cell(cell), state)[0];
  ASSERT_EQ(hit.contacts.size(), 1U);
  EXPECT_EQ(hit.contacts[0].pair, (RobotPair{4, true, 0}));
  // What is attached to it hangs from it.
  const RobotModel more =
      carrying.with_attached({.name = "more", .link = 4, .meshes = {test::cube(1)}});
  EXPECT_EQ(more.skipped(), (Pairs{{1, 4}, {3, 4}, {4, 5}}));
}

TEST(RobotModel, IsThatOfTheWholeRobotWhereSomethingIsAttached) {
  Robot robot = test::sliding_robot({test::cube(0.5), test::cube(0.5)});
  const RobotModel model = RobotModel(robot).with_attached({.name = "part",
                                                            .link = 2,
                                                            .meshes = {test::open_cube(0.5)},
                                                            .pose = Pose::about_z(1, {0, 2, 0})});
  robot.links.push_back({"part", {test::open_cube(0.5)}});
  robot.joints.push_back(
      {.name = "part", .parent = 2, .child = 3, .origin = Pose::about_z(1, {0, 2, 0})});
  const RobotModel whole(robot);
  EXPECT_EQ(model.compared(), whole.compared());
  EXPECT_EQ(model.skipped(), whole.skipped());
  EXPECT_EQ(model.link_bodies(), whole.link_bodies());
  for (const double x : {0.0, 0.9, 1.1, 5.0}) {
    EXPECT_EQ(robot_contacts(model, std::vector<double>{0, x}),
              robot_contacts(whole, std::vector<double>{0, x}));
  }
}

TEST(RobotModel, TakesAnotherCellAndFurtherPairs) {
  const RobotModel model(test::sliding_robot({test::cube(1), test::cube(1), test::cube(1)}),
                         std::vector<Mesh>{test::cube(2)});
  EXPECT_TRUE(model.with_cell({}).cell_bodies().empty());
  EXPECT_EQ(model.with_cell(std::vector<Mesh>(2, test::cube(2))).cell_bodies().size(), 2U);
  EXPECT_EQ(model.cell_bodies().size(), 1U);
  const RobotModel less = model.with_ignored(Pairs{{3, 1}, {1, 3}});
  EXPECT_EQ(less.compared(), (Pairs{{1, 2}, {2, 3}}));
  EXPECT_EQ(less.skipped(), (Pairs{{1, 3}}));
  EXPECT_FALSE(less.compares(0, 2));
  EXPECT_EQ(less.with_ignored(Pairs{{1, 3}}).skipped(), (Pairs{{1, 3}}));
  EXPECT_THROW(static_cast<void>(model.with_ignored(Pairs{{1, 9}})), Error);
  EXPECT_THROW(static_cast<void>(model.with_attached({.name = "a", .link = 1})), Error);  // taken
  EXPECT_THROW(static_cast<void>(model.with_attached({.name = "part", .link = 9})), Error);
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
