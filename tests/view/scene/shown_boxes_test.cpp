#include "apps/view/scene/shown_boxes.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/build.h"

#include "apps/view/scene/load.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soms::view {
namespace {

ViewScene knots() {
  return ViewScene(two_bodies(Body(generate_knot(400)), Body(generate_knot(400))));
}

ViewOptions level_options(BodyRef body, int level, bool leaves_above = false) {
  ViewOptions options;
  options.trees.build = thesis_options(Rule::soms);
  options.level = LevelBoxes{.body = body, .level = level, .leaves_above = leaves_above};
  return options;
}

/// Boxes of the nodes whose TreeID has a depth, without the code that is tested.
std::vector<Box> boxes_at_depth(const Tree& tree, int depth) {
  std::vector<Box> boxes;
  for (const Node& node : tree.nodes) {
    if (depth_of(node.id) == depth) {
      boxes.push_back(node.bounds);
    }
  }
  return boxes;
}

TEST(ShownBoxes, OfALevelAreThoseOfTheTree) {
  ViewScene scene = knots();
  const Tree tree = build(generate_knot(400), thesis_options(Rule::soms));
  for (const int level : {1, 3, 5, 6, 9, 12}) {
    const ViewOptions options = level_options(city_part(0), level);
    scene.set_trees(options.trees);
    const ShownBoxes shown = shown_boxes(scene, options);
    ASSERT_EQ(shown.groups.size(), 1U);
    const std::vector<Box> expected = boxes_at_depth(tree, level - 1);
    ASSERT_EQ(shown.groups[0].boxes.size(), expected.size());
    EXPECT_EQ(shown.boxes, expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_EQ(shown.groups[0].boxes[k].box, expected[k]);
    }
  }
}

TEST(ShownBoxes, WithLeavesAboveHoldEveryTriangle) {
  ViewScene scene = knots();
  const ViewOptions options = level_options(city_part(0), 9, true);
  scene.set_trees(options.trees);
  const Tree& tree = scene.tree(city_part(0));
  std::uint64_t triangles = 0;
  for (const std::uint32_t n : nodes_of_level(tree, 9, true)) {
    triangles += tree.nodes[n].count;
  }
  EXPECT_EQ(triangles, 400U);
  EXPECT_EQ(shown_boxes(scene, options).boxes, nodes_of_level(tree, 9, true).size());
}

TEST(ShownBoxes, OfAMoverFollowItsPoseWithoutANewUpload) {
  ViewScene scene = knots();
  const ViewOptions options = level_options(mover(0), 4);
  scene.set_trees(options.trees);
  scene.set_pose(0, Pose::translation(3, 0, 0));
  const BoxGroup before = shown_boxes(scene, options).groups[0];
  scene.set_pose(0, Pose::about_z(1, {3, 1, 0}));
  const BoxGroup after = shown_boxes(scene, options).groups[0];
  EXPECT_EQ(before.key, after.key);
  EXPECT_EQ(before.version, after.version);
  EXPECT_EQ(after.pose, Pose::about_z(1, {3, 1, 0}));
  const BoxGroup deeper = shown_boxes(scene, level_options(mover(0), 5)).groups[0];
  EXPECT_NE(deeper.version, after.version);
}

TEST(ShownBoxes, OfATraversalAreTheBoxesThatItTested) {
  ViewScene scene = knots();
  scene.set_pose(0, Pose::about_z(0.5, {1.1, 0.2, 0}));
  ViewOptions options;
  options.trace = TraceBoxes{};
  for (const Traversal traversal :
       {Traversal::larger, Traversal::simultaneous, Traversal::e_node}) {
    options.trees.traversal = {.traversal = traversal};
    scene.set_trees(options.trees);
    const ShownBoxes shown = shown_boxes(scene, options);
    ASSERT_EQ(shown.groups.size(), 6U);
    const TraversalTrace& trace = scene.trace();
    for (const bool first : {true, false}) {
      const std::vector<Fate>& fates = first ? trace.a : trace.b;
      const auto boxes = scene.world_boxes(first ? city_part(0) : mover(0));
      const std::size_t group = first ? 0 : 3;
      const auto expect_boxes = [&](std::size_t k, Fate fate, Color color) {
        std::vector<Box> expected;
        for (std::size_t n = 0; n < fates.size(); ++n) {
          if (fates[n] == fate) {
            expected.push_back(boxes[n]);
          }
        }
        ASSERT_EQ(shown.groups[group + k].boxes.size(), expected.size());
        for (std::size_t n = 0; n < expected.size(); ++n) {
          EXPECT_EQ(shown.groups[group + k].boxes[n].box, expected[n]);
          EXPECT_EQ(shown.groups[group + k].boxes[n].color, color);
        }
      };
      expect_boxes(0, Fate::pruned, options.colors.pruned);
      expect_boxes(1, Fate::visited, options.colors.visited);
      expect_boxes(2, Fate::found, options.colors.found);
    }
    EXPECT_EQ(scene.statistics().trace, trace.counts);
  }
}

TEST(ShownBoxes, AreTheSameForBothTreesOnlyWhereWanted) {
  ViewScene scene = knots();
  ViewOptions options;
  options.trace = TraceBoxes{.visited = false, .pruned = false, .found = true, .city = false};
  const ShownBoxes shown = shown_boxes(scene, options);
  ASSERT_EQ(shown.groups.size(), 1U);
  EXPECT_EQ(shown.groups[0].boxes.size(), count_fates(scene.trace().b).found);
}

TEST(ShownBoxes, AreCutToTheLargestAndCounted) {
  ViewScene scene = knots();
  ViewOptions options = level_options(city_part(0), 7);
  options.most_boxes = 10;
  scene.set_trees(options.trees);
  const ShownBoxes shown = shown_boxes(scene, options);
  ASSERT_EQ(shown.groups[0].boxes.size(), 10U);
  const Tree& tree = scene.tree(city_part(0));
  EXPECT_EQ(shown.boxes, nodes_of_level(tree, 7, false).size());
  const double least = half_area(shown.groups[0].boxes.back().box);
  std::size_t larger = 0;
  for (const std::uint32_t n : nodes_of_level(tree, 7, false)) {
    larger += half_area(tree.nodes[n].bounds) > least ? 1U : 0U;
  }
  EXPECT_LT(larger, 10U);
}

TEST(ShownBoxes, RefuseALevelBelowTheFirst) {
  ViewScene scene = knots();
  EXPECT_THROW((void)shown_boxes(scene, level_options(city_part(0), 0)), Error);
  EXPECT_THROW((void)shown_boxes(scene, level_options(city_part(7), 1)), Error);
}

}  // namespace
}  // namespace soms::view
