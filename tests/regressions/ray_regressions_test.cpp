// Faults that users of other libraries reported, as far as they speak of what rays hit: one test a
// report. An id is never used again.
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
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::cylinder_body;
using test::even_direction;
using test::expect_rays_as_brute_force;
using test::mapped;
using test::Place;
using test::places_on;

Bracket exactly(double t) {
  return {t, t};
}

/// The mesh with vertices moved to multiples of 2^-20, so that differences of them are exact.
Mesh on_a_grid(Mesh mesh) {
  return mapped(std::move(mesh), [](const Vec3& v) {
    const auto round = [](double x) { return std::ldexp(std::nearbyint(std::ldexp(x, 20)), -20); };
    return Vec3{round(v.x), round(v.y), round(v.z)};
  });
}

TEST(Regression, R47ARayThroughADiagonalHitsTheLeastTriangle) {
  Mesh square;
  square.vertices = {{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Ray down{{0, 0, 1}, {0, 0, -1}};
  const ClosestHit hit = closest_hit(Body(square), down);
  EXPECT_EQ(hit.t, exactly(1));
  EXPECT_EQ(hit.triangle, 0U);
  EXPECT_EQ(hit.point, (Vec3{0, 0, 0}));
  std::vector<Ray> along_the_diagonal;
  for (int k = -8; k <= 8; ++k) {
    along_the_diagonal.push_back({{0.125 * k, 0.125 * k, 1}, {0, 0, -1}});
  }
  expect_rays_as_brute_force(square, along_the_diagonal);
}

TEST(Regression, R47ARayAtTheMiddleOfABodyHitsIt) {
  const Body sphere(generate_sphere(800));
  const ClosestHit pole = closest_hit(sphere, Ray{{0, 0, 10}, {0, 0, -1}});
  ASSERT_TRUE(pole.triangle);
  EXPECT_NEAR(pole.t.lower, 9, 1e-15);
  const Mesh cube = box_body({1.6, 1.6, 1.6}, {14.4, 14.4, 14.4});
  const std::vector<Place> places = places_on(Body(cube), {{0, 8, 8}, {1, 0, 0}});
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].t, exactly(1.6));
  EXPECT_EQ(places[0].kind, CrossingKind::enter);
  EXPECT_EQ(places[1].t, exactly(14.4));
  EXPECT_EQ(places[1].kind, CrossingKind::leave);
}

/// Expects a segment from `eye` to each corner of `mesh`, to the middle of each edge and to a point
/// of each face to hit it; the numbers are such that all of them end exactly there.
void expect_all_reached(const Mesh& mesh, const Vec3& eye) {
  const Body body(mesh);
  std::vector<Ray> segments;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    for (const Vec3& target : {t.a, (t.a + t.b) * 0.5, t.b, (t.b + t.c) * 0.5, t.c,
                               (t.c + t.a) * 0.5, (t.a + t.a + t.b + t.c) * 0.25}) {
      segments.push_back(Ray::between(eye, target));
    }
  }
  const ClosestHitBatch batch = closest_hit(body, segments);
  const AnyHitBatch any = any_hit(body, segments);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    ASSERT_TRUE(batch.triangle[i]) << "segment " << i;
    ASSERT_LE(batch.upper[i], 1) << "segment " << i;
    ASSERT_TRUE(any.hit[i]) << "segment " << i;
    const ClosestHit ray = closest_hit(body, Ray{eye, *segments[i].end - eye});
    ASSERT_EQ(ray.triangle, batch.triangle[i]) << "ray " << i;
    ASSERT_EQ(ray.t, (Bracket{batch.lower[i], batch.upper[i]})) << "ray " << i;
    ASSERT_FALSE(sees(body, eye, *segments[i].end)) << "segment " << i;
  }
}

TEST(Regression, R48NoRayPassesThroughACornerOrAnEdge) {
  Mesh cylinders = on_a_grid(cylinder_body(0.1, 12));
  for (int k = 2; k <= 10; ++k) {
    cylinders = test::joined(std::move(cylinders), on_a_grid(cylinder_body(0.1 * k, 10 + 2 * k)));
  }
  const Mesh sphere = on_a_grid(generate_sphere(800));
  for (const Vec3& eye :
       {Vec3{0, 0, 0}, Vec3{0.03125, -0.015625, 0.25}, Vec3{3, 0, 0}, Vec3{-2, 5, 1.5}}) {
    expect_all_reached(sphere, eye);
    expect_all_reached(cylinders, eye);
  }
}

