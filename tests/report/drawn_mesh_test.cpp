#include "apps/report/drawn_mesh.h"

#include "soms/generate/city.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace soms::report {

namespace {

/// A square of `n` by `n` cells of one meter, bent a little, with its corner at `at`.
Mesh sheet(std::uint32_t n, const Vec3& at = {}) {
  Mesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      mesh.vertices.push_back(at + Vec3{double(x), double(y), 0.1 * std::sin(0.3 * x + 0.2 * y)});
    }
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t k = y * (n + 1) + x;
      mesh.triangles.push_back({k, k + 1, k + n + 2});
      mesh.triangles.push_back({k, k + n + 2, k + n + 1});
    }
  }
  return mesh;
}

/// Corner `corner` of triangle `i` as it is drawn, back in the mesh's coordinates.
Vec3 corner_of(const DrawnMesh& drawn, std::size_t i, std::size_t corner) {
  const std::size_t at = 3 * std::size_t{drawn.indices[3 * i + corner]};
  const Vec3 v{double(drawn.vertices[at]), double(drawn.vertices[at + 1]),
               double(drawn.vertices[at + 2])};
  return drawn.middle + v * (1 / drawn.scale);
}

double distance(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return std::hypot(d.x, d.y, d.z);
}

std::array<Vec3, 3> corners(const Triangle& t) {
  return {t.a, t.b, t.c};
}

TEST(DrawnMesh, DrawsASmallMeshWholeAndInOrder) {
  const Mesh mesh = sheet(5);
  const DrawnMesh out = drawn(mesh, 1, {});
  ASSERT_EQ(out.triangles(), mesh.triangles.size());
  EXPECT_EQ(out.all, mesh.triangles.size());
  EXPECT_EQ(out.vertices.size(), 3 * mesh.vertices.size());
  for (TriangleId i = 0; i < out.triangles(); ++i) {
    const auto real = corners(mesh.triangle(i));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LT(distance(corner_of(out, i, k), real[k]), 1e-6);
    }
  }
}

TEST(DrawnMesh, KeepsMillimetersFarFromTheOrigin) {
  const Mesh mesh = sheet(50, {2'600'000, 1'200'000, 400});
  const DrawnMesh out = drawn(mesh, 1, {});
  for (TriangleId i = 0; i < out.triangles(); ++i) {
    const auto real = corners(mesh.triangle(i));
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_LT(distance(corner_of(out, i, k), real[k]), 1e-5);
    }
  }
}

TEST(DrawnMesh, JoinsEqualCornersOfASoup) {
  const Mesh smooth = sheet(4);
  Mesh soup;
  for (TriangleId i = 0; i < smooth.triangles.size(); ++i) {
    const auto at = static_cast<std::uint32_t>(soup.vertices.size());
    for (const Vec3& corner : corners(smooth.triangle(i))) {
      soup.vertices.push_back(corner);
    }
    soup.triangles.push_back({at, at + 1, at + 2});
  }
  EXPECT_EQ(drawn(soup, 1, {}).vertices.size(), 3 * smooth.vertices.size());
  EXPECT_EQ(drawn(soup, 1, {}).triangles(), smooth.triangles.size());
}

TEST(DrawnMesh, LeavesOutVerticesThatNoTriangleUses) {
  Mesh mesh = sheet(2);
  mesh.vertices.push_back({1e9, 1e9, std::numeric_limits<double>::quiet_NaN()});
  const DrawnMesh out = drawn(mesh, 1, {});
  EXPECT_EQ(out.vertices.size(), 3 * (mesh.vertices.size() - 1));
  EXPECT_NEAR(out.middle.x, 1, 1e-12);
}

