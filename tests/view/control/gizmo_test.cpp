#include "apps/view/control/gizmo.h"

#include "tests/support/support.h"

#include <cmath>
#include <numbers>

namespace soms::view {
namespace {

constexpr Size kGizmoView{800, 600};
constexpr double kSlack = 6;

Camera corner_camera() {
  Camera camera;
  camera.eye = {10, -7, 6};
  camera.target = {0, 0, 0};
  return camera;
}

Gizmo gizmo_of(const Camera& camera) {
  return *gizmo_at(camera, kGizmoView, {0, 0, 0}, 100);
}

PixelPoint pixel_of(const Camera& camera, const Vec3& point) {
  return project(camera, kGizmoView, point)->pixel;
}

double point_distance(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return std::sqrt(dot(d, d));
}

TEST(Gizmo, ArrowsLookAsLongAsRequestedAtAnyDistance) {
  for (const double distance : {1.0, 50.0, 3000.0}) {
    Camera camera;
    camera.eye = {0, -distance, 0};
    const Gizmo gizmo = gizmo_of(camera);
    const PixelPoint from = pixel_of(camera, gizmo.center);
    const PixelPoint to = pixel_of(camera, gizmo.center + Vec3{gizmo.size, 0, 0});
    EXPECT_NEAR(to.x - from.x, 100, 0.5) << distance;
  }
}

TEST(Gizmo, IsNotThereBehindTheEye) {
  const Camera camera = corner_camera();
  EXPECT_FALSE(gizmo_at(camera, kGizmoView, camera.eye * 3, 100));
}

TEST(Gizmo, FindsEachHandleWhereItIsDrawn) {
  const Camera camera = corner_camera();
  const Gizmo gizmo = gizmo_of(camera);
  const double s = gizmo.size;
  const std::vector<std::pair<Handle, Vec3>> places{
      {Handle::axis_x, {0.8 * s, 0, 0}},         {Handle::axis_y, {0, 0.8 * s, 0}},
      {Handle::axis_z, {0, 0, 0.8 * s}},         {Handle::plane_yz, {0, 0.4 * s, 0.4 * s}},
      {Handle::plane_zx, {0.4 * s, 0, 0.4 * s}}, {Handle::plane_xy, {0.4 * s, 0.4 * s, 0}},
      {Handle::turn, {-0.85 * s, 0, 0}}};
  for (const auto& [handle, place] : places) {
    EXPECT_EQ(handle_at(gizmo, camera, kGizmoView, pixel_of(camera, place), kSlack), handle)
        << static_cast<int>(handle);
  }
  EXPECT_FALSE(handle_at(gizmo, camera, kGizmoView, {5, 5}, kSlack));
}

TEST(Gizmo, DoesNotOfferAnArrowSeenEndOnNorASquareSeenEdgeOn) {
  Camera camera;
  camera.eye = {0, -10, 0};
  const Gizmo gizmo = gizmo_of(camera);
  const double s = gizmo.size;
  // The y arrow points away from the eye and covers a few pixels about the center.
  EXPECT_NE(handle_at(gizmo, camera, kGizmoView, pixel_of(camera, {0, 0.9 * s, 0}), kSlack),
            Handle::axis_y);
  EXPECT_FALSE(handle_at(gizmo, camera, kGizmoView, pixel_of(camera, {-0.4 * s, 0, 0}), kSlack));
}

TEST(Gizmo, DragAlongAnArrowKeepsToItsAxisAndFollowsTheMouse) {
  const Camera camera = corner_camera();
  const Gizmo gizmo = gizmo_of(camera);
  const double s = gizmo.size;
  const auto ray = [&](const Vec3& p) {
    return ray_through(camera, kGizmoView, pixel_of(camera, p));
  };
  const std::vector<std::pair<Handle, Vec3>> axes{
      {Handle::axis_x, {1, 0, 0}}, {Handle::axis_y, {0, 1, 0}}, {Handle::axis_z, {0, 0, 1}}};
  for (const auto& [handle, axis] : axes) {
    GizmoDrag drag(gizmo, handle, Pose::translation(5, 6, 7), ray(axis * (0.7 * s)));
    const Pose moved = drag.dragged(ray(axis * (1.9 * s)));
    EXPECT_LT(point_distance(moved.shift(), Vec3{5, 6, 7} + axis * (1.2 * s)), 1e-6 * s);
    EXPECT_EQ(drag.handle(), handle);
    EXPECT_EQ(drag.start(), Pose::translation(5, 6, 7));
  }
}

TEST(Gizmo, DragOfASquareKeepsToItsPlane) {
  const Camera camera = corner_camera();
  const Gizmo gizmo = gizmo_of(camera);
  const double s = gizmo.size;
  const auto ray = [&](const Vec3& p) {
    return ray_through(camera, kGizmoView, pixel_of(camera, p));
  };
  GizmoDrag drag(gizmo, Handle::plane_xy, {}, ray({0.4 * s, 0.4 * s, 0}));
  const Vec3 shift = drag.dragged(ray({2 * s, -1 * s, 0})).shift();
  EXPECT_LT(point_distance(shift, {1.6 * s, -1.4 * s, 0}), 1e-6 * s);
  EXPECT_NEAR(shift.z, 0, 1e-12);
}

TEST(Gizmo, DragOfTheRingTurnsAboutTheVerticalThroughTheCenter) {
  const Camera camera = corner_camera();
  const Gizmo gizmo = gizmo_of(camera);
  const double r = 0.85 * gizmo.size;
  const auto ray = [&](const Vec3& p) {
    return ray_through(camera, kGizmoView, pixel_of(camera, p));
  };
  GizmoDrag drag(gizmo, Handle::turn, Pose::translation(1, 0, 2), ray({r, 0, 0}));
  const Pose quarter = drag.dragged(ray({0, r, 0}));
  EXPECT_LT(point_distance(quarter.shift(), {0, 1, 2}), 1e-9);
  EXPECT_LT(point_distance(quarter.apply({1, 0, 0}), {0, 2, 2}), 1e-9);
  EXPECT_NO_THROW(check(quarter));
}

TEST(Gizmo, ADragBeyondTheHorizonKeepsTheLastPlace) {
  Camera camera;
  camera.eye = {0, -10, 3};
  const Gizmo gizmo = gizmo_of(camera);
  GizmoDrag drag(gizmo, Handle::plane_xy, {}, ray_through(camera, kGizmoView, {400, 300}));
  const Pose before = drag.dragged(ray_through(camera, kGizmoView, {420, 320}));
  EXPECT_EQ(drag.dragged(ray_through(camera, kGizmoView, {420, 1})), before);
}

TEST(Gizmo, NearestPointOnAnAxisIsNearestIndeed) {
  test::for_each_case("gizmo/nearest", 500, [](Rng& rng) {
    const auto number = [&] { return rng.uniform(-5, 5); };
    const Vec3 origin{number(), number(), number()};
    Vec3 axis{number(), number(), number()};
    axis = axis * (1 / std::sqrt(dot(axis, axis)));
    Vec3 direction{number(), number(), number()};
    direction = direction * (1 / std::sqrt(dot(direction, direction)));
    const Ray ray{{number(), number(), number()}, direction};
    const auto point = nearest_on_axis(ray, origin, axis);
    if (!point) {
      return;
    }
    const auto to_ray = [&](const Vec3& p) {
      const Vec3 d = cross(p - ray.origin, ray.direction);
      return std::sqrt(dot(d, d));
    };
    for (const double step : {-0.01, 0.01}) {
      EXPECT_LE(to_ray(*point), to_ray(*point + axis * step) + 1e-9);
    }
    const Vec3 off = cross(*point - origin, axis);
    EXPECT_NEAR(dot(off, off), 0, 1e-15 * dot(*point - origin, *point - origin) + 1e-18);
  });
}

TEST(Gizmo, PlanesAreMetInFrontOnly) {
  const auto hit = meet_plane({{0, 0, 5}, {0, 0, -1}}, {9, 9, 1}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_EQ(*hit, (Vec3{0, 0, 1}));
  EXPECT_FALSE(meet_plane({{0, 0, 5}, {0, 0, 1}}, {9, 9, 1}, {0, 0, 1}));
  EXPECT_FALSE(meet_plane({{0, 0, 5}, {1, 0, 0}}, {9, 9, 1}, {0, 0, 1}));
}

TEST(Gizmo, TenThousandTurnsStayRigid) {
  Pose pose = Pose::translation(3, 4, 5);
  for (int i = 0; i < 10'000; ++i) {
    pose = turned_about(pose, {1, 1, 1}, 0.1);
  }
  EXPECT_NO_THROW(check(pose));
  EXPECT_NEAR(point_distance(pose.shift(), {1, 1, 5}), std::hypot(2, 3), 1e-9);
  const Pose back = turned_about(turned_about({}, {7, 0, 0}, 1), {7, 0, 0}, -1);
  EXPECT_LT(point_distance(back.apply({1, 2, 3}), {1, 2, 3}), 1e-12);
}

TEST(Gizmo, IsDrawnOnTopAndTheChosenHandleDiffers) {
  const Gizmo gizmo{{1, 2, 3}, 2};
  DrawList plain;
  DrawList chosen;
  draw(gizmo, std::nullopt, plain);
  draw(gizmo, Handle::axis_y, chosen);
  ASSERT_EQ(plain.lines.size(), chosen.lines.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < plain.lines.size(); ++i) {
    EXPECT_TRUE(plain.lines[i].on_top);
    different += plain.lines[i].color == chosen.lines[i].color ? 0U : 1U;
  }
  EXPECT_EQ(different, 1U);
  EXPECT_LT(point_distance(tips(gizmo)[2], {1, 2, 5.2}), 1e-12);
}

}  // namespace
}  // namespace soms::view
