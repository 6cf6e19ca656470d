// Faults that users of other libraries reported, as far as they speak of where rays begin, end and
// hit: one test a report. An id is never used again.
#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/query/closest.h"
#include "soms/query/print.h"
#include "soms/query/ray.h"

#include "tests/regressions/bodies.h"
#include "tests/regressions/rays.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::even_direction;
using test::mapped;
using test::places_on;

TEST(Regression, R56ARayFromInsideHitsTheWall) {
  constexpr int kSides = 24;
  const Body cylinder(test::cylinder_body(1, kSides));
  const double apothem = std::cos(3.141592653589793 / kSides);
  Rng rng(56);
  std::vector<Ray> rays(1'000'000);
  for (Ray& ray : rays) {
    ray.origin = {rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.6), rng.uniform(-0.9, 0.9)};
    ray.direction = even_direction(rng);
  }
  const ClosestHitBatch batch = closest_hit(cylinder, rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_TRUE(batch.triangle[i]) << i;
    ASSERT_FALSE(batch.front[i]) << i;
    const Vec3& p = batch.point[i];
    const double radius = std::hypot(p.x, p.y);
    const bool on_a_lid = std::abs(p.z) == 1 && radius <= 1 + 1e-15;
    const bool on_the_wall = std::abs(p.z) <= 1 && radius >= apothem - 1e-15 && radius <= 1 + 1e-15;
    ASSERT_TRUE(on_a_lid || on_the_wall) << i;
  }
}

TEST(Regression, R57NothingBeyondTheLengthIsHit) {
  const Body box(mapped(test::unit_box(), [](const Vec3& v) {
    return Vec3{v.x, 2 * v.y, 3 * v.z};
  }));
  Ray ray{{0.25, 0.5, 10}, {0, 0, -2}, 3.5};
  EXPECT_EQ(closest_hit(box, ray).t, (Bracket{3.5, 3.5}));
  EXPECT_TRUE(any_hit(box, ray).hit);
  EXPECT_EQ(places_on(box, ray).size(), 1U);
  ray.length = std::nextafter(3.5, 0);
  EXPECT_FALSE(closest_hit(box, ray).triangle);
  EXPECT_FALSE(any_hit(box, ray).hit);
  EXPECT_TRUE(places_on(box, ray).empty());
  const Vec3 short_of{0.25, 0.5, std::nextafter(3.0, 4)};
  EXPECT_TRUE(sees(box, ray.origin, short_of));
  EXPECT_FALSE(sees(box, ray.origin, {0.25, 0.5, 3}));
}

TEST(Regression, R57AMirroredBodyIsHitAtTheSamePlaces) {
  const Mesh knot = generate_knot(500);
  const auto mirror = [](const Vec3& v) { return Vec3{-v.x, v.y, v.z}; };
  const Body body(knot);
  const Body mirrored(mapped(knot, mirror));
  std::size_t hits = 0;
  test::for_each_case("regression/R57", 300, [&](Rng& rng) {
    const Vec3 origin = even_direction(rng) * 2;
    const Ray ray{origin, even_direction(rng) * 0.75 - origin, 1.5};
    const Ray other{mirror(ray.origin), mirror(ray.direction), ray.length};
    const auto places = places_on(body, ray);
    const auto others = places_on(mirrored, other);
    ASSERT_EQ(places.size(), others.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      ASSERT_EQ(places[i].t, others[i].t);
      ASSERT_EQ(places[i].triangles, others[i].triangles);
      ASSERT_EQ(places[i].kind == CrossingKind::enter, others[i].kind == CrossingKind::leave);
    }
    const ClosestHit hit = closest_hit(body, ray);
    const ClosestHit seen = closest_hit(mirrored, other);
    ASSERT_EQ(hit.triangle, seen.triangle);
    if (hit.triangle) {
      ++hits;
      ASSERT_EQ(mirror(hit.point), seen.point);
      ASSERT_NE(hit.front, seen.front);
    }
  });
  EXPECT_GT(hits, 30U);
}