TEST(DrawnMesh, KeepsItsLimitsAndUsesThem) {
  const Mesh mesh = sheet(200);  // 80,000 triangles
  for (const std::uint64_t limit : {40'000U, 5'000U, 300U}) {
    const DrawnMesh out = drawn(mesh, 1, {.triangles = limit});
    EXPECT_LE(out.triangles(), limit);
    EXPECT_GE(out.triangles(), limit / 3);
    EXPECT_EQ(out.all, 80'000U);
  }
  const DrawnMesh out = drawn(mesh, 1, {.triangles = 80'000, .bytes = 200'000});
  EXPECT_LE(out.bytes(), 200'000U);
  EXPECT_GE(out.bytes(), 60'000U);
}

TEST(DrawnMesh, MovesCornersOnlyToOtherCornersNearby) {
  const Mesh mesh = sheet(100);
  const DrawnMesh out = drawn(mesh, 1, {.triangles = 2'000});
  for (std::size_t i = 0; i < out.triangles(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 at = corner_of(out, i, k);
      EXPECT_NEAR(at.x, std::round(at.x), 1e-4);
      EXPECT_NEAR(at.z, 0.1 * std::sin(0.3 * at.x + 0.2 * at.y), 1e-4);
    }
  }
}

TEST(DrawnMesh, DropsTrianglesThatBecomeTheSameOrLoseTheirArea) {
  const DrawnMesh out = drawn(sheet(100), 1, {.triangles = 500});
  std::set<std::array<std::uint32_t, 3>> seen;
  for (std::size_t i = 0; i < out.triangles(); ++i) {
    std::array<std::uint32_t, 3> t{out.indices[3 * i], out.indices[3 * i + 1],
                                   out.indices[3 * i + 2]};
    std::sort(t.begin(), t.end());
    EXPECT_TRUE(t[0] < t[1] && t[1] < t[2]);
    EXPECT_TRUE(seen.insert(t).second);
  }
}

TEST(DrawnMesh, KeepsEveryTriangleNearADetail) {
  const Mesh mesh = sheet(100);
  const DrawnMesh out =
      drawn(mesh, 1, {.triangles = 3'000}, {.points = {{50, 50, 0}}, .radius = 5});
  EXPECT_LE(out.triangles(), 3'000U);
  const auto is_near = [](const Vec3& v) {
    return std::abs(v.x - 50) <= 4 && std::abs(v.y - 50) <= 4;
  };
  std::size_t near = 0;
  for (std::size_t i = 0; i < out.triangles(); ++i) {
    near += is_near(corner_of(out, i, 0)) && is_near(corner_of(out, i, 1)) &&
                    is_near(corner_of(out, i, 2))
                ? 1U
                : 0U;
  }
  EXPECT_EQ(near, 128U);  // 8 by 8 cells
}

TEST(DrawnMesh, KeepsItsLimitsWhereEverythingIsDetail) {
  const Mesh mesh = sheet(100);
  Detail everywhere{.points = {}, .radius = 1000};
  for (int k = 0; k < 100; ++k) {
    everywhere.points.push_back({double(k), double(k), 0});
  }
  EXPECT_LE(drawn(mesh, 1, {.triangles = 2'000}, everywhere).triangles(), 2'000U);
}

TEST(DrawnMesh, TakesMeshesOfAnySizeAndNone) {
  EXPECT_EQ(drawn({}, 1, {}).triangles(), 0U);
  Mesh point;
  point.vertices = {{7, 7, 7}};
  point.triangles.assign(1000, {0, 0, 0});
  EXPECT_EQ(drawn(point, 1, {}).triangles(), 1000U);
  EXPECT_LE(drawn(point, 1, {.triangles = 10}).triangles(), 10U);
  Mesh huge = sheet(40, {1e200, 0, 0});
  for (Vec3& v : huge.vertices) {
    v = v * 0x1p600;
  }
  const DrawnMesh out = drawn(huge, 0x1p-600, {.triangles = 500});
  EXPECT_LE(out.triangles(), 500U);
  for (const float value : out.vertices) {
    EXPECT_TRUE(std::isfinite(value));
  }
}

TEST(DrawnMesh, DrawsWhatIsLargeAmongWiresWithoutArea) {
  Mesh wires;
  const auto add_wire = [&](double from, double length) {
    const auto first = static_cast<std::uint32_t>(wires.vertices.size());
    wires.vertices.insert(wires.vertices.end(),
                          {{from, 0, 0}, {from + length / 2, 0, 0}, {from + length, 0, 0}});
    wires.triangles.push_back({first, first + 1, first + 2});
  };
  for (int k = 0; k < 3'000; ++k) {
    add_wire(10 * k, 100);
  }
  for (int k = 0; k < 20; ++k) {
    add_wire(1'500 * k, 1'400);
  }
  const DrawnMesh out = drawn(wires, 1, {.triangles = 100});
  EXPECT_LE(out.triangles(), 100U);
  EXPECT_GE(out.triangles(), 20U);
}

TEST(DrawnMesh, SimplifiesACityWithinItsBox) {
  const Mesh city = generate_city({.triangles = 30'000}).mesh;
  const DrawnMesh out = drawn(city, 1, {.triangles = 6'000});
  EXPECT_LE(out.triangles(), 6'000U);
  EXPECT_GE(out.triangles(), 2'000U);
  const Box box = bounds(city);
  for (std::size_t i = 0; i < out.triangles(); ++i) {
    const Vec3 at = corner_of(out, i, 0);
    EXPECT_GE(at.x, box.lower.x - 1e-3);
    EXPECT_LE(at.z, box.upper.z + 1e-3);
  }
  const DrawnMesh again = drawn(city, 1, {.triangles = 6'000});
  EXPECT_EQ(again.vertices, out.vertices);
  EXPECT_EQ(again.indices, out.indices);
}

}  // namespace

}  // namespace soms::report
