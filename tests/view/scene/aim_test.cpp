#include "apps/view/scene/aim.h"

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

/// The camera's direction from an aim at a point.
Vec3 side_of(const ViewScene& scene, const Vec3& point, const Sides& sides) {
  const Vec3 half{0.5, 0.5, 0.5};
  const Aim aim{{point}, {point - half, point + half}, {}};
  const FitCamera fit = [](const Box& box, const Vec3& toward) {
    return fitted(box, toward, {300, 200});
  };
  const Camera camera = aimed_camera(scene, {&aim, 1}, sides, fit).camera;
  return (camera.eye - camera.target) * (1 / distance_to_target(camera));
}

TEST(Aim, LooksIntoAYardThroughItsOpenSide) {
  for (const Vec3& open : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
    const Vec3 toward = side_of(yard(open), {0, 0, 1}, {});
    EXPECT_GT(dot(toward, open), 0.4);
    EXPECT_GT(toward.z, 0);
  }
}

TEST(Aim, KeepsTheFirstSideWhereAllAreOpenAndANamedOne) {
  const ViewScene scene = yard({1, 0, 0});
  const Vec3 named = toward_eye(90, 10);
  EXPECT_GT(dot(side_of(scene, {500, 0, 1}, {}), toward_eye(215, 25)), 0.999);
  EXPECT_GT(dot(side_of(scene, {0, 0, 1}, {90, 10, false}), named), 0.999);
}

}  // namespace
}  // namespace soms::view
