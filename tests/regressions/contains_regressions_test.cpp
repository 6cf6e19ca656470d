// Faults that users of other libraries reported, as far as they speak of what is inside: one test a
// report. An id is never used again.
#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/geometry/closedness.h"
#include "soms/geometry/defects.h"
#include "soms/query/contains.h"
#include "soms/query/distance.h"
#include "soms/query/reference/contains.h"
#include "soms/query/winding.h"
#include "soms/tree/rule/rules.h"

#include "tests/regressions/cube.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::mapped;

bool is_exact(const Vec3& v, int k) {
  return std::abs(std::ldexp(v.x, k)) <= 0x1p200 && (v.x == 0 || std::abs(v.x) > 0x1p-900);
}

/// Expects these sides under the 24 rotations of the cube, on the vertices and as poses, at scales
/// of 2^-40 to 2^40, with triangles in reverse order and turned over, and by every rule and layout.
void expect_sides(const Mesh& mesh, const std::vector<Vec3>& points,
                  const std::vector<Side>& sides) {
  for (const Pose& turn : test::cube_rotations()) {
    std::vector<Vec3> turned;
    for (const Vec3& p : points) {
      turned.push_back(turn.apply(p));
    }
    const auto rotate = [&](const Vec3& v) { return turn.apply(v); };
    ASSERT_EQ(contains(Body(mapped(mesh, rotate)), turned).side, sides);
    ASSERT_EQ(contains(Body(mesh, turn), turned).side, sides);
  }
  for (const int k : {-40, -13, 1, 40}) {
    std::vector<Vec3> scaled;
    for (const Vec3& p : points) {
      ASSERT_TRUE(is_exact(p, k));
      scaled.push_back(p * std::ldexp(1.0, k));
    }
    ASSERT_EQ(
        contains(Body(mapped(mesh, [&](const Vec3& v) { return v * std::ldexp(1.0, k); })), scaled)
            .side,
        sides);
  }
  Mesh reversed = mesh;
  std::reverse(reversed.triangles.begin(), reversed.triangles.end());
  for (std::size_t i = 0; i < reversed.triangles.size(); i += 3) {
    std::swap(reversed.triangles[i][0], reversed.triangles[i][2]);
  }
  ASSERT_EQ(contains(Body(reversed), points).side, sides);
  for (const RuleEntry& rule : rules()) {
    for (const int per_leaf : {1, 4, 1000}) {
      for (const Layout layout : {Layout::wide, Layout::compact}) {
        const ShapeOptions options{.build = {.rule = rule.rule, .per_leaf = per_leaf},
                                   .layout = layout};
        ASSERT_EQ(contains(Body(Shape(mesh, options)), points).side, sides);
      }
    }
  }
  ASSERT_EQ(reference::contains_by_brute_force(Body(mesh), points), sides);
}

TEST(Regression, R18TheCavityOfAHollowBodyIsOutside) {
  const Mesh hollow = test::joined(box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}),
                                   box_body({-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}));
  expect_sides(hollow, {{0, 0, 0}, {0.2, 0, 0}, {0.05, 0, 0}, {0.6, 0, 0}},
               {Side::outside, Side::inside, Side::on, Side::outside});
}

/// Points in line with the edges of the cube [0, 1]^3, off it, and beyond its edges and corners.
std::vector<Vec3> points_that_graze() {
  std::vector<Vec3> points{{-1, -1, 0}, {-1, -1, -1}};
  Rng rng(19);
  for (int i = 0; i < 10'000; ++i) {
    Vec3 p;
    const std::uint64_t axis = rng.below(3);
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = k == axis ? (rng.below(2) == 0 ? -3 : 1) + rng.uniform(0.001, 2)
                       : static_cast<double>(rng.below(2));
    }
    points.push_back(p);
  }
  for (int i = 0; i < 27; ++i) {
    const auto off = [](int digit) { return digit == 0 ? -1e-3 : digit == 1 ? 0.5 : 1 + 1e-3; };
    if (i != 13) {
      points.push_back({off(i % 3), off(i / 3 % 3), off(i / 9)});
    }
  }
  return points;
}

TEST(Regression, R19RaysThatGrazeEdgesFindNothingInside) {
  const std::vector<Vec3> points = points_that_graze();
  expect_sides(test::cube(), points, std::vector<Side>(points.size(), Side::outside));
  const auto square_of = [](const Vec3& p) {
    const double d =
        distance(Body(test::cube()), Body(test::soup_body({{p, p, p}}))).distance.upper;
    return d * d;
  };
  EXPECT_NEAR(square_of(points[0]), 2, 1e-15);
  EXPECT_NEAR(square_of(points[1]), 3, 1e-15);
}

// A sphere whose corners lie on meridians, in a grid that is in line with them: no stripes.
TEST(Regression, R19AGridAcrossASphereHasNoStripes) {
  const ClosedBody sphere{
      Body(mapped(generate_sphere(1200), [](const Vec3& v) { return v * 0.8; }))};
  std::vector<Vec3> grid;
  for (int i = 0; i < 64 * 64 * 64; ++i) {
    const auto at = [](int k) { return -1 + k * 0.03125; };
    grid.push_back({at(i % 64), at(i / 64 % 64), at(i / 4096)});
  }
  const ContainsBatch batch = contains(sphere, grid);
  std::vector<Vec3> some;
  std::vector<Side> sides;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const double radius = std::sqrt(dot(grid[i], grid[i]));
    if (radius < 0.75 || radius > 0.8) {
      ASSERT_EQ(batch.side[i], radius < 0.75 ? Side::inside : Side::outside);
    } else if (i % 16 == 0) {
      some.push_back(grid[i]);
      sides.push_back(batch.side[i]);
    }
  }
  EXPECT_EQ(reference::contains_by_brute_force(sphere.body(), some), sides);
}

