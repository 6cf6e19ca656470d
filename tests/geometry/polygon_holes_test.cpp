#include "soms/geometry/polygon_holes.h"

#include "soms/geometry/polygon.h"

#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

/// An outline and its holes, each a ring of corners in the plane of x and y.
using Rings = std::vector<std::vector<Vec3>>;

Rings rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}};
}

/// Twice the area, positive where a ring is wound counter-clockwise.
double doubled_area(const std::vector<Vec3>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3& p = ring[i];
    const Vec3& q = ring[(i + 1) % ring.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

/// Where the plane of x and y is put: seen from above or below, from x, or from y.
enum class View { above, below, along_x, along_y };

Vec3 placed(const Vec3& v, View view) {
  switch (view) {
    case View::below:
      return {v.y, v.x, v.z};
    case View::along_x:
      return {v.z, v.x, v.y};
    case View::along_y:
      return {v.y, v.z, v.x};
    case View::above:
      break;
  }
  return v;
}

/// Expects triangles that fill the outline but for its holes: none turned around, all areas exact.
void expect_filled(const Rings& rings, std::size_t left_out = 0) {
  double expected = 0;
  for (std::size_t r = 0; r + left_out < rings.size(); ++r) {
    expected += (r == 0 ? 1 : -1) * std::abs(doubled_area(rings[r]));
  }
  for (const View view : {View::above, View::below, View::along_x, View::along_y}) {
    std::vector<Vec3> flat;
    std::vector<Vec3> corners;
    std::vector<std::size_t> ends;
    for (const std::vector<Vec3>& ring : rings) {
      for (const Vec3& v : ring) {
        flat.push_back(v);
        corners.push_back(placed(v, view));
      }
      ends.push_back(corners.size());
    }
    HoleJoiner joiner;
    const auto ring = joiner.join(corners, ends);
    EXPECT_EQ(joiner.left_out(), left_out);
    std::vector<Vec3> joined;
    for (const std::uint32_t i : ring) {
      joined.push_back(corners[i]);
    }
    PolygonTriangulator triangulator;
    double area = 0;
    const double sign = doubled_area(rings[0]) < 0 ? -1 : 1;
    for (const auto& [a, b, c] : triangulator.triangulate(joined)) {
      const double part = sign * doubled_area({flat[ring[a]], flat[ring[b]], flat[ring[c]]});
      EXPECT_GE(part, 0);
      area += part;
    }
    EXPECT_EQ(area, expected);
  }
}

TEST(PolygonHoles, ASquareWithAHole) {
  Rings rings = rectangle(0, 0, 9, 9);
  rings.push_back(rectangle(3, 3, 6, 6)[0]);
  expect_filled(rings);
  std::reverse(rings[1].begin(), rings[1].end());
  expect_filled(rings);
  std::reverse(rings[0].begin(), rings[0].end());
  expect_filled(rings);
}

TEST(PolygonHoles, BehindEachOther) {
  Rings rings = rectangle(0, 0, 20, 9);
  for (double x = 2; x < 18; x += 4) {
    rings.push_back(rectangle(x, 3, x + 2, 6)[0]);
  }
  expect_filled(rings);
}

TEST(PolygonHoles, ThatTouchTheirOutlineOrEachOtherAtACorner) {
  Rings rings{{{0, 0, 0}, {12, 0, 0}, {12, 12, 0}, {0, 12, 0}, {0, 6, 0}}};
  rings.push_back({{0, 6, 0}, {3, 3, 0}, {3, 9, 0}});
  rings.push_back({{3, 9, 0}, {6, 6, 0}, {6, 10, 0}});
  expect_filled(rings);
}

TEST(PolygonHoles, InAnOutlineThatBendsAroundThem) {
  // A horseshoe, whose nearest corner is behind a wall.
  const std::vector<Vec3> outline{{0, 0, 0}, {12, 0, 0}, {12, 10, 0}, {8, 10, 0},
                                  {8, 3, 0}, {7, 3, 0},  {7, 10, 0},  {0, 10, 0}};
  Rings rings{outline};
  rings.push_back({{5, 4, 0}, {6, 4, 0}, {6, 6, 0}});
  rings.push_back({{9, 4, 0}, {10, 4, 0}, {9, 6, 0}});
  expect_filled(rings);
}

TEST(PolygonHoles, AnywhereInCellsOfAGrid) {
  test::for_each_case("polygon holes", 60, [](Rng& rng) {
    const std::size_t cells = 1 + rng.below(5);
    const double side = 16.0 * static_cast<double>(cells);
    Rings rings = rectangle(0, 0, side, side);
    for (std::size_t i = 0; i < cells; ++i) {
      for (std::size_t j = 0; j < cells; ++j) {
        if (rng.below(3) == 0) {
          continue;
        }
        // A star-shaped hole around the cell's middle, on whole numbers.
        const double x = 16.0 * static_cast<double>(i) + 8;
        const double y = 16.0 * static_cast<double>(j) + 8;
        const auto reach = [&] { return static_cast<double>(1 + rng.below(7)); };
        std::vector<Vec3> hole;
        for (const Vec3& way : {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}, Vec3{-1, 1, 0},
                                Vec3{-1, 0, 0}, Vec3{-1, -1, 0}, Vec3{0, -1, 0}, Vec3{1, -1, 0}}) {
          const double length = reach();
          hole.push_back({x + length * way.x, y + length * way.y, 0});
        }
        if (rng.below(2) == 0) {
          std::reverse(hole.begin(), hole.end());
        }
        std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(rng.below(8)),
                    hole.end());
        rings.push_back(hole);
      }
    }
    expect_filled(rings);
  });
}

TEST(PolygonHoles, OutsideOfTheirOutlineAreLeftOut) {
  Rings rings = rectangle(0, 0, 9, 9);
  rings.push_back(rectangle(20, 3, 26, 6)[0]);
  expect_filled(rings, 1);
}

TEST(PolygonHoles, OfFewerThanThreeCornersAreLeftOut) {
  Rings rings = rectangle(0, 0, 9, 9);
  rings.push_back({{3, 3, 0}, {4, 4, 0}});
  expect_filled(rings, 1);
}

TEST(PolygonHoles, OfNothingAreNothing) {
  HoleJoiner joiner;
  EXPECT_TRUE(joiner.join({}, {}).empty());
  EXPECT_EQ(joiner.left_out(), 0U);
}

}  // namespace
}  // namespace soms
