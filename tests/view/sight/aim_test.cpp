#include "apps/view/sight/aim.h"

#include "apps/view/scene/load.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

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

/// Two boxes that touch on a ground, in a shed that hides them from every side.
ViewScene in_a_shed() {
  SceneContent content;
  content.city.emplace_back(test::box_body({-60, -60, -1}, {60, 60, 0}, 1));
  for (const Vec3& side : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
    const Vec3 middle = side * 6;
    const Vec3 half{side.x != 0 ? 0.2 : 6, side.y != 0 ? 0.2 : 6, 6};
    content.city.emplace_back(test::box_body(middle - half, middle + half, 1));
  }
  content.city.emplace_back(test::box_body({-6, -6, 6}, {6, 6, 6.2}, 1));
  for (const double x : {0.0, 1.5}) {
    content.movers.push_back({Body(Shape(test::box_body({x, 0, 0.5}, {x + 2, 2, 2}, 1))), {}});
  }
  return ViewScene(std::move(content));
}

TEST(Aim, CutsNeitherTheBodiesThatTouchNorTheGround) {
  const ViewScene scene = in_a_shed();
  std::vector<Touch> touches;
  for (const Touch& touch : scene.contacts()) {
    if (touch.a.role == Role::mover && touch.b.role == Role::mover) {
      touches.push_back(touch);
    }
  }
  ASSERT_FALSE(touches.empty());
  PartBoxes part_boxes(scene);
  const Aim aim = aim_at_touches(scene, touches[0].a, touches, part_boxes);
  EXPECT_TRUE(aim.whole.contains(scene.bounds(touches[0].a)));
  EXPECT_TRUE(aim.whole.contains(scene.bounds(touches[0].b)));
  const FitCamera fit = [](const Box& box, const Vec3& toward) {
    return fitted(box, toward, {300, 200});
  };
  const Camera camera = aimed_camera(scene, {&aim, 1}, {.may_cut = true}, fit).camera;
  ASSERT_GT(camera.cut, 0) << "the walls hide them";
  const CameraFrame axes = frame(camera);
  const auto depth = [&](const Vec3& p) { return dot(p - camera.eye, axes.forward); };
  for (const double x : {0.0, 3.5}) {
    for (const double y : {0.0, 2.0}) {
      for (const double z : {0.5, 2.0}) {
        EXPECT_GE(depth({x, y, z}), camera.cut);
      }
    }
  }
  // The lowest ray of the picture meets the ground beyond the cut.
  const Vec3 lowest = axes.forward - axes.up * std::tan(camera.field_of_view / 2);
  ASSERT_LT(lowest.z, 0);
  EXPECT_GE(-camera.eye.z / lowest.z, camera.cut);
}

}  // namespace
}  // namespace soms::view