TEST(Regression, R20EveryRunFindsTheSamePointsInside) {
  const Mesh mesh = generate_knot(20'000);
  const Box box = bounds(mesh);
  Rng rng(20);
  std::vector<Vec3> points;
  for (int i = 0; i < 20'000; ++i) {
    points.push_back({rng.uniform(box.lower.x, box.upper.x), rng.uniform(box.lower.y, box.upper.y),
                      rng.uniform(box.lower.z, box.upper.z)});
  }
  const ContainsBatch first = contains(Body(mesh), points);
  for (int run = 0; run < 30; ++run) {
    ASSERT_EQ(contains(Body(mesh), points, {.threads = 1 + run % 3}), first);
  }
  EXPECT_GT(std::count(first.side.begin(), first.side.end(), Side::inside), 100);
}

TEST(Regression, R21TurnedTrianglesChangeNothingInside) {
  const std::vector<Vec3> points{
      {0.5, 0.5, 0.5}, {0.25, 0.5, 0.75}, {1.5, 0.5, 0.5}, {1, 0.5, 0.5}};
  const std::vector<Side> sides{Side::inside, Side::inside, Side::outside, Side::on};
  std::vector<Triangle> soup;
  for (TriangleId i = 0; i < 12; ++i) {
    soup.push_back(test::cube().triangle(i));
  }
  expect_sides(test::soup_body(soup), points, sides);
  Mesh turned = test::cube();
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  expect_sides(turned, points, sides);
  for (std::size_t i = 0; i < turned.triangles.size(); ++i) {
    if (i != 5) {
      std::swap(turned.triangles[i][0], turned.triangles[i][1]);
    }
  }
  expect_sides(turned, points, sides);
}

// Each doubled face cancels itself: what is left is open.
TEST(Regression, R22DoubledFacesAreAnErrorAndNoWrongSign) {
  Mesh mesh = test::cube();
  for (std::size_t i = 0; i < 8; ++i) {
    const auto t = mesh.triangles[i];
    mesh.triangles.push_back({t[0], t[2], t[1]});
  }
  try {
    static_cast<void>(contains(ClosedBody(Body(mesh)), Vec3{0.5, 0.5, 0.5}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_closed);
  }
  // Where all are doubled nothing is left.
  for (std::size_t i = 8; i < 12; ++i) {
    mesh.triangles.push_back(mesh.triangles[i]);
  }
  expect_sides(mesh, {{0.5, 0.5, 0.5}, {0.5, 0.5, 1}}, {Side::outside, Side::on});
}

// The winding number counts what is left: two of six faces.
TEST(Regression, R22DoubledFacesOfOppositeSenseCancelInTheWindingNumber) {
  Mesh mesh = test::cube();
  for (std::size_t i = 0; i < 8; ++i) {
    const auto t = mesh.triangles[i];
    mesh.triangles.push_back({t[0], t[2], t[1]});
  }
  const Winding middle = winding(WindingIndex(Body(mesh)), Vec3{0.5, 0.5, 0.5});
  EXPECT_EQ(middle.side, Side::outside);
  EXPECT_NEAR(middle.number.lower, 1.0 / 3, 1e-12);
  EXPECT_NEAR(middle.number.upper, 1.0 / 3, 1e-12);
  std::vector<Vec3> grid;
  for (int i = 0; i < 64 * 64 * 64; ++i) {
    grid.push_back({i % 64 / 31.5 - 0.5, i / 64 % 64 / 31.5 - 0.5, i / 4096 / 31.5 - 0.5});
  }
  // Triangles without area change nothing.
  mesh.triangles.push_back({0, 0, 1});
  const WindingBatch batch = winding(WindingIndex(Body(mesh)), grid);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    ASSERT_LT(batch.upper[i] - batch.lower[i], batch.side[i] == Side::on ? 7 : 1e-9);
  }
}

TEST(Regression, R23AnOpenBodyHasAWindingNumber) {
  Mesh mesh = test::cube();
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
  const WindingIndex index{Body(mesh)};
  EXPECT_EQ(index.boundary_edges(), 4U);
  const Winding middle = winding(index, Vec3{0.5, 0.5, 0.5});
  EXPECT_EQ(middle.side, Side::inside);
  EXPECT_NEAR(middle.number.lower, 5.0 / 6, 1e-12);
}

TEST(Regression, R23AnOpenBodyIsAnErrorWithItsOddEdges) {
  Mesh mesh = test::cube();
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
  const Closedness found = closedness(mesh);
  EXPECT_FALSE(found.whole.closed);
  EXPECT_EQ(found.whole.odd_edges, 4U);
  EXPECT_EQ(found.whole.odd_edges, find_defects(mesh).open_edges);
  try {
    static_cast<void>(contains(ClosedBody(Body(mesh)), Vec3{0.5, 0.5, 0.5}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_closed);
    EXPECT_NE(error.place().find("not closed: 4 edges belong to an odd number of triangles"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace soms