/// A point of the unit box inside of a triangle, in exact numbers, which does not lie on an edge.
Vec3 point_inside(const Triangle& t, Rng& rng) {
  const auto whole = [&] { return static_cast<double>(1 + rng.below(1U << 20)); };
  const double a = whole();
  const double b = whole();
  const double all = 0x1p22;
  return t.a + (t.b - t.a) * (a / all) + (t.c - t.a) * (b / all);
}

TEST(Regression, R58ASurfacePointIsHitAtZeroUnlessItsTriangleIsSkipped) {
  const Mesh& box = test::unit_box();
  const Body body(box);
  Rng rng(58);
  for (int i = 0; i < 100'000; ++i) {
    const auto triangle = static_cast<TriangleId>(rng.below(12));
    const Triangle t = box.triangle(triangle);
    const Ray ray{point_inside(t, rng), even_direction(rng)};
    const ClosestHit hit = closest_hit(body, ray);
    ASSERT_EQ(hit.t, (Bracket{0, 0})) << i;
    ASSERT_EQ(hit.triangle, triangle) << i;
    ASSERT_EQ(hit.point, ray.origin) << i;
    const Vec3 normal = cross(t.b - t.a, t.c - t.a);
    const ClosestHit next = closest_hit(body, ray, {.skip = triangle});
    ASSERT_EQ(next.triangle.has_value(), dot(normal, ray.direction) < 0) << i;
    ASSERT_EQ(any_hit(body, ray, {.skip = triangle}).hit, next.triangle.has_value()) << i;
    if (next.triangle) {
      ASSERT_GT(next.t.lower, 0) << i;
    }
  }
}

// The hit point on a side of the box has that side's coordinate exactly, so the next ray begins in
// the closed box, in a corner too.
TEST(Regression, R58ARayThatBouncesInABoxStaysThere) {
  const Mesh& box = test::unit_box();
  const Body body(box);
  test::for_each_case("regression/R58", 20, [&](Rng& rng) {
    Ray ray{{0.5, 0.5, 0.5}, {0, 0, 0}};
    // Some go to corners and along diagonals.
    const bool even = rng.below(2) == 0;
    const auto step = [&] { return static_cast<double>(rng.below(5)) - 2; };
    while (ray.direction == Vec3{}) {
      ray.direction = even ? Vec3{step(), step(), step()} : even_direction(rng);
    }
    std::optional<TriangleId> last;
    for (int bounce = 0; bounce < 500; ++bounce) {
      const ClosestHit hit = closest_hit(body, ray, {.skip = last});
      ASSERT_TRUE(hit.triangle) << bounce;
      const Triangle t = box.triangle(*hit.triangle);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_GE(hit.point[axis], 0) << bounce;
        ASSERT_LE(hit.point[axis], 1) << bounce;
        if (t.a[axis] == t.b[axis] && t.b[axis] == t.c[axis]) {
          ASSERT_EQ(hit.point[axis], t.a[axis]) << bounce;
          const double away = std::abs(ray.direction[axis]);
          ray.direction[axis] = t.a[axis] == 0 ? away : -away;
        }
      }
      ray.origin = hit.point;
      last = hit.triangle;
    }
  });
}

TEST(Regression, R59TheHitPointIsTheExactOneRounded) {
  constexpr int kRays = 10'000;
  const Mesh plane = [] {
    Mesh mesh;
    mesh.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
  }();
  Rng rng(59);
  const Body body(plane, Pose::from_quaternion(0.48, 0.6, -0.512, 0.384, {0.1, -0.7, 3}));
  std::vector<Ray> rays;
  while (rays.size() < kRays) {
    const Vec3 target = body.pose.apply({rng.uniform(-0.99, 0.99), rng.uniform(-0.99, 0.99), 0});
    const Vec3 direction = even_direction(rng);
    rays.push_back({target - direction * rng.uniform(0.5, 20), direction});
  }
  const ClosestHitBatch batch = closest_hit(body, rays);
  const test::RayTruth truth = test::truth_of(body, rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const ClosestHit hit = batch.at(i);
    ASSERT_TRUE(hit.triangle) << i;
    ASSERT_EQ(hit.triangle, truth.first[i].triangle) << i;
    ASSERT_EQ(hit.point, truth.first[i].point) << i;
    const Triangle t = plane.triangle(*hit.triangle);
    const Body held(test::soup_body({t}), body.pose);
    // A coordinate is off by half a unit in the last place of a number below 8.
    ASSERT_LE(closest(held, hit.point).distance.upper, 0x1p-50) << i;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double along = rays[i].origin[axis] + hit.t.lower * rays[i].direction[axis];
      ASSERT_NEAR(hit.point[axis], along, 0x1p-46) << i;
    }
  }
}

