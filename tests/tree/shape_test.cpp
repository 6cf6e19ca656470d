#include "soms/tree/shape.h"

#include "soms/base/error.h"
#include "soms/tree/build.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include "tests/tree/inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace soms {
namespace {

Mesh two_triangles() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 2}, {9, 9, 9}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(Shape, HoldsMeshAndBounds) {
  const Shape shape(two_triangles());
  EXPECT_EQ(shape.mesh(), two_triangles());
  EXPECT_EQ(shape.bounds(), bounds(two_triangles()));
  EXPECT_EQ(shape.layout().blocks().size(), 1U);
  EXPECT_GE(shape.memory(), sizeof(WideNode) + sizeof(TriangleBlock) + 5 * sizeof(Vec3));
}

TEST(Shape, KeepsTheCanonicalTreeWhenRequested) {
  EXPECT_EQ(Shape(two_triangles()).tree(), nullptr);
  ShapeOptions options;
  options.keep_tree = true;
  options.build.rule = Rule::soms;
  const Shape shape(two_triangles(), options);
  ASSERT_NE(shape.tree(), nullptr);
  EXPECT_EQ(*shape.tree(), build(two_triangles(), options.build));
  EXPECT_EQ(shape.build_options(), options.build);
}

TEST(Shape, ReportsProgressInOrder) {
  const Mesh mesh = test::make_input(test::Input::random, 60000);
  for (const bool keep_tree : {false, true}) {
    std::vector<double> shares;
    const Limits watched{.progress = [&](double share) { shares.push_back(share); }};
    EXPECT_EQ(Shape(mesh, {.keep_tree = keep_tree}, watched).bounds(), bounds(mesh));
    ASSERT_GT(shares.size(), 5U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end())) << keep_tree;
    EXPECT_EQ(shares.back(), 1) << keep_tree;
  }
}

TEST(Shape, IsSharedByItsCopies) {
  const Shape shape(two_triangles());
  const std::vector<Shape> copies(2, shape);
  EXPECT_EQ(&copies[0].mesh(), &shape.mesh());
  EXPECT_EQ(&copies[1].layout(), &shape.layout());
}

TEST(Shape, IsEmptyWithoutTriangles) {
  EXPECT_TRUE(Shape().bounds().empty());
  EXPECT_TRUE(Shape().layout().nodes().empty());
  EXPECT_TRUE(Shape(Mesh{}).bounds().empty());
}

TEST(Shape, RefusesMeshesThatAreUnfit) {
  Mesh mesh = two_triangles();
  mesh.vertices[1].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Shape{mesh}, Error);
  mesh = two_triangles();
  mesh.triangles[1][0] = 5;
  EXPECT_THROW(Shape{mesh}, Error);
}

}  // namespace
}  // namespace soms
