#include "soms/geometry/polygon.h"

#include "soms/base/error.h"

#include "tests/support/effort.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <stop_token>
#include <vector>

namespace soms {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles cut(const std::vector<Vec3>& corners) {
  PolygonTriangulator triangulator;
  const auto triangles = triangulator.triangulate(corners);
  return {triangles.begin(), triangles.end()};
}

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * cross(b - a, c - a);
}

/// Sum of the triangles' own areas: more than the polygon's where they overlap.
double total_area(const std::vector<Vec3>& corners, const Triangles& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 area = area_vector(corners[a], corners[b], corners[c]);
    sum += std::sqrt(dot(area, area));
  }
  return sum;
}

double polygon_area(const std::vector<Vec3>& corners) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += area_vector(corners[0], corners[i], corners[i + 1]);
  }
  return std::sqrt(dot(sum, sum));
}

/// Every diagonal is used twice, in both directions, every side once: a disc of the same outline.
void expect_disc(const std::vector<Vec3>& corners, const Triangles& triangles) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  ASSERT_EQ(triangles.size(), n - 2);
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.insert({t[i], t[(i + 1) % 3]});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    EXPECT_EQ(edges.count({i, (i + 1) % n}), 1U);
  }
  for (const auto& [a, b] : edges) {
    EXPECT_EQ(edges.count({a, b}), 1U);
    EXPECT_EQ(edges.count({b, a}), (a + 1) % n == b ? 0U : 1U);
  }
}

/// A simple outline around the origin: one corner a direction.
std::vector<Vec3> random_star(Rng& rng, std::size_t n) {
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        2 * std::numbers::pi * (static_cast<double>(i) + 0.9 * rng.unit()) / static_cast<double>(n);
    const double radius = rng.uniform(0.05, 1);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return corners;
}

TEST(Polygon, FewerThanThreeCornersGiveNothing) {
  EXPECT_TRUE(cut({}).empty());
  EXPECT_TRUE(cut({{0, 0, 0}}).empty());
  EXPECT_TRUE(cut({{0, 0, 0}, {1, 0, 0}}).empty());
}

