#include "apps/view/control/camera_moves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soms::view {
namespace {

constexpr Size kSize{960, 540};

double apart(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return std::sqrt(dot(d, d));
}

Camera camera_at(const Vec3& eye) {
  Camera camera;
  camera.eye = eye;
  return camera;
}

TEST(CameraMoves, OrbitingKeepsPivotAndDistance) {
  const Camera camera = camera_at({3, -8, 4});
  const Camera moved = dragged(camera, CameraMode::orbit, CameraDrag::turn, 80, -30, kSize);
  EXPECT_EQ(moved.target, camera.target);
  EXPECT_NEAR(distance_to_target(moved), distance_to_target(camera), 1e-9);
  EXPECT_GT(apart(moved.eye, camera.eye), 0.5);
}

TEST(CameraMoves, OrbitTurnsTheSceneWithTheMouse) {
  // What faces the eye follows the mouse: to the right and down.
  const Camera camera = camera_at({0, -10, 0});
  const Vec3 nearest{0, -1, 0};
  const Camera right = dragged(camera, CameraMode::orbit, CameraDrag::turn, 40, 0, kSize);
  EXPECT_GT(project(right, kSize, nearest)->pixel.x, project(camera, kSize, nearest)->pixel.x);
  const Camera down = dragged(camera, CameraMode::orbit, CameraDrag::turn, 0, 40, kSize);
  EXPECT_GT(project(down, kSize, nearest)->pixel.y, project(camera, kSize, nearest)->pixel.y);
}

TEST(CameraMoves, FlyingLooksAroundFromWhereItIs) {
  const Camera camera = camera_at({0, -10, 0});
  const Camera moved = dragged(camera, CameraMode::fly, CameraDrag::turn, 50, -50, kSize);
  EXPECT_EQ(moved.eye, camera.eye);
  EXPECT_GT(frame(moved).forward.x, 0.05);  // to the right
  EXPECT_GT(frame(moved).forward.z, 0.05);  // and up
}

TEST(CameraMoves, PanKeepsTheTargetUnderTheMouse) {
  const Camera camera = camera_at({3, -8, 4});
  const Camera moved = dragged(camera, CameraMode::orbit, CameraDrag::pan, 100, 60, kSize);
  const auto seen = project(moved, kSize, camera.target);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->pixel.x, 480 + 100, 1e-6);
  EXPECT_NEAR(seen->pixel.y, 270 + 60, 1e-6);
}

TEST(CameraMoves, DollyByDraggingGoesNearerUpward) {
  const Camera camera = camera_at({0, -10, 0});
  EXPECT_LT(
      distance_to_target(dragged(camera, CameraMode::orbit, CameraDrag::dolly, 0, -50, kSize)), 10);
  const Camera there = dragged(camera, CameraMode::orbit, CameraDrag::dolly, 0, -50, kSize);
  const Camera back = dragged(there, CameraMode::orbit, CameraDrag::dolly, 0, 50, kSize);
  EXPECT_NEAR(distance_to_target(back), 10, 1e-9);
}

TEST(CameraMoves, WheelKeepsWhatLiesUnderTheCursor) {
  const Camera camera = camera_at({3, -8, 4});
  const PixelPoint cursor{700, 130};
  for (const double depth : {4.0, 30.0}) {
    const Ray ray = ray_through(camera, kSize, cursor);
    const Vec3 under = ray.origin + ray.direction * depth;
    const Camera moved = wheeled(camera, CameraMode::orbit, 2, cursor, kSize, under);
    const auto seen = project(moved, kSize, under);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->pixel.x, cursor.x, 1e-6);
    EXPECT_NEAR(seen->pixel.y, cursor.y, 1e-6);
    EXPECT_LT(apart(moved.eye, under), apart(camera.eye, under));
  }
}

TEST(CameraMoves, WheelWithoutASurfaceUsesThePlaneOfTheTarget) {
  const Camera camera = camera_at({0, -10, 0});
  const PixelPoint cursor{600, 200};
  const Ray ray = ray_through(camera, kSize, cursor);
  const Vec3 on_plane = ray.origin + ray.direction * (10 / ray.direction.y);
  const Camera moved = wheeled(camera, CameraMode::orbit, 1, cursor, kSize, std::nullopt);
  const auto seen = project(moved, kSize, on_plane);
  EXPECT_NEAR(seen->pixel.x, cursor.x, 1e-6);
  EXPECT_NEAR(distance_to_target(moved), 8.5, 1e-9);
  const Camera back = wheeled(moved, CameraMode::orbit, -1, cursor, kSize, std::nullopt);
  EXPECT_LT(apart(back.eye, camera.eye), 1e-9);
}

