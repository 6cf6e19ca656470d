#include "thesis/pictures/side_view.h"

#include <gtest/gtest.h>

#include <array>

namespace soms::reproduce {
namespace {

constexpr Box kShown{{-1, -1, -2}, {3, 1, 2}};  // center (1, 0, 0)
const PagePlace kPlace{{10, 20}, 400, 100};

TEST(SideView, PutsTheMiddleInTheMiddleAndKeepsProportions) {
  const SideView view(Side::front, kShown, kPlace);  // 4 by 2 units on 400 by 100: 50 a unit
  const Spot middle = view({1, 0, 5});
  EXPECT_EQ(middle.x, 210);
  EXPECT_EQ(middle.y, 70);
  const Spot corner = view({3, 1, 0});
  EXPECT_EQ(corner.x, 310);
  EXPECT_EQ(corner.y, 20);
}

TEST(SideView, LooksFromTheRightWithMinusZAtTheRight) {
  const SideView view(Side::right, kShown, kPlace);
  EXPECT_EQ(view({0, 0, -2}).x, 310);
  EXPECT_EQ(view({9, 0, -2}).x, 310);
}

TEST(SideView, ShowsTrianglesThatFaceTheViewerOnly) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  const SideView view(Side::front, kShown, kPlace);
  const std::string one = "M160.0,70.0L210.0,70.0L160.0,20.0Z";
  EXPECT_EQ(view.facing(mesh, {}), one);
  const std::array<TriangleId, 1> second{1};
  EXPECT_EQ(view.triangles(mesh, second, {1, 0, 0}), "M210.0,70.0L210.0,20.0L260.0,70.0Z");
}

TEST(SideView, OutlinesBoxes) {
  const SideView view(Side::front, kShown, kPlace);
  EXPECT_EQ(view.box({{0, 0, 0}, {1, 1, 1}}), "M160.0,70.0L210.0,70.0L210.0,20.0L160.0,20.0Z");
  EXPECT_EQ(view.box(Box{}), "");
}

}  // namespace
}  // namespace soms::reproduce
