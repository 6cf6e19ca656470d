#include "thesis/pictures/tree_pictures.h"

#include "soms/tree/build.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soms::reproduce {
namespace {

/// Triangles in a row along x.
Mesh row(std::uint32_t count) {
  Mesh mesh;
  for (std::uint32_t k = 0; k < count; ++k) {
    const double x = 10.0 * k;
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  return mesh;
}

TEST(TreePictures, CountTheNodesOfALevelAndTheLeavesAbove) {
  const Tree tree = build(row(3), thesis_options(Rule::soms));
  const LevelCount root = count_level(tree, 1);
  EXPECT_EQ(root.nodes, 1);
  EXPECT_EQ(root.ended, 0);
  EXPECT_EQ(root.most, 3);
  EXPECT_EQ(root.fewest, 3);
  const LevelCount last = count_level(tree, 3);
  EXPECT_EQ(last.nodes, 2);
  EXPECT_EQ(last.ended, 1);
  EXPECT_EQ(last.most, 1);
  const LevelCount below = count_level(tree, 9);
  EXPECT_EQ(below.nodes, 0);
  EXPECT_EQ(below.ended, 3);
  EXPECT_EQ(count_level(Tree(), 1).fewest, 0);
}

TEST(TreePictures, DrawTheLevelAndDashTheLeavesAbove) {
  const Mesh mesh = row(3);
  const Tree tree = build(mesh, thesis_options(Rule::soms));
  const Panel panel = level_panel(mesh, tree, 3, "title");
  ASSERT_EQ(panel.boxes.size(), 3U);
  EXPECT_EQ(std::count_if(panel.boxes.begin(), panel.boxes.end(),
                          [](const DrawnBox& box) { return box.dashed; }),
            1);
  EXPECT_EQ(panel.note, "2 boxes and 1 leaf above: 1 triangle each");
}

}  // namespace
}  // namespace soms::reproduce
