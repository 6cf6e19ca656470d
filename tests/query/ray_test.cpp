#include "soms/query/ray.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/query/reference/ray.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace soms {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// A unit square in z = 0, cut along the diagonal from (0, 0) to (1, 1), seen from above.
Mesh cut_square() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// The pyramid of four sides over the square from (-1, -1, 0) to (1, 1, 0), without its base.
Mesh roof() {
  Mesh mesh;
  mesh.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return mesh;
}

AllHits all_of_one(const Body& body, const Ray& ray, const RayOptions& options = {}) {
  return all_hits(body, std::span(&ray, 1), options);
}

template <class Ask>
ErrorKind ray_error(const Ask& ask) {
  try {
    ask();
  } catch (const Error& error) {
    return error.kind();
  }
  return ErrorKind::timed_out;
}

TEST(Ray, HitsTheFirstPointOfASurface) {
  const Body body(cut_square());
  const ClosestHit hit = closest_hit(body, Ray{{0.75, 0.25, 3}, {0, 0, -2}});
  EXPECT_EQ(hit.t, (Bracket{1.5, 1.5}));
  EXPECT_EQ(hit.triangle, 0U);
  EXPECT_EQ(hit.point, (Vec3{0.75, 0.25, 0}));
  EXPECT_TRUE(hit.front);
  const ClosestHit below = closest_hit(body, Ray{{0.25, 0.75, -1}, {0, 0, 3}});
  EXPECT_EQ(below.t, (Bracket{0x1.5555555555555p-2, 0x1.5555555555556p-2}));
  EXPECT_EQ(below.triangle, 1U);
  EXPECT_FALSE(below.front);
  EXPECT_FALSE(closest_hit(body, Ray{{0.75, 0.25, 3}, {0, 0, 2}}).triangle);
  EXPECT_EQ(closest_hit(body, Ray{{2, 0.25, 3}, {0, 0, -2}}).t, (Bracket{kEndless, kEndless}));
}

TEST(Ray, ThroughASharedEdgeHitsBothAndNamesTheLeast) {
  const Body body(cut_square());
  const Ray ray{{0.5, 0.5, 1}, {0, 0, -1}};
  EXPECT_EQ(closest_hit(body, ray).triangle, 0U);
  EXPECT_EQ(closest_hit(body, ray, {.skip = 0}).triangle, 1U);
  const AllHits all = all_of_one(body, ray);
  EXPECT_EQ(all.triangle, (std::vector<TriangleId>{0, 1}));
  EXPECT_EQ(all.kind, (std::vector<CrossingKind>{CrossingKind::enter}));
  EXPECT_EQ(all.lower, (std::vector<double>{1}));
}

TEST(Ray, CountsItsEndsAndNothingBeyondThem) {
  const Body body(cut_square());
  const Vec3 over{0.75, 0.25, 1};
  EXPECT_TRUE(any_hit(body, Ray{over, {0, 0, -1}, 1}).hit);
  EXPECT_FALSE(any_hit(body, Ray{over, {0, 0, -1}, std::nextafter(1, 0)}).hit);
  EXPECT_TRUE(any_hit(body, Ray{{0.75, 0.25, 0}, {0, 0, -1}, 0}).hit);
  EXPECT_EQ(closest_hit(body, Ray{{0.75, 0.25, 0}, {0, 0, -1}}).t, (Bracket{0, 0}));
  EXPECT_FALSE(any_hit(body, Ray{{0.75, 0.25, 0x1p-1074}, {0, 0, 1}}).hit);
  EXPECT_TRUE(any_hit(body, Ray::between(over, {0.75, 0.25, 0})).hit);
  EXPECT_FALSE(any_hit(body, Ray::between(over, {0.75, 0.25, 0x1p-1074})).hit);
  EXPECT_TRUE(any_hit(body, Ray::between({1, 1, 0}, {1, 1, 0})).hit);
  EXPECT_FALSE(any_hit(body, Ray::between(over, over)).hit);
  EXPECT_FALSE(sees(body, over, {0.75, 0.25, -1}));
  EXPECT_TRUE(sees(body, over, {0.75, 0.25, 0.5}));
}