TEST(Regression, R49RaysOnGridLinesFindNoPinholes) {
  const Mesh mesh = box_body({-4, -4, -4}, {4, 4, 4}, 8);
  const Body body(mesh);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 17 * 17; ++i) {
      Ray ray;
      ray.origin[axis] = -10;
      ray.origin[(axis + 1) % 3] = -4 + 0.5 * (i % 17);
      ray.origin[(axis + 2) % 3] = -4 + 0.5 * (i / 17);
      ray.direction[axis] = 2;
      const ClosestHit hit = closest_hit(body, ray);
      ASSERT_TRUE(hit.triangle) << axis << ' ' << i;
      ASSERT_EQ(hit.t, exactly(3));
      const bool beside = i % 17 == 0 || i % 17 == 16 || i / 17 == 0 || i / 17 == 16;
      const std::vector<Place> places = places_on(body, ray);
      if (!beside) {
        ASSERT_EQ(places.size(), 2U) << axis << ' ' << i;
        ASSERT_EQ(places[0].kind, CrossingKind::enter);
        ASSERT_EQ(places[1].kind, CrossingKind::leave);
        ASSERT_EQ(places[1].t, exactly(7));
      }
    }
  }
  expect_all_reached(mesh, {0, 0, 0});
  expect_all_reached(mesh, {-9, 7, 3});
}

/// A triangle with edges of 11.09, 9.7 and 1.4, somehow turned, and a ray from about 300 away, half
/// a degree off its plane, at a point in it or near it.
std::pair<Triangle, Ray> sliver_and_ray(Rng& rng) {
  // By the law of cosines. The longest is a little less than the sum of the others.
  constexpr double kLongest = 11.09;
  const double x = (kLongest * kLongest + 9.7 * 9.7 - 1.4 * 1.4) / (2 * kLongest);
  const double y = std::sqrt(9.7 * 9.7 - x * x);
  const Vec3 u = even_direction(rng);
  Vec3 n = cross(u, even_direction(rng));
  n = n * (1 / std::sqrt(dot(n, n)));
  const Vec3 v = cross(n, u);
  const Vec3 a{rng.uniform(-50, 50), rng.uniform(-50, 50), rng.uniform(-50, 50)};
  const Triangle t{a, a + u * kLongest, a + u * x + v * y};
  const double s = rng.uniform(-0.2, 1);
  const Vec3 target = t.a + (t.b - t.a) * s + (t.c - t.a) * rng.uniform(-0.2, 1 - s);
  const double angle = rng.uniform(0, 6.283185307179586);
  const Vec3 direction = u * std::cos(angle) + v * std::sin(angle) + n * 0.0087;
  return {t, {target - direction * 300, direction, 600}};
}

TEST(Regression, R50SliversSeenNearlyEdgeOnAreHitWhereTheyAre) {
  std::size_t hits = 0;
  test::for_each_case("regression/R50", 3000, [&](Rng& rng) {
    const auto [triangle, ray] = sliver_and_ray(rng);
    const Body body(test::soup_body({triangle}));
    const std::vector<Ray> rays{ray};
    ASSERT_EQ(test::fault_of_rays(body, rays, test::truth_of(body, rays)), "");
    const ClosestHit hit = closest_hit(body, ray);
    if (hit.triangle) {
      ++hits;
      ASSERT_GT(hit.t.lower, 300 - 14);
      ASSERT_LT(hit.t.upper, 300 + 14);
    }
  });
  EXPECT_GT(hits, 500U);
}

TEST(Regression, R50ManySliversAtOnce) {
  Rng rng(50);
  std::vector<Triangle> slivers;
  std::vector<Ray> rays;
  for (int i = 0; i < 2000; ++i) {
    const auto [triangle, ray] = sliver_and_ray(rng);
    slivers.push_back(triangle);
    if (i % 20 == 0) {
      rays.push_back(ray);
    }
  }
  const Body body(test::soup_body(slivers));
  EXPECT_EQ(test::fault_of_rays(body, rays, test::truth_of(body, rays)), "");
}