TEST(CameraMoves, ZoomEndsAndComesBackFromBeyondItsEnds) {
  const ZoomEnds ends{1, 100};
  const auto wheel = [&](double from, double notches) {
    return distance_to_target(wheeled(camera_at({0, -from, 0}), CameraMode::orbit, notches,
                                      {480, 270}, kSize, std::nullopt, ends));
  };
  const auto drag = [&](double from, double down) {
    return distance_to_target(dragged(camera_at({0, -from, 0}), CameraMode::orbit,
                                      CameraDrag::dolly, 0, down, kSize, ends));
  };
  for (const double much : {60.0, 1e4, 1e9}) {
    EXPECT_NEAR(wheel(10, much), 1, 1e-9);
    EXPECT_NEAR(wheel(10, -much), 100, 1e-9);
    EXPECT_NEAR(drag(10, -1e3 * much), 1, 1e-9);
    EXPECT_NEAR(drag(10, 1e3 * much), 100, 1e-9);
  }
  EXPECT_NEAR(wheel(300, -1), 300, 1e-9);
  EXPECT_NEAR(wheel(300, 1), 255, 1e-9);
  EXPECT_NEAR(wheel(0.5, 1), 0.5, 1e-9);
  EXPECT_NEAR(wheel(0.5, -1), 0.5 / 0.85, 1e-9);
}

TEST(CameraMoves, ZoomEndsWhereDoublesAtThePlaceEnd) {
  EXPECT_EQ(zoom_ends(200, {}).nearest, 200 * 1e-9);
  EXPECT_EQ(zoom_ends(200, {}).farthest, 200 * 1e4);
  EXPECT_EQ(zoom_ends(200, {0, -3e7, 0}).nearest, 3e7 * 1e-12);
  EXPECT_GT(zoom_ends(0, {}).nearest, 0);
}

TEST(CameraMoves, WheelFliesForward) {
  const Camera camera = camera_at({0, -10, 0});
  const Camera moved = wheeled(camera, CameraMode::fly, 1, {10, 10}, kSize, Vec3{5, 5, 5});
  EXPECT_LT(apart(moved.eye, {0, -8.5, 0}), 1e-9);
  EXPECT_NEAR(distance_to_target(moved), 10, 1e-9);
}

TEST(CameraMoves, HeldKeysFlyAtASpeedOfTheScene) {
  const Camera camera = camera_at({0, -10, 0});
  FlyKeys keys;
  EXPECT_FALSE(keys.any());
  keys.forward = true;
  keys.right = true;
  EXPECT_TRUE(keys.any());
  const Camera moved = flown(camera, keys, 0.5, 200);
  EXPECT_LT(apart(moved.eye, {10, 0, 0}), 1e-9);
  keys.fast = true;
  EXPECT_LT(apart(flown(camera, keys, 0.5, 200).eye, {50, 40, 0}), 1e-9);
  keys.backward = true;
  keys.left = true;
  EXPECT_LT(apart(flown(camera, keys, 0.5, 200).eye, camera.eye), 1e-9);
}

TEST(CameraMoves, SidesLookWhereTheySay) {
  const Box box{{-50, -20, 0}, {50, 20, 30}};
  EXPECT_GT(frame(seen_from(box, Side::front, kSize, 0.8)).forward.y, 0.99);
  EXPECT_LT(frame(seen_from(box, Side::right, kSize, 0.8)).forward.x, -0.99);
  const CameraFrame top = frame(seen_from(box, Side::top, kSize, 0.8));
  EXPECT_LT(top.forward.z, -0.99);
  EXPECT_GT(top.up.y, 0.99);  // a map: north is up
  EXPECT_LT(frame(seen_from(box, Side::corner, kSize, 0.8)).forward.z, -0.3);
}

TEST(CameraMoves, AFlightEndsExactlyAtItsGoal) {
  const Camera from = camera_at({0, -10, 0});
  const Camera to = camera_at({40, 0, 3});
  CameraFlight flight(from, to);
  const Camera middle = flight.after(0.1);
  EXPECT_FALSE(flight.over());
  EXPECT_GT(apart(middle.eye, from.eye), 0);
  EXPECT_GT(apart(middle.eye, to.eye), 0);
  EXPECT_EQ(flight.after(5), to);
  EXPECT_TRUE(flight.over());
}

}  // namespace
}  // namespace soms::view
