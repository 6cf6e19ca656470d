#include "soms/generate/shapes.h"

#include "soms/base/error.h"

#include "tests/generate/closed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace soms {
namespace {

using test::faulty_edges;
using test::flat_triangles;
using test::volume6;

/// The message of the usage error that `call` throws; empty if it throws none.
template <class Call>
std::string usage_error(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.what();
  }
  return {};
}

TEST(Knot, HasExactCountAndIsClosedForEveryEvenCount) {
  for (std::uint64_t n = 18; n <= 400; n += 2) {
    const Mesh knot = generate_knot(n);
    EXPECT_EQ(knot.triangles.size(), n);
    EXPECT_EQ(faulty_edges(knot), 0U) << n;
    EXPECT_EQ(flat_triangles(knot), 0U) << n;
  }
  for (const std::uint64_t n : {1'000U, 5'672U, 9'998U, 99'994U, 1'000'000U}) {
    EXPECT_EQ(generate_knot(n).triangles.size(), n);
  }
  EXPECT_EQ(faulty_edges(generate_knot(9'998)), 0U);
}

TEST(Knot, ReachesOneAndIsNeverFartherFromTheOrigin) {
  const Mesh knot = generate_knot(10'000);
  double reach = 0;
  for (const Vec3& v : knot.vertices) {
    reach = std::max(reach, dot(v, v));
  }
  EXPECT_NEAR(reach, 1, 1e-15);
  EXPECT_GT(volume6(knot), 0);
}

TEST(Knot, NamesTheLeastAndTheNearestCounts) {
  EXPECT_EQ(usage_error([] { (void)generate_knot(3); }), "knot of 3 triangles; the least is 18");
  EXPECT_NE(usage_error([] { (void)generate_knot(1001); }).find("1000 or 1002"), std::string::npos);
  EXPECT_NE(usage_error([] { (void)generate_knot(std::uint64_t{1} << 31); }).find("the most is"),
            std::string::npos);
}

TEST(Sphere, HasExactCountIsClosedAndRound) {
  for (std::uint64_t n = 8; n <= 300; n += 2) {
    const Mesh sphere = generate_sphere(n);
    EXPECT_EQ(sphere.triangles.size(), n);
    EXPECT_EQ(faulty_edges(sphere), 0U) << n;
    EXPECT_EQ(flat_triangles(sphere), 0U) << n;
    EXPECT_GT(volume6(sphere), 0) << n;
    for (const Vec3& v : sphere.vertices) {
      EXPECT_NEAR(dot(v, v), 1, 1e-14);
    }
  }
  EXPECT_EQ(generate_sphere(99'998).triangles.size(), 99'998U);
  // The volume of a fine sphere is 4/3 pi.
  EXPECT_NEAR(volume6(generate_sphere(100'000)) / 6, 4.18879, 0.001);
}

TEST(Sphere, NamesTheLeastCount) {
  EXPECT_EQ(usage_error([] { (void)generate_sphere(6); }), "sphere of 6 triangles; the least is 8");
  EXPECT_NE(usage_error([] { (void)generate_sphere(9); }).find("8 or 10"), std::string::npos);
}

TEST(Mover, HasItsUsualCountAndSizeInMetres) {
  const Mesh car = generate_mover(MoverKind::car);
  EXPECT_EQ(car.triangles.size(), 1000U);
  EXPECT_NEAR(bounds(car).extent().x, 4.5, 1e-12);
  EXPECT_NEAR(bounds(car).extent().y, 1.98, 1e-12);
  EXPECT_NEAR(bounds(car).extent().z, 1.45, 1e-12);
  EXPECT_NEAR(bounds(car).lower.z, 0, 1e-12);
  const Mesh person = generate_mover(MoverKind::person);
  EXPECT_EQ(person.triangles.size(), 600U);
  EXPECT_NEAR(bounds(person).extent().z, 1.75, 1e-12);
  EXPECT_NEAR(bounds(person).lower.z, 0, 1e-12);
  EXPECT_LT(bounds(person).extent().y, 0.7);
  const Mesh drone = generate_mover(MoverKind::drone);
  EXPECT_EQ(drone.triangles.size(), 308U);
  EXPECT_LT(bounds(drone).extent().x, 1.0);
  EXPECT_LT(bounds(drone).lower.z, 0);
  EXPECT_GT(bounds(drone).upper.z, 0);
  const Vec3 sedan = bounds(generate_mover(MoverKind::sedan)).extent();
  EXPECT_NEAR(sedan.x, 4.58, 0.01);
  EXPECT_NEAR(sedan.y, 2.04, 0.01);
  EXPECT_NEAR(sedan.z, 1.46, 1e-12);
  const Vec3 van = bounds(generate_mover(MoverKind::van)).extent();
  EXPECT_NEAR(van.x, 5.18, 0.01);
  EXPECT_NEAR(van.y, 2.24, 0.01);
  EXPECT_NEAR(van.z, 2.1, 1e-12);
  for (const MoverKind kind : {MoverKind::sedan, MoverKind::van}) {
    EXPECT_EQ(generate_mover(kind).triangles.size(), 700U);
    EXPECT_NEAR(bounds(generate_mover(kind)).lower.z, 0, 1e-12);
  }
}

std::vector<Vec3> corners_of(const Mesh& mesh) {
  std::vector<Vec3> corners;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    corners.insert(corners.end(), {t.a, t.b, t.c});
  }
  return corners;
}

// A wheel of 16 corners is round to the eye, and stands below an arch of the body.
TEST(Mover, VehiclesHaveWheelsBelowArchesAndARoofNarrowerThanTheBody) {
  for (const MoverKind kind : {MoverKind::sedan, MoverKind::van}) {
    const Mesh mesh = generate_mover(kind);
    const auto part = [&](std::string_view word) {
      const auto found = std::find_if(mesh.parts.begin(), mesh.parts.end(),
                                      [&](const Part& p) { return p.name == word; });
      return test::part_mesh(mesh, *found);
    };
    const std::vector<Vec3> body = corners_of(part("body"));
    double wide = 0;
    double roof = 0;
    for (const Vec3& p : body) {
      wide = std::max(wide, p.y);
      roof = p.z > 1.2 ? std::max(roof, p.y) : roof;
    }
    EXPECT_GT(roof, 0.5);
    EXPECT_LT(roof, kind == MoverKind::van ? wide : 0.75 * wide);
    for (const char* word : {"wheel_front_left", "wheel_rear_right"}) {
      Box wheel;
      for (const Vec3& p : corners_of(part(word))) {
        wheel.grow(p);
      }
      EXPECT_EQ(part(word).triangles.size(), 60U);
      EXPECT_NEAR(wheel.extent().x, wheel.extent().z, 1e-9);
      for (const Vec3& p : body) {
        const bool is_above = std::abs(p.x - wheel.center().x) < wheel.extent().x / 2;
        EXPECT_TRUE(!is_above || p.z > 0.8 * wheel.upper.z) << word;
      }
    }
  }
}

/// Parts that cover all triangles, each closed and turned outward.
void expect_closed_parts(const Mesh& mover, std::uint64_t triangles) {
  ASSERT_EQ(mover.triangles.size(), triangles);
  EXPECT_EQ(flat_triangles(mover), 0U);
  std::uint32_t next = 0;
  for (const Part& part : mover.parts) {
    EXPECT_EQ(part.first, next);
    next += part.count;
    const Mesh one = test::part_mesh(mover, part);
    EXPECT_EQ(faulty_edges(one), 0U) << mover.source << ' ' << triangles << ' ' << part.name;
    EXPECT_GT(volume6(one), 0) << mover.source << ' ' << triangles << ' ' << part.name;
  }
  EXPECT_EQ(next, triangles);
  EXPECT_NO_THROW(check(mover));
}

TEST(Mover, IsClosedPartByPartForManyCounts) {
  for (const MoverKind kind : {MoverKind::car, MoverKind::person, MoverKind::drone}) {
    for (const std::uint64_t n : {392U, 394U, 500U, 1'000U, 4'444U}) {
      expect_closed_parts(generate_mover(kind, n), n);
    }
  }
}

TEST(Mover, VehiclesAreClosedPartByPart) {
  for (const MoverKind kind : {MoverKind::sedan, MoverKind::van}) {
    for (const std::uint64_t n : {700U, 702U, 1'500U}) {
      expect_closed_parts(generate_mover(kind, n), n);
    }
  }
}

TEST(Mover, NamesTheLeastCountWhichItCanMake) {
  EXPECT_EQ(usage_error([] { (void)generate_mover(MoverKind::car, 10); }),
            "car of 10 triangles; the least is 384");
  EXPECT_EQ(usage_error([] { (void)generate_mover(MoverKind::person, 10); }),
            "person of 10 triangles; the least is 392");
  EXPECT_EQ(usage_error([] { (void)generate_mover(MoverKind::drone, 10); }),
            "drone of 10 triangles; the least is 244");
  EXPECT_EQ(generate_mover(MoverKind::car, 384).triangles.size(), 384U);
  EXPECT_EQ(generate_mover(MoverKind::drone, 244).triangles.size(), 244U);
  EXPECT_NE(usage_error([] { (void)generate_mover(MoverKind::car, 501); }).find("500 or 502"),
            std::string::npos);
}

TEST(Shapes, AreTheSameBitsEverywhere) {
  EXPECT_EQ(corner_hash(generate_knot(1000)), 17913978526222902653ULL);
  EXPECT_EQ(corner_hash(generate_sphere(1000)), 7586793026613245526ULL);
  EXPECT_EQ(corner_hash(generate_mover(MoverKind::car)), 17919677807536265853ULL);
  EXPECT_EQ(corner_hash(generate_mover(MoverKind::person)), 7280414510310810342ULL);
  EXPECT_EQ(corner_hash(generate_mover(MoverKind::drone)), 584692119688055545ULL);
  EXPECT_EQ(corner_hash(generate_mover(MoverKind::sedan)), 15920159702099031457ULL);
  EXPECT_EQ(corner_hash(generate_mover(MoverKind::van)), 13047138459706699585ULL);
}

}  // namespace
}  // namespace soms
