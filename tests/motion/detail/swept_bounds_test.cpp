#include "soms/motion/detail/swept_bounds.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/support.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace soms::detail {

namespace {

Box point_box(const Vec3& p) {
  return {p, p};
}

Box middle_bar() {
  return {{-4, -0.1, -0.2}, {4, 0.1, 0.2}};
}

void expect_holds_the_way(const Shape& body, const RigidMotion& way) {
  const Box box = swept_bounds(body, way);
  for (int k = 0; k <= 64; ++k) {
    const Pose pose = way.pose_at(k / 64.0);
    for (const Vec3& v : body.mesh().vertices) {
      ASSERT_TRUE(box.contains(point_box(pose.apply(v)))) << k;
    }
  }
}

TEST(SweptBounds, HoldBodiesThatTurnAndShift) {
  test::for_each_case("scene/swept-bounds", 400, [](Rng& rng) {
    const double scale = std::pow(2.0, rng.uniform(-40, 40));
    const double away = rng.below(2) == 0 ? 0 : std::pow(2.0, rng.uniform(0, 30)) * scale;
    Mesh mesh = test::random_mesh(rng);
    for (Vec3& v : mesh.vertices) {
      v = v * scale + Vec3{away, -away, 0};
    }
    const Shape body(std::move(mesh));
    Pose start = test::random_pose(rng, 8);
    Pose end = rng.below(3) == 0 ? start : test::random_pose(rng, 8);
    for (std::size_t row = 0; row < 3; ++row) {
      start.m[4 * row + 3] *= scale;
      end.m[4 * row + 3] = end.m[4 * row + 3] * scale + rng.uniform(-1, 1) * away;
    }
    expect_holds_the_way(body, way_between(start, end, body));
  });
}

// The ends of a bar that turns by a third of a turn are farthest out in the middle.
TEST(SweptBounds, HoldTheBow) {
  const Shape bar(test::box_mesh(middle_bar()));
  const double third = std::numbers::pi / 3;
  const RigidMotion way =
      way_between(Pose::about_z(third, {0, 0, 0}), Pose::about_z(2 * third, {0, 0, 0}), bar);
  expect_holds_the_way(bar, way);
  EXPECT_GT(swept_bounds(bar, way).upper.y, 4.0);
}

TEST(SweptBounds, AreTightForShortAndLongWays) {
  const Shape bar(test::box_mesh(middle_bar()));
  const Pose start = Pose::translation(0, 0, 7);
  const Box shifted = swept_bounds(bar, way_between(start, Pose::translation(0, 20, 7), bar));
  EXPECT_TRUE((Box{{-4.001, -0.101, 6.799}, {4.001, 20.101, 7.201}}.contains(shifted)));
  // What turns about z does not grow along it.
  const Box turned = swept_bounds(bar, way_between(start, Pose::about_z(0.1, {0, 0, 7}), bar));
  EXPECT_TRUE((Box{{-4.03, -0.55, 6.799}, {4.03, 0.55, 7.201}}.contains(turned)));
  // A turn by nearly a half: no farther than the corners are from the center.
  const Box half = swept_bounds(bar, way_between(start, Pose::about_z(3, {0, 0, 7}), bar));
  EXPECT_TRUE((Box{{-4.01, -4.01, 6.799}, {4.01, 4.01, 7.201}}.contains(half)));
}

TEST(SweptBounds, OfAnEmptyBodyAreEmpty) {
  const Shape nothing;
  EXPECT_TRUE(swept_bounds(nothing, way_between({}, Pose::translation(1, 0, 0), nothing)).empty());
}

}  // namespace

}  // namespace soms::detail