// The difference of the ends is not a double: rounded it would miss.
TEST(Ray, OfASegmentIsNotRounded) {
  Mesh mesh;
  mesh.vertices = {{0x1p-60, 1, 0}, {0x1p-60, 1, 0}, {0x1p-60, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Body body(mesh);
  EXPECT_TRUE(any_hit(body, Ray::between({-1, 1, 0}, {0x1p-60, 1, 0})).hit);
  EXPECT_EQ(closest_hit(body, Ray::between({-1, 1, 0}, {0x1p-60, 1, 0})).t, (Bracket{1, 1}));
  EXPECT_FALSE(any_hit(body, Ray{{-1, 1, 0}, {1, 0, 0}, 1}).hit);
}

TEST(Ray, InTheirPlaneEntersTriangles) {
  const Body body(cut_square());
  const ClosestHit hit = closest_hit(body, Ray{{-1, 0.25, 0}, {2, 0, 0}});
  EXPECT_EQ(hit.t, (Bracket{0.5, 0.5}));
  EXPECT_EQ(hit.triangle, 1U);
  EXPECT_EQ(hit.point, (Vec3{0, 0.25, 0}));
  EXPECT_FALSE(hit.front);
  const AllHits all = all_of_one(body, Ray{{-1, 0.25, 0}, {2, 0, 0}});
  EXPECT_EQ(all.triangle, (std::vector<TriangleId>{1, 0}));
  EXPECT_EQ(all.kind, (std::vector<CrossingKind>{CrossingKind::graze, CrossingKind::graze}));
}

TEST(Ray, AtATipTouchesOrPasses) {
  const Body body(roof());
  const AllHits down = all_of_one(body, Ray{{0, 0, 2}, {0, 0, -1}});
  EXPECT_EQ(down.triangle, (std::vector<TriangleId>{0, 1, 2, 3}));
  EXPECT_EQ(down.kind, (std::vector<CrossingKind>{CrossingKind::enter}));
  const AllHits up = all_of_one(body, Ray{{0, 0, -1}, {0, 0, 1}});
  EXPECT_EQ(up.kind, (std::vector<CrossingKind>{CrossingKind::leave}));
  const AllHits beside = all_of_one(body, Ray{{-3, 0, 1}, {1, 0, 0}});
  EXPECT_EQ(beside.triangle, (std::vector<TriangleId>{0, 1, 2, 3}));
  EXPECT_EQ(beside.kind, (std::vector<CrossingKind>{CrossingKind::graze}));
}

// Sheets that touch but share nothing there are crossings of their own.
TEST(Ray, CrossingsAtOneTimeAreApartUnlessTheyShareACorner) {
  Mesh mesh = cut_square();
  mesh.vertices.insert(mesh.vertices.end(), {{0.5, -1, -1}, {0.5, 2, -1}, {0.5, 0.5, 2}});
  mesh.triangles.push_back({4, 5, 6});
  const AllHits all = all_of_one(Body(mesh), Ray{{1, 0.25, 1}, {-1, 0, -2}});
  EXPECT_EQ(all.offsets, (std::vector<std::uint64_t>{0, 2}));
  EXPECT_EQ(all.triangle, (std::vector<TriangleId>{0, 2}));
  EXPECT_EQ(all.lower, (std::vector<double>{0.5, 0.5}));
}

TEST(Ray, RefusesWhatIsNone) {
  const Body body(cut_square());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto kind_of = [&](const Ray& ray, const RayOptions& options = {}) {
    return ray_error([&] { static_cast<void>(closest_hit(body, ray, options)); });
  };
  EXPECT_EQ(kind_of({{nan, 0, 0}, {0, 0, 1}}), ErrorKind::not_finite);
  EXPECT_EQ(kind_of({{0x1.1p300, 0, 0}, {0, 0, 1}}), ErrorKind::out_of_range);
  EXPECT_EQ(kind_of({{0, 0, 0}, {0, kEndless, 1}}), ErrorKind::not_finite);
  EXPECT_EQ(kind_of({{0, 0, 0}, {0, -0.0, 0}}), ErrorKind::usage);
  EXPECT_EQ(kind_of({{0, 0, 0}, {0, 0, 1}, -1}), ErrorKind::usage);
  EXPECT_EQ(kind_of({{0, 0, 0}, {0, 0, 1}, nan}), ErrorKind::usage);
  EXPECT_EQ(kind_of({{0, 0, 0}, {0, 0, 1}}, {.skip = 2}), ErrorKind::usage);
  EXPECT_EQ(ray_error([&] {
              static_cast<void>(sees(body, {0, 0, nan}, {0, 0, 1}));
            }),
            ErrorKind::not_finite);
  const std::vector<Ray> rays{{{0, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 0}}};
  try {
    static_cast<void>(any_hit(body, rays));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.place(), "ray 1: the direction is zero");
  }
}

TEST(Ray, HitsNothingOfNothing) {
  const std::vector<Ray> rays(3, {{0, 0, 0}, {0, 0, 1}});
  EXPECT_EQ(closest_hit(Body{}, rays[0]), ClosestHit{});
  EXPECT_EQ(any_hit(Body{}, rays).hit, std::vector<std::uint8_t>(3, 0));
  EXPECT_EQ(all_hits(Body{}, rays).offsets, std::vector<std::uint64_t>(4, 0));
  EXPECT_EQ(all_hits(Body(cut_square()), std::vector<Ray>{}), AllHits{});
}

TEST(Ray, IsCutByADeadlineAndSaysSo) {
  const Body body(cut_square());
  Limits late{.deadline = std::chrono::steady_clock::time_point::min()};
  const std::vector<Ray> rays(3000, {{0.75, 0.25, 1}, {0, 0, -1}});
  EXPECT_EQ(closest_hit(body, rays[0], {}, late).coverage, Coverage::cut);
  late.threads = 2;
  EXPECT_EQ(any_hit(body, rays, {}, late).coverage, std::vector<Coverage>(3000, Coverage::cut));
  EXPECT_EQ(all_hits(body, rays, {}, late).coverage, std::vector<Coverage>(3000, Coverage::cut));
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(ray_error([&] {
              static_cast<void>(closest_hit(body, rays, {}, {.stop = source.get_token()}));
            }),
            ErrorKind::cancelled);
}

// Far origins and directions of any length lose nothing but t, which has fewer digits.
TEST(Ray, FromAnywhereAndOfAnyLengthHitsTheSame) {
  const Body body(generate_sphere(2000));
  const MeshView& mesh = body.shape.mesh();
  for (const int far : {0, 7, 20, 40, 60}) {
    for (const int length : {-900, -60, 0, 60, 900}) {
      for (TriangleId id = 0; id < mesh.triangles.size(); id += 97) {
        const Vec3 corner = mesh.triangle(id).a;
        const Vec3 away = Vec3{0.25, -0.5, 1} * std::ldexp(1.0, far);
        const Vec3 origin = corner + away;
        const Ray ray{origin, (corner - origin) * std::ldexp(1.0, length)};
        ClosestHit twin = reference::closest_hit_by_brute_force(body, ray);
        const ClosestHit found = closest_hit(body, ray);
        twin.cost = found.cost;
        ASSERT_EQ(found, twin) << far << " " << length << " " << id;
      }
    }
  }
}

// 4,000 sheets at one place: ties are decided one after the other, and nothing is kept of them.
TEST(Ray, OfManyTiesNamesTheLeast) {
  Mesh mesh = cut_square();
  for (int i = 0; i < 4000; ++i) {
    mesh.triangles.push_back({0, 1, 2});
  }
  mesh.triangles.erase(mesh.triangles.begin());
  const Ray ray{{0.75, 0.25, 1}, {0, 0.125, -1}};
  EXPECT_EQ(closest_hit(Body(mesh), ray).triangle, 1U);
  const AllHits all = all_of_one(Body(mesh), ray);
  EXPECT_EQ(all.triangle.size(), 4000U);
  EXPECT_EQ(all.kind, (std::vector<CrossingKind>{CrossingKind::graze}));
}

}  // namespace
}  // namespace soms
