#include "apps/view/scene/counted_step.h"

#include "soms/generate/shapes.h"
#include "soms/thesis/overlap.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/build.h"

#include "apps/view/scene/load.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <utility>

namespace soms::view {
namespace {

/// Two knots that cross.
ViewScene two_knots() {
  return ViewScene(two_bodies(Body(Shape(generate_knot(300))),
                              Body(Shape(generate_knot(300)), Pose::about_z(0.3, {0.9, 0.2, 0}))));
}

/// A wall, three blocks in it or beside it, two of which touch, and one far away.
ViewScene wall_and_blocks() {
  SceneContent content;
  content.city.emplace_back(test::box_body({10, -5, 0}, {11, 50, 5}, 6));
  content.city.emplace_back(test::box_body({0, -5, -1}, {9, 50, 0}, 3));
  const Shape block(test::box_body({0, 0, 0}, {1, 1, 1}, 3));
  const std::vector<Pose> poses{Pose::translation(9.5, 0, 0), Pose::translation(9.6, 0.9, 0.1),
                                Pose::translation(8.5, 9, 0), Pose::translation(50, 90, 9)};
  for (const Pose& pose : poses) {
    content.movers.push_back({Body(block, pose), {}});
  }
  return ViewScene(std::move(content));
}

TreeChoice by(Traversal traversal, BuildOptions build = {.rule = Rule::soms}) {
  return {build, without_idle({.traversal = traversal, .descent = Descent::larger})};
}

/// The same body with the tree that the library needs.
Body with_tree(const Body& body, const BuildOptions& build) {
  return Body(Shape(body.shape.shared_mesh(), {.build = build, .keep_tree = true}), body.pose);
}

/// Sums over pairs of bodies whose boxes meet, by a query of the library for each.
CountedStep by_library(const ViewScene& scene) {
  std::vector<BodyRef> bodies;
  for (std::uint32_t k = 0; k < scene.city_parts(); ++k) {
    bodies.push_back(city_part(k));
  }
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    bodies.push_back(mover(k));
  }
  CountedStep sum;
  for (std::size_t m = scene.city_parts(); m < bodies.size(); ++m) {
    for (std::size_t k = 0; k < m; ++k) {
      if (bodies.size() > 2 && !overlaps(scene.bounds(bodies[k]), scene.bounds(bodies[m]))) {
        continue;
      }
      const BuildOptions& build = scene.trees().build;
      const auto [answer, counts] =
          thesis::overlap(with_tree(scene.body(bodies[k]), build),
                          with_tree(scene.body(bodies[m]), build), scene.trees().traversal);
      sum.cost += answer.cost;
      sum.counts += counts;
      ++sum.queries;
    }
  }
  return sum;
}

void expect_as_library(ViewScene& scene, StepCounter& counter) {
  const std::optional<CountedStep> step = counter.find(scene);
  ASSERT_TRUE(step);
  const CountedStep expected = by_library(scene);
  EXPECT_EQ(step->cost, expected.cost);
  EXPECT_EQ(step->counts, expected.counts);
  EXPECT_EQ(step->queries, expected.queries);
  EXPECT_EQ(step->touches, scene.contacts());
  EXPECT_FALSE(step->cut);
}

TEST(CountedStep, IsThatOfTheLibraryForEachTraversal) {
  ViewScene knots = two_knots();
  ViewScene blocks = wall_and_blocks();
  ASSERT_FALSE(knots.contacts().empty());
  ASSERT_FALSE(blocks.contacts().empty());
  StepCounter of_knots;
  StepCounter of_blocks;
  for (const TraversalEntry& row : traversals().subspan(1)) {  // all but `fast`
    SCOPED_TRACE(row.name);
    knots.set_trees(by(row.traversal));
    blocks.set_trees(by(row.traversal));
    expect_as_library(knots, of_knots);
    expect_as_library(blocks, of_blocks);
    EXPECT_GE(of_blocks.find(blocks)->queries, 4U);
  }
}

TEST(CountedStep, FollowsPosesFromStepToStep) {
  ViewScene scene = two_knots();
  StepCounter counter;
  for (const Traversal traversal : {Traversal::larger, Traversal::e_node_front}) {
    scene.set_trees(by(traversal));
    for (const double x : {0.9, 0.5, 9.0}) {
      scene.set_pose(0, Pose::about_z(0.3, {x, 0.2, 0}));
      expect_as_library(scene, counter);
    }
    EXPECT_EQ(counter.find(scene)->counts.box_tests, 1U);  // apart at the roots
  }
}

TEST(CountedStep, FollowsTheTrees) {
  ViewScene scene = two_knots();
  StepCounter counter;
  scene.set_trees(by(Traversal::e_node));
  expect_as_library(scene, counter);
  const std::uint64_t before = counter.find(scene)->counts.box_tests;
  TreeChoice thesis = by(Traversal::e_node, thesis_options(Rule::soms));
  thesis.traversal.descent = Descent::both;
  scene.set_trees(thesis);
  expect_as_library(scene, counter);
  EXPECT_GT(counter.find(scene)->counts.box_tests, 2 * before);
}

TEST(CountedStep, IsNoneOfFast) {
  ViewScene scene = two_knots();
  StepCounter counter;
  scene.set_trees(by(Traversal::fast));
  EXPECT_FALSE(counter.find(scene));
  scene.set_trees(by(Traversal::larger));
  EXPECT_TRUE(counter.find(scene));
  scene.set_trees(by(Traversal::fast));
  EXPECT_FALSE(counter.find(scene));
}

TEST(CountedStep, IsCutWherePatienceEnds) {
  ViewScene scene = two_knots();
  StepCounter counter;
  counter.set_patience(std::chrono::seconds(0));
  scene.set_trees(by(Traversal::larger));
  EXPECT_TRUE(counter.find(scene)->cut);
}

TEST(CountedStep, OfAnEmptyMoverIsEmpty) {
  ViewScene scene(two_bodies(Body(Shape(generate_knot(30))), Body(Shape(Mesh{}))));
  StepCounter counter;
  scene.set_trees(by(Traversal::larger));
  EXPECT_TRUE(counter.find(scene)->touches.empty());
}

}  // namespace
}  // namespace soms::view