TEST(Regression, R51ZerosOfEitherSignInADirection) {
  const std::array<double, 4> steps{-1, -0.0, 0.0, 1};
  const std::array<double, 5> places{-1, 0, 0.5, 1, 2};
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < 64; ++i) {
    const Vec3 direction{steps[i % 4], steps[i / 4 % 4], steps[i / 16]};
    for (std::size_t k = 0; k < 125 && direction != Vec3{}; k += 1 + i % 3) {
      rays.push_back({{places[k % 5], places[k / 5 % 5], places[k / 25]}, direction});
    }
  }
  const Body box(test::unit_box());
  const test::RayTruth truth = test::truth_of(box, rays);
  EXPECT_EQ(test::fault_of_rays(box, rays, truth), "");
  const Body compact(Shape(test::unit_box(), {.layout = Layout::compact}));
  EXPECT_EQ(test::fault_of_rays(compact, rays, truth), "");
  // The signs of zeros are no part of an answer.
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Ray ray = rays[i];
    ray.direction = ray.direction + Vec3{};
    ASSERT_EQ(closest_hit(box, ray).triangle, truth.first[i].triangle) << "ray " << i;
  }
}

TEST(Regression, R51ANearlyParallelRayFindsABoxFarAway) {
  const Mesh box = box_body({1e14 - 0.5, 9.5, -0.5}, {1e14 + 0.5, 10.5, 0.5});
  const ClosestHit hit = closest_hit(Body(box), Ray{{0, 0, 0}, {1, 1e-13, 0}});
  ASSERT_TRUE(hit.triangle);
  EXPECT_EQ(hit.t, exactly(1e14 - 0.5));
  EXPECT_TRUE(hit.front);
}

TEST(Regression, R52AnEdgeIsOneCrossingOfBothTriangles) {
  const Mesh& box = test::unit_box();
  const std::vector<Place> places = places_on(Body(box), {{0.25, 0.25, 2}, {0, 0, -1}});
  const std::vector<Place> across = places_on(Body(box), {{0.75, 0.25, 2}, {0, 0, -1}});
  // One of them is on the diagonal of the top face.
  const std::vector<Place>& on = places[0].triangles.size() == 2 ? places : across;
  ASSERT_EQ(on.size(), 2U);
  EXPECT_EQ(on[0].t, exactly(1));
  EXPECT_EQ(on[0].kind, CrossingKind::enter);
  EXPECT_EQ(on[0].triangles.size(), 2U);
  EXPECT_EQ(on[1].t, exactly(2));
  EXPECT_EQ(on[1].kind, CrossingKind::leave);
  std::vector<Ray> rays;
  for (int k = 0; k <= 8; ++k) {
    rays.push_back({{0.125 * k, 0.125 * k, 2}, {0, 0, -1}});
    rays.push_back({{0.125 * k, 0, 2}, {0, 0, -1}});
    rays.push_back({{0.125 * k, -1, 2}, {0, 1, -1}});
  }
  expect_rays_as_brute_force(box, rays);
  for (const Ray& ray : rays) {
    int depth = 0;
    for (const Place& place : places_on(Body(box), ray)) {
      depth += place.kind == CrossingKind::enter ? 1 : place.kind == CrossingKind::leave ? -1 : 0;
      ASSERT_TRUE(depth == 0 || depth == 1);
    }
    ASSERT_EQ(depth, 0);
  }
}

/// Expects the first hit to be the first of all, and any to say whether there is one.
void expect_consistent(const Body& body, const Ray& ray) {
  const ClosestHit first = closest_hit(body, ray);
  const std::vector<Place> places = places_on(body, ray);
  ASSERT_EQ(any_hit(body, ray).hit, first.triangle.has_value());
  ASSERT_EQ(places.empty(), !first.triangle.has_value());
  if (first.triangle) {
    ASSERT_EQ(places[0].t, first.t);
    ASSERT_EQ(places[0].triangles[0], *first.triangle);
  }
  for (std::size_t i = 1; i < places.size(); ++i) {
    ASSERT_LE(places[i - 1].t.lower, places[i].t.lower);
  }
}

