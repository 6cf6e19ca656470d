#include "apps/view/scene/open_side.h"

#include "apps/view/scene/load.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <array>

namespace soms::view {
namespace {

/// A yard with walls on three sides: the fourth, toward `open`, is free. Nothing is above.
ViewScene yard(const Vec3& open) {
  SceneContent content;
  for (const Vec3& side : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
    if (side != open) {
      const Vec3 middle = side * 3;
      const Vec3 half{side.x != 0 ? 0.2 : 4, side.y != 0 ? 0.2 : 4, 60};
      content.city.emplace_back(test::box_body(middle - half, middle + half, 1));
    }
  }
  return ViewScene(std::move(content));
}

TEST(OpenSide, LooksIntoAYardThroughItsOpenSide) {
  for (const Vec3& open : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
    const ViewScene scene = yard(open);
    const Vec3 toward = open_side(scene, {0, 0, 1}, 0.5, 20);
    EXPECT_GT(dot(toward, open), 0.4);
    EXPECT_GT(toward.z, 0);
  }
}

TEST(OpenSide, IsACornerWhereAllIsOpen) {
  const ViewScene scene = yard({1, 0, 0});
  const Vec3 toward = open_side(scene, {500, 0, 1}, 0.5, 20);
  EXPECT_GT(toward.x, 0);
  EXPECT_LT(toward.y, 0);
}

}  // namespace
}  // namespace soms::view