TEST(Polygon, ConvexOnesAreFansFromTheFirstCorner) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}}));
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
  // Corners on sides give triangles without area, and keep the fan.
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}),
            (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(Polygon, AFanThatCoversTheOutlineIsKeptThoughItIsConcave) {
  // Concave at corner 0, which sees all others.
  EXPECT_EQ(cut({{0, 0, 0}, {2, -2, 0}, {1, 0, 0}, {2, 2, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Polygon, ConcaveOnesAreCutIntoEars) {
  const std::vector<Vec3> arrow = {{2, 2, 0}, {1, 0, 0}, {2, -2, 0}, {0, 0, 0}};
  const Triangles triangles = cut(arrow);
  EXPECT_EQ(triangles, (Triangles{{3, 0, 1}, {1, 2, 3}}));
  EXPECT_DOUBLE_EQ(total_area(arrow, triangles), polygon_area(arrow));
}

TEST(Polygon, TheProjectionFollowsTheNormalInAnyPlaneAndWinding) {
  const std::vector<Vec3> flat = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}};
  const Triangles expected = cut(flat);
  expect_disc(flat, expected);
  const std::vector<Vec3> turned_x = {{0, 0, 0}, {0, 4, 0}, {0, 4, 4}, {0, 2, 1}, {0, 0, 4}};
  const std::vector<Vec3> turned_y = {{0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {1, 0, 2}, {4, 0, 0}};
  EXPECT_EQ(cut(turned_x), expected);
  EXPECT_EQ(cut(turned_y), expected);
  std::vector<Vec3> mirrored = flat;
  for (Vec3& v : mirrored) {
    v.x = -v.x;
  }
  EXPECT_EQ(cut(mirrored), expected);
}

TEST(Polygon, RandomOutlinesBecomeDiscsOfTheSameArea) {
  test::for_each_case("geometry/polygon", 300, [](Rng& rng) {
    std::vector<Vec3> corners = random_star(rng, 4 + rng.below(60));
    std::rotate(corners.begin(),
                corners.begin() + static_cast<std::ptrdiff_t>(rng.below(corners.size())),
                corners.end());
    if (rng.below(2) == 0) {
      std::reverse(corners.begin(), corners.end());
    }
    for (Vec3& v : corners) {  // tilted, and far away
      v = {v.x + 1000, v.y - 0.5 * v.x, v.x + 0.25 * v.y};
    }
    const Triangles triangles = cut(corners);
    expect_disc(corners, triangles);
    EXPECT_NEAR(total_area(corners, triangles), polygon_area(corners), 1e-9);
  });
}

TEST(Polygon, OutlinesWithCollinearAndRepeatedCornersKeepTheirArea) {
  // A comb on a grid: many corners on one line, some twice.
  std::vector<Vec3> comb = {{0, 0, 0}, {9, 0, 0}};
  for (double x = 9; x > 0; x -= 2) {
    comb.insert(comb.end(), {{x, 3, 0},
                             {x, 3, 0},
                             {x - 0.5, 3, 0},
                             {x - 1, 3, 0},
                             {x - 1, 1, 0},
                             {x - 1.5, 1, 0},
                             {x - 2 < 0 ? 0 : x - 2, 1, 0}});
  }
  const Triangles triangles = cut(comb);
  expect_disc(comb, triangles);
  EXPECT_NEAR(total_area(comb, triangles), polygon_area(comb), 1e-12);
}

TEST(Polygon, ABridgeToAHoleIsCutRight) {
  // A square with a square hole, joined by a bridge that is traversed twice.
  const std::vector<Vec3> ring = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                  {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  const Triangles triangles = cut(ring);
  expect_disc(ring, triangles);
  EXPECT_NEAR(total_area(ring, triangles), 12, 1e-12);
}

TEST(Polygon, OutlinesThatCrossThemselvesGiveAllTriangles) {
  test::for_each_case("geometry/polygon/crossing", 300, [](Rng& rng) {
    std::vector<Vec3> corners;
    const std::uint64_t n = 4 + rng.below(30);
    for (std::uint64_t i = 0; i < n; ++i) {
      // A small grid: many coincidences.
      corners.push_back({static_cast<double>(rng.below(5)), static_cast<double>(rng.below(5)),
                         static_cast<double>(rng.below(2))});
    }
    expect_disc(corners, cut(corners));
  });
}

TEST(Polygon, ScaleDoesNotChangeTheCut) {
  test::for_each_case("geometry/polygon/scale", 50, [](Rng& rng) {
    const std::vector<Vec3> corners = random_star(rng, 24);
    const Triangles expected = cut(corners);
    for (const double scale : {0x1p-990, 0x1p-300, 0x1p299}) {
      std::vector<Vec3> scaled = corners;
      for (Vec3& v : scaled) {
        v = v * scale;
      }
      EXPECT_EQ(cut(scaled), expected) << scale;
    }
  });
}

TEST(Polygon, LargeOutlinesEndSoonAfterARequestToStop) {
  Rng rng(3);
  const std::vector<Vec3> corners = random_star(rng, 1000);
  std::stop_source stop;
  stop.request_stop();
  PolygonTriangulator triangulator;
  EXPECT_THROW(static_cast<void>(triangulator.triangulate(corners, {.stop = stop.get_token()})),
               Error);
}

TEST(Polygon, LargeOutlinesTakeAtMostQuadraticTime) {
  Rng rng(3);
  const std::vector<Vec3> corners = random_star(rng, 6000);
  Triangles triangles;
  const double effort = test::effort_of([&] { triangles = cut(corners); });
  EXPECT_EQ(triangles.size(), 5998U);
  EXPECT_NEAR(total_area(corners, triangles), polygon_area(corners), 1e-9);
  EXPECT_LT(effort, 50);
}

}  // namespace
}  // namespace soms
