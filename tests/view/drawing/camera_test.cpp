#include "apps/view/drawing/camera.h"

#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace soms::view {
namespace {

constexpr double kPi = std::numbers::pi;

double length(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-9) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

Vec3 random_point(Rng& rng, double reach) {
  return {rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
}

Camera random_camera(Rng& rng) {
  Camera camera;
  camera.eye = random_point(rng, 100);
  camera.target = random_point(rng, 100);
  camera.field_of_view = rng.uniform(0.2, 2.0);
  return camera;
}

TEST(Camera, SeesASceneHoweverSmallItIs) {
  for (const double half : {1e-20, 1e-40, 1e-200, 1e-290}) {
    const Box box{{-half, -half, -half}, {half, half, half}};
    const Camera camera = fitted(box, {0, -1, 0}, {640, 480}, 0.8);
    expect_near(frame(camera).forward, {0, 1, 0});
    const DepthRange range = depth_range(camera, box);
    EXPECT_LT(range.near, distance_to_target(camera)) << half;
    EXPECT_GT(range.far, distance_to_target(camera)) << half;
  }
}

TEST(Camera, LooksNorthWithEastToTheRight) {
  const CameraFrame f = frame({{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 0.8});
  expect_near(f.forward, {0, 1, 0});
  expect_near(f.right, {1, 0, 0});
  expect_near(f.up, {0, 0, 1});
}

TEST(Camera, HasAFrameAtThePolesAndOnItsTarget) {
  const CameraFrame down = frame({{0, 0, 10}, {0, 0, 0}, {0, 0, 1}, 0.8});
  expect_near(down.right, {1, 0, 0});
  expect_near(down.up, {0, 1, 0});
  const CameraFrame nowhere = frame({{3, 3, 3}, {3, 3, 3}, {0, 0, 1}, 0.8});
  EXPECT_NEAR(length(nowhere.forward), 1, 1e-12);
  EXPECT_NEAR(dot(nowhere.forward, nowhere.right), 0, 1e-12);
}

TEST(Camera, FrameIsOrthonormalWhereverItStands) {
  test::for_each_case("camera/frame", 500, [](Rng& rng) {
    const CameraFrame f = frame(random_camera(rng));
    expect_near(cross(f.right, f.up), f.forward * -1, 1e-9);
    EXPECT_NEAR(length(f.right), 1, 1e-9);
    EXPECT_NEAR(length(f.up), 1, 1e-9);
  });
}

TEST(Camera, ProjectsThePointsOfARayToItsPixel) {
  test::for_each_case("camera/ray", 500, [](Rng& rng) {
    const Camera camera = random_camera(rng);
    const Size size{640, 480};
    const PixelPoint pixel{rng.uniform(0, 640), rng.uniform(0, 480)};
    const Ray ray = ray_through(camera, size, pixel);
    EXPECT_NEAR(length(ray.direction), 1, 1e-12);
    const auto seen = project(camera, size, ray.origin + ray.direction * rng.uniform(0.5, 1000));
    ASSERT_TRUE(seen.has_value());
    EXPECT_NEAR(seen->pixel.x, pixel.x, 1e-6);
    EXPECT_NEAR(seen->pixel.y, pixel.y, 1e-6);
  });
}

TEST(Camera, SeesItsTargetInTheMiddleAndNothingBehind) {
  const Camera camera{{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 0.8};
  const auto middle = project(camera, {100, 60}, {0, 0, 0});
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(middle->pixel.x, 50, 1e-9);
  EXPECT_NEAR(middle->pixel.y, 30, 1e-9);
  EXPECT_NEAR(middle->depth, 10, 1e-9);
  EXPECT_FALSE(project(camera, {100, 60}, {0, -11, 0}).has_value());
  const auto upper = project(camera, {100, 60}, {0, 0, 1});
  EXPECT_LT(upper->pixel.y, 30) << "rows count downward";
}

TEST(Camera, OrbitsAtAnEvenDistanceAndStopsBeforeThePoles) {
  test::for_each_case("camera/orbit", 500, [](Rng& rng) {
    const Camera before = random_camera(rng);
    const Camera after = orbited(before, rng.uniform(-4, 4), rng.uniform(-4, 4));
    EXPECT_EQ(after.target, before.target);
    EXPECT_NEAR(distance_to_target(after), distance_to_target(before), 1e-9);
    EXPECT_LT(std::abs(frame(after).forward.z), 1);
  });
  const Camera quarter = orbited({{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 0.8}, kPi / 2, 0);
  expect_near(quarter.eye, {10, 0, 0});
  const Camera above = orbited({{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 0.8}, 0, 0.5);
  EXPECT_GT(above.eye.z, 0);
}

TEST(Camera, TurnsAboutItsEye) {
  const Camera left = turned({{0, 0, 0}, {0, 10, 0}, {0, 0, 1}, 0.8}, kPi / 2, 0);
  expect_near(left.target, {-10, 0, 0});
  const Camera up = turned({{0, 0, 0}, {0, 10, 0}, {0, 0, 1}, 0.8}, 0, 0.3);
  EXPECT_GT(up.target.z, 0);
  EXPECT_EQ(up.eye, (Vec3{0, 0, 0}));
}

TEST(Camera, PanKeepsThePointUnderThePointer) {
  test::for_each_case("camera/pan", 200, [](Rng& rng) {
    const Camera before = random_camera(rng);
    const Size size{800, 600};
    const double dx = rng.uniform(-100, 100);
    const double dy = rng.uniform(-100, 100);
    const Camera after = panned(before, -dx / size.height, dy / size.height);
    const auto seen = project(after, size, before.target);
    EXPECT_NEAR(seen->pixel.x, 400 + dx, 1e-6);
    EXPECT_NEAR(seen->pixel.y, 300 + dy, 1e-6);
  });
}

TEST(Camera, DolliesFliesAndTakesAPivot) {
  const Camera camera{{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 0.8};
  expect_near(dollied(camera, 0.5).eye, {0, -5, 0});
  const Camera flight = flown(camera, 1, 2, 3);
  expect_near(flight.eye, {1, -8, 3});
  expect_near(flight.target, {1, 2, 3});
  const Camera other = pivoted(camera, {5, 5, 5});
  expect_near(other.target, {5, 5, 5});
  expect_near(frame(other).forward, frame(camera).forward);
}

TEST(Camera, FollowsABodyThroughItsTurns) {
  const Camera camera{{0, -10, 2}, {0, 0, 0}, {0, 0, 1}, 0.8};
  const Pose before = Pose::about_z(0.3, {4, 5, 0});
  const Pose after = Pose::about_z(1.1, {-3, 8, 0});
  const Camera moved = followed(camera, before, after);
  EXPECT_NEAR(distance_to_target(moved), distance_to_target(camera), 1e-9);
  const Camera back = followed(moved, after, before);
  expect_near(back.eye, camera.eye);
  expect_near(back.target, camera.target);
}

TEST(Camera, FliesFromOneViewToAnother) {
  const Camera a{{0, -10, 2}, {0, 0, 0}, {0, 0, 1}, 0.8};
  const Camera b{{100, 90, 20}, {100, 100, 0}, {0, 0, 1}, 1.0};
  EXPECT_EQ(between(a, b, 0), a);
  EXPECT_EQ(between(a, b, 1), b);
  expect_near(between(a, b, 0.5).target, {50, 50, 0});
  const Camera opposite{{0, 10, 2}, {0, 0, 0}, {0, 0, 1}, 0.8};
  EXPECT_GT(distance_to_target(between(a, opposite, 0.5)), 1);
}

TEST(Camera, FitsABoxSoThatAllCornersShowAndOneIsNearAnEdge) {
  test::for_each_case("camera/fit", 300, [](Rng& rng) {
    Box box;
    box.grow(random_point(rng, 1e6));
    box.grow(random_point(rng, 1e6));
    const Size size{static_cast<int>(rng.uniform(100, 1000)),
                    static_cast<int>(rng.uniform(100, 1000))};
    const Camera camera = fitted(box, random_point(rng, 1), size);
    double nearest_edge = 1;
    for (int i = 0; i < 8; ++i) {
      const Vec3 p{i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                   i & 4 ? box.upper.z : box.lower.z};
      const auto seen = project(camera, size, p);
      ASSERT_TRUE(seen.has_value());
      const double x = std::abs(seen->pixel.x / size.width - 0.5);
      const double y = std::abs(seen->pixel.y / size.height - 0.5);
      EXPECT_LE(std::max(x, y), 0.5);
      nearest_edge = std::min(nearest_edge, 0.5 - std::max(x, y));
    }
    EXPECT_LT(nearest_edge, 0.2);
  });
  EXPECT_NEAR(distance_to_target(fitted({}, {0, -1, 0}, {10, 10})), 1, 1e-12);
}

TEST(Camera, FramesPointsSoThatAllShowAndOppositeEdgesAreMet) {
  test::for_each_case("camera/frame points", 300, [](Rng& rng) {
    const Camera camera = random_camera(rng);
    const Size size{static_cast<int>(rng.uniform(100, 1000)),
                    static_cast<int>(rng.uniform(100, 1000))};
    const Vec3 far = random_point(rng, 1e5);
    std::vector<Vec3> points;
    for (int i = 0; i < 50; ++i) {
      points.push_back(far + random_point(rng, 100));
    }
    const Camera found = framed(camera, points, size);
    expect_near(frame(found).forward, frame(camera).forward, 1e-6);
    double left = 1, right = 1, upper = 1, lower = 1, nearest = 1e9;
    for (const Vec3& p : points) {
      const auto seen = project(found, size, p);
      ASSERT_TRUE(seen.has_value());
      nearest = std::min(nearest, seen->depth);
      left = std::min(left, seen->pixel.x / size.width);
      right = std::min(right, 1 - seen->pixel.x / size.width);
      upper = std::min(upper, seen->pixel.y / size.height);
      lower = std::min(lower, 1 - seen->pixel.y / size.height);
    }
    EXPECT_GE(std::min({left, right, upper, lower}), 0);
    if (nearest > 20) {
      EXPECT_LE(std::min(std::max(left, right), std::max(upper, lower)), 0.02)
          << "two edges are met";
    }
  });
  const Camera camera;
  EXPECT_EQ(framed(camera, {}, {10, 10}), camera);
  const std::vector<Vec3> one{{5, 5, 5}};
  expect_near(framed(camera, one, {10, 10}).target, {5, 5, 5});
  EXPECT_NEAR(distance_to_target(framed(camera, one, {10, 10})), distance_to_target(camera), 1e-9);
}

TEST(Camera, DepthRangeHoldsWhatIsInFront) {
  test::for_each_case("camera/depth", 300, [](Rng& rng) {
    const Camera camera = random_camera(rng);
    Box box;
    box.grow(random_point(rng, 300));
    box.grow(random_point(rng, 300));
    const DepthRange range = depth_range(camera, box);
    EXPECT_GT(range.near, 0);
    EXPECT_GT(range.far, range.near);
    for (int i = 0; i < 8; ++i) {
      const Vec3 p{i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                   i & 4 ? box.upper.z : box.lower.z};
      const double depth = dot(p - camera.eye, frame(camera).forward);
      EXPECT_LE(depth, range.far);
    }
  });
  const DepthRange outside =
      depth_range({{0, -1000, 0}, {0, 0, 0}, {0, 0, 1}, 0.8}, {{-10, -10, -10}, {10, 10, 10}});
  EXPECT_GT(outside.near, 900) << "near is as far off as the scene allows";
  EXPECT_LT(outside.near, 990);
}

TEST(Camera, AsksForTheLengthOfAPixel) {
  const Camera camera{{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 0.8};
  const double unit = length_of_pixel(camera, {100, 50}, 10);
  const auto seen = project(camera, {100, 50}, {unit, 0, 0});
  EXPECT_NEAR(seen->pixel.x, 51, 1e-9);
}

TEST(Camera, WhatIsCutAwayStaysSo) {
  Camera camera{{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 0.8, 8};  // the plane y = -2
  EXPECT_NEAR(dollied(camera, 0.5).cut, 3, 1e-12);
  EXPECT_NEAR(dollied(camera, 3).cut, 28, 1e-12);
  EXPECT_EQ(dollied(camera, 0.1).cut, 0);  // the eye has passed it
  const Camera far{{0, -100, 0}, {0, 0, 0}};
  const Camera way = between(far, camera, 0.5);
  EXPECT_NEAR(distance_to_target(way) - way.cut, 2, 1e-9);
  EXPECT_EQ(dollied(far, 0.5).cut, 0);
  const Ray ray = ray_through(camera, {300, 200}, {150, 100});
  EXPECT_NEAR(ray.origin.y, -2, 1e-12);  // what is not seen is not picked
}

}  // namespace
}  // namespace soms::view
