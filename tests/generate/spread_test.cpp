#include "soms/generate/spread.h"

#include "soms/base/error.h"

#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace soms {
namespace {

Vec3 center_of(const Triangle& t) {
  return (1.0 / 3) * (t.a + t.b + t.c);
}

double length(const Vec3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

double edge_of(const Triangle& t) {
  return length(t.b - t.a);
}

double area_of(const Triangle& t) {
  return 0.5 * length(cross(t.b - t.a, t.c - t.a));
}

std::vector<double> each(const Mesh& mesh, double (*of)(const Triangle&)) {
  std::vector<double> values;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    values.push_back(of(mesh.triangle(i)));
  }
  return values;
}

SpreadOptions with_ratio(double ratio) {
  SpreadOptions options;
  options.triangles = 1001;
  options.ratio = ratio;
  return options;
}

TEST(Spread, EdgesAreEvenlySpreadOnALogarithmicScale) {
  for (const double ratio : {1.0, 3.0, 100.0, 10000.0}) {
    SCOPED_TRACE(ratio);
    std::vector<double> edges = each(generate_spread(with_ratio(ratio)), edge_of);
    std::sort(edges.begin(), edges.end());
    for (std::size_t rank = 0; rank < edges.size(); ++rank) {
      const double expected = edges[0] * std::pow(ratio, static_cast<double>(rank) / 1000);
      ASSERT_NEAR(edges[rank], expected, 1e-9 * expected) << rank;
    }
  }
}

TEST(Spread, TotalAreaIsTheSameForEveryRatio) {
  for (const double ratio : {1.0, 3.0, 100.0, 10000.0}) {
    const std::vector<double> areas = each(generate_spread(with_ratio(ratio)), area_of);
    double sum = 0;
    for (const double area : areas) {
      sum += area;
    }
    EXPECT_NEAR(sum, 20 * 100 * 100, 1e-6 * sum) << ratio;
  }
}

TEST(Spread, NothingButSizesDependsOnTheRatio) {
  const Mesh alike = generate_spread(with_ratio(1));
  const Mesh unlike = generate_spread(with_ratio(1000));
  ASSERT_EQ(alike.triangles, unlike.triangles);
  for (TriangleId i = 0; i < alike.triangles.size(); ++i) {
    const Triangle s = alike.triangle(i);
    const Triangle t = unlike.triangle(i);
    EXPECT_NEAR(length(center_of(s) - center_of(t)), 0, 1e-11);
    const Vec3 m = cross(s.b - s.a, s.c - s.a);
    const Vec3 n = cross(t.b - t.a, t.c - t.a);
    EXPECT_LT(length(cross(m, n)), 1e-9 * length(m) * length(n));
  }
}

TEST(Spread, TrianglesAreEquilateralWithCentersInTheSlab) {
  const Mesh mesh = generate_spread(with_ratio(50));
  EXPECT_NO_THROW(check(mesh));
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    EXPECT_NEAR(length(t.c - t.b), edge_of(t), 1e-9);
    EXPECT_NEAR(length(t.a - t.c), edge_of(t), 1e-9);
    const Box slab{{-1e-9, -1e-9, -1e-9}, {100 + 1e-9, 100 + 1e-9, 5 + 1e-9}};
    EXPECT_TRUE(slab.contains({center_of(t), center_of(t)}));
  }
}

TEST(Spread, IsTheSameBitsEverywhere) {
  EXPECT_EQ(corner_hash(generate_spread(with_ratio(1))), 7875634768908356787U);
  EXPECT_EQ(corner_hash(generate_spread(with_ratio(100))), 15320655483086736148U);
  SpreadOptions other = with_ratio(100);
  other.seed = 2;
  EXPECT_NE(corner_hash(generate_spread(other)), corner_hash(generate_spread(with_ratio(100))));
}

TEST(Spread, OfOneTriangleIsThatOfTheWholeArea) {
  SpreadOptions options;
  options.triangles = 1;
  options.ratio = 7;
  const Mesh mesh = generate_spread(options);
  ASSERT_EQ(mesh.triangles.size(), 1U);
  EXPECT_NEAR(area_of(mesh.triangle(0)), 20 * 100 * 100, 1e-6);
}

TEST(Spread, RefusesOptionsOutOfRange) {
  const std::vector<std::function<void(SpreadOptions&)>> spoils{
      [](SpreadOptions& o) { o.triangles = 0; }, [](SpreadOptions& o) { o.ratio = 0.5; },
      [](SpreadOptions& o) { o.ratio = 2e6; },   [](SpreadOptions& o) { o.ratio = std::nan(""); },
      [](SpreadOptions& o) { o.cover = 0; },     [](SpreadOptions& o) { o.size = -1; },
      [](SpreadOptions& o) { o.height = -1; }};
  for (std::size_t i = 0; i < spoils.size(); ++i) {
    SCOPED_TRACE(i);
    SpreadOptions options;
    spoils[i](options);
    try {
      static_cast<void>(generate_spread(options));
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
}

}  // namespace
}  // namespace soms
