#include "soms/kinematics/primitive_meshes.h"

#include "soms/base/error.h"
#include "soms/geometry/closedness.h"
#include "soms/geometry/print.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms {
namespace {

/// Distance of the origin from the plane of a triangle.
long double plane_distance(const Triangle& t) {
  const Vec3 n = cross(t.b - t.a, t.c - t.a);
  return std::abs(static_cast<long double>(dot(n, t.a))) /
         std::sqrt(static_cast<long double>(dot(n, n)));
}

double volume_of(const Mesh& mesh) {
  double six = 0;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    six += dot(t.a, cross(t.b, t.c));
  }
  return six / 6;
}

TEST(PrimitiveMeshes, BoxHasItsSize) {
  const PrimitiveMesh box = box_mesh({1, 2, 3});
  EXPECT_EQ(bounds(box.mesh), (Box{{-0.5, -1, -1.5}, {0.5, 1, 1.5}}));
  EXPECT_EQ(box.error, 0);
  EXPECT_TRUE(closedness(box.mesh).whole.closed);
  EXPECT_DOUBLE_EQ(volume_of(box.mesh), 6);  // triangles face outward
}

TEST(PrimitiveMeshes, CylinderHoldsTheTrueOneWithinItsError) {
  test::for_each_case("cylinder", 40, [](Rng& rng) {
    const double radius = std::ldexp(1 + rng.unit(), static_cast<int>(rng.below(40)) - 20);
    const double most = radius * std::ldexp(1.0, -1 - static_cast<int>(rng.below(16)));
    const PrimitiveMesh shape = cylinder_mesh(radius, 3 * radius, most);
    EXPECT_TRUE(closedness(shape.mesh).whole.closed);
    EXPECT_GT(volume_of(shape.mesh), 0);
    EXPECT_LE(shape.error, most);
    for (const Vec3& v : shape.mesh.vertices) {
      EXPECT_LE(std::hypot(v.x, v.y), (radius + shape.error) * (1 + 1e-15));
      EXPECT_EQ(std::abs(v.z), 1.5 * radius);
    }
    for (TriangleId i = 0; i < shape.mesh.triangles.size(); ++i) {
      const Triangle t = shape.mesh.triangle(i);
      if (!(t.a.z == t.b.z && t.b.z == t.c.z)) {  // a side
        EXPECT_GE(plane_distance(t), radius);
      }
    }
  });
}

TEST(PrimitiveMeshes, SphereHoldsTheTrueOneWithinItsError) {
  test::for_each_case("sphere", 12, [](Rng& rng) {
    const double radius = std::ldexp(1 + rng.unit(), static_cast<int>(rng.below(40)) - 20);
    const double most = radius * std::ldexp(1.0, -1 - static_cast<int>(rng.below(11)));
    const PrimitiveMesh shape = sphere_mesh(radius, most);
    EXPECT_TRUE(closedness(shape.mesh).whole.closed);
    EXPECT_GT(volume_of(shape.mesh), 4.18 * radius * radius * radius);
    EXPECT_LE(shape.error, most);
    for (const Vec3& v : shape.mesh.vertices) {
      EXPECT_LE(std::hypot(v.x, v.y, v.z), (radius + shape.error) * (1 + 1e-15));
    }
    for (TriangleId i = 0; i < shape.mesh.triangles.size(); ++i) {
      EXPECT_GE(plane_distance(shape.mesh.triangle(i)), radius);
    }
  });
}

TEST(PrimitiveMeshes, TakeNoMoreTrianglesThanTheyNeed) {
  EXPECT_LE(cylinder_mesh(0.05, 1, 0.0005).mesh.triangles.size(), 4U * 28U);
  EXPECT_EQ(cylinder_mesh(1, 1, 1).mesh.triangles.size(), 4U * 8U);
  EXPECT_LE(sphere_mesh(0.05, 0.0005).mesh.triangles.size(), 1500U);
}

TEST(PrimitiveMeshes, RefuseSizesThatAreNone) {
  const auto kind = [](const auto& make) {
    try {
      static_cast<void>(make());
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::cancelled;
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kind([] { return box_mesh({1, -1, 1}); }), ErrorKind::usage);
  EXPECT_EQ(kind([&] { return box_mesh({1, 1, kNan}); }), ErrorKind::not_finite);
  EXPECT_EQ(kind([&] { return cylinder_mesh(kInfinity, 1, 1); }), ErrorKind::not_finite);
  EXPECT_EQ(kind([] { return cylinder_mesh(1, 1, 0); }), ErrorKind::usage);
  EXPECT_EQ(kind([] { return cylinder_mesh(1, 1, 1e-9); }), ErrorKind::out_of_range);
  EXPECT_EQ(kind([] { return sphere_mesh(-1, 1); }), ErrorKind::usage);
  EXPECT_EQ(kind([] { return sphere_mesh(1e6, 0.0005); }), ErrorKind::out_of_range);
}

}  // namespace
}  // namespace soms