TEST(Regression, R53FirstAnyAndAllAgree) {
  const Mesh larger = box_body({-30, -30, -30}, {30, 30, 30}, 3);
  const Body boxes(test::joined(box_body({-20, -20, -20}, {20, 20, 20}, 2), larger));
  for (const Vec3& corner : larger.vertices) {
    const Ray ray{{0, 0, 0}, corner};
    expect_consistent(boxes, ray);
    const ClosestHit first = closest_hit(boxes, ray);
    ASSERT_TRUE(first.triangle);
    ASSERT_LT(*first.triangle, 48U) << "the smaller box is nearer";
    ASSERT_EQ(places_on(boxes, ray).size(), 2U);
    ASSERT_EQ(places_on(boxes, ray).back().t, exactly(1));
  }
}

TEST(Regression, R53TheFirstOfManySheetsIsTheNearest) {
  std::vector<Triangle> sheets;
  for (int k = 0; k < 100; ++k) {
    const double z = 0.1 * ((37 * k) % 100);
    sheets.push_back({{-1, -1, z}, {1, -1, z}, {1, 1, z}});
    sheets.push_back({{-1, -1, z}, {1, 1, z}, {-1, 1, z}});
  }
  const Body body(test::soup_body(sheets));
  const Ray down{{0.25, 0.25, 20}, {0, 0, -1}};
  const Ray up{{0.25, 0.25, -1}, {0, 0, 1}};
  expect_consistent(body, down);
  expect_consistent(body, up);
  EXPECT_EQ(places_on(body, down).size(), 100U);
  EXPECT_EQ(closest_hit(body, down).point, (Vec3{0.25, 0.25, 0.1 * 99}));
  EXPECT_EQ(closest_hit(body, up).t, exactly(1));
  EXPECT_EQ(closest_hit(body, up).triangle, 0U);
}

TEST(Regression, R54ARidgeIsGrazedAndNotCrossed) {
  Mesh roof;
  roof.vertices = {{-1, 0, 0}, {-1, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 0}, {1, 1, 0}};
  roof.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
  const Ray ray{{-5, 0.5, 1}, {1, 0, 0}};
  const std::vector<Place> expected{{exactly(5), CrossingKind::graze, {0, 3}}};
  EXPECT_EQ(places_on(Body(roof), ray), expected);
  EXPECT_EQ(closest_hit(Body(roof), ray).triangle, 0U);
  Mesh closed = roof;
  closed.triangles.insert(closed.triangles.end(), {{0, 4, 2}, {1, 3, 5}, {0, 1, 5}, {0, 5, 4}});
  EXPECT_EQ(places_on(Body(closed), ray), expected);
  expect_rays_as_brute_force(closed, {ray, {{5, 0.25, 1}, {-1, 0, 0}}, {{-5, 0, 1}, {1, 0, 0}}});
}

TEST(Regression, R55TheReversedRayHitsToo) {
  const double half = 2.024;
  const Body box(box_body({-half, 0, -3 - half}, {half, 2 * half, -3 + half}));
  const Ray there = Ray::between({-2.027535, 1.323740, -4.894639}, {2.506727, 1.292858, -2.102663});
  const ClosestHit hit = closest_hit(box, there);
  ASSERT_TRUE(hit.triangle);
  EXPECT_NEAR(hit.t.lower, 0.00077962, 1e-8);
  EXPECT_EQ(hit.point.x, -half);
  const ClosestHit back = closest_hit(box, Ray::between(*there.end, there.origin));
  ASSERT_TRUE(back.triangle);
  EXPECT_NEAR(back.t.lower, (2.506727 - half) / (2.506727 + 2.027535), 1e-12);
  EXPECT_EQ(back.point.x, half);
  EXPECT_FALSE(sees(box, there.origin, *there.end));
  EXPECT_FALSE(sees(box, *there.end, there.origin));
}

}  // namespace
}  // namespace soms