TEST(Regression, R102TheContactOfABallIsOnThePlaneAndInTheBall) {
  Mesh plane;
  plane.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  plane.triangles = {{0, 1, 2}, {0, 2, 3}};
  const double radius = 0.2;
  for (const Vec3& center : {Vec3{0.25, -0.5, 0.1}, Vec3{0, 0, 0.1}, Vec3{1, 1, 0.1}}) {
    const Closest contact = closest(Body(plane), center, {.at_most = radius});
    ASSERT_FALSE(contact.farther);
    EXPECT_EQ(contact.distance, (Bracket{0.1, 0.1}));
    EXPECT_EQ(contact.point, (Vec3{center.x, center.y, 0}));
  }
  EXPECT_TRUE(closest(Body(plane), {0, 0, 0.3}, {.at_most = radius}).farther);
}

TEST(Regression, R103TheNearestPointsOfABallAndABoxLieOnThem) {
  const Mesh box = box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  const Vec3 center{3, 0, 0};
  const double radius = 1;
  const Closest nearest = closest(Body(box), center);
  EXPECT_EQ(nearest.point, (Vec3{0.5, 0, 0}));
  EXPECT_EQ(nearest.distance, (Bracket{2.5, 2.5}));
  const Vec3 on_ball = center + (nearest.point - center) * (radius / nearest.distance.lower);
  EXPECT_EQ(on_ball, (Vec3{2, 0, 0}));
}

/// Rays from about 1e7 away at a point of each triangle.
std::vector<Ray> rays_from_afar(const Mesh& mesh, Rng& rng) {
  std::vector<Ray> rays;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    const Vec3 center = (t.a + t.b + t.c) * (1.0 / 3);
    const Vec3 origin = even_direction(rng) * 1e7;
    rays.push_back({origin, center - origin});
  }
  return rays;
}

TEST(Regression, R105RaysFromFarAwayHitWhatTheyAimAt) {
  const Mesh ball = generate_sphere(2000);
  const Body body(ball);
  Rng rng(105);
  const std::vector<Ray> rays = rays_from_afar(ball, rng);
  const ClosestHitBatch batch = closest_hit(body, rays);
  const AllHits all = all_hits(body, rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_TRUE(batch.triangle[i]) << i;
    ASSERT_LT(batch.lower[i], 1 + 1e-9) << i;
    ASSERT_EQ(all.offsets[i + 1] - all.offsets[i], 2U) << i;
    ASSERT_EQ(all.kind[all.offsets[i]], CrossingKind::enter) << i;
    ASSERT_EQ(all.kind[all.offsets[i] + 1], CrossingKind::leave) << i;
  }
  const std::vector<Ray> some(rays.begin(), rays.begin() + 100);
  EXPECT_EQ(test::fault_of_rays(body, some, test::truth_of(body, some)), "");
}

TEST(Regression, R105AllHitsEndAtLargeCoordinates) {
  const Vec3 far{4e7, -3e7, 1e7};
  const Mesh ball = mapped(generate_sphere(500), [&](const Vec3& v) { return v + far; });
  const Body body(ball);
  Rng rng(106);
  std::vector<Ray> rays;
  for (int i = 0; i < 200; ++i) {
    rays.push_back({far + even_direction(rng) * 3, even_direction(rng)});
    rays.push_back({far, even_direction(rng)});
  }
  EXPECT_EQ(test::fault_of_rays(body, rays, test::truth_of(body, rays)), "");
}

}  // namespace
}  // namespace soms
