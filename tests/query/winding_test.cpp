#include "soms/query/winding.h"

#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/query/reference/winding.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stop_token>
#include <vector>

namespace soms {
namespace {

using test::box_body;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The box from 0 to 1, its first two triangles at z = 0.
Mesh closed_box() {
  return box_body({0, 0, 0}, {1, 1, 1});
}

/// The same without the two triangles of a face.
Mesh open_box() {
  Mesh mesh = closed_box();
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
  mesh.parts.clear();
  mesh.faces.clear();
  return mesh;
}

/// Small squares on a lattice, each by itself: 3 edges of boundary a triangle, or 4 a square.
Mesh squares(int side) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < side * side; ++i) {
    const Vec3 a{static_cast<double>(i % side), static_cast<double>(i / side), 0.01 * (i % 7)};
    const Vec3 b = a + Vec3{0.5, 0, 0};
    const Vec3 c = a + Vec3{0, 0.5, 0.1};
    triangles.push_back({a, b, c});
  }
  return test::soup_body(triangles);
}

template <class Ask>
ErrorKind winding_error(const Ask& ask) {
  try {
    ask();
  } catch (const Error& error) {
    return error.kind();
  }
  return ErrorKind::unsupported;
}

TEST(Winding, OfAClosedBodyIsTheIntegerItself) {
  const WindingIndex box{Body(closed_box())};
  EXPECT_EQ(box.boundary_edges(), 0U);
  EXPECT_EQ(winding(box, Vec3{0.5, 0.25, 0.75}).number, (Bracket{1, 1}));
  EXPECT_EQ(winding(box, Vec3{0.5, 0.25, 0.75}).side, Side::inside);
  EXPECT_EQ(winding(box, Vec3{1.5, 0.25, 0.75}).number, (Bracket{0, 0}));
  EXPECT_EQ(winding(box, Vec3{1.5, 0.25, 0.75}).side, Side::outside);
  EXPECT_EQ(winding(box, Vec3{0x1p-1074, 0.5, 0.5}).number, (Bracket{1, 1}));
  EXPECT_EQ(winding(box, Vec3{-0x1p-1074, 0.5, 0.5}).number, (Bracket{0, 0}));
  EXPECT_EQ(winding(box, Vec3{0x1p300, -0x1p300, 0.5}).number, (Bracket{0, 0}));
}

TEST(Winding, CountsWaysThatTrianglesFace) {
  Mesh turned = closed_box();
  for (auto& t : turned.triangles) {
    std::swap(t[0], t[1]);
  }
  EXPECT_EQ(winding(WindingIndex(Body(turned)), Vec3{0.5, 0.5, 0.25}).number, (Bracket{-1, -1}));
  const Mesh twice = test::joined(closed_box(), closed_box());
  EXPECT_EQ(winding(WindingIndex(Body(twice)), Vec3{0.5, 0.5, 0.25}).number, (Bracket{2, 2}));
  const Mesh cancelled = test::joined(closed_box(), turned);
  EXPECT_EQ(winding(WindingIndex(Body(cancelled)), Vec3{0.5, 0.5, 0.25}).number, (Bracket{0, 0}));
}

// From the middle of a box each face is seen under a sixth of all directions.
TEST(Winding, OfABoxWithoutLidIsFiveSixthsInTheMiddle) {
  const WindingIndex box{Body(open_box())};
  EXPECT_EQ(box.boundary_edges(), 4U);
  const Winding middle = winding(box, Vec3{0.5, 0.5, 0.5});
  EXPECT_EQ(middle.side, Side::inside);
  EXPECT_LE(middle.number.lower, 5.0 / 6);
  EXPECT_GE(middle.number.upper, 5.0 / 6);
  EXPECT_LT(middle.number.upper - middle.number.lower, 1e-12);
}

// In the middle of the lid that is missing, by symmetry, half of all directions meet the box.
TEST(Winding, IsUndecidedWhereItIsHalf) {
  const Mesh mesh = open_box();
  const WindingIndex box{Body(mesh)};
  Vec3 lid{0.5, 0.5, 0};
  for (int face = 0; face < 6; ++face) {
    Vec3 p{0.5, 0.5, 0.5};
    p[static_cast<std::size_t>(face) / 2] = face % 2;
    lid = winding(box, p).side == Side::on ? lid : p;
  }
  const Winding half = winding(box, lid);
  EXPECT_EQ(half.side, Side::undecided);
  EXPECT_EQ(half.coverage, Coverage::complete);
  EXPECT_LE(half.number.lower, 0.5);
  EXPECT_GE(half.number.upper, 0.5);
  EXPECT_LT(half.number.upper - half.number.lower, 1e-12);
}

TEST(Winding, OnTheSurfaceHoldsBothSides) {
  const WindingIndex box{Body(box_body({0, 0, 0}, {1, 1, 1}, 3))};
  const Winding face = winding(box, Vec3{1, 0.4, 0.45});
  EXPECT_EQ(face.side, Side::on);
  EXPECT_LE(face.number.lower, 0);
  EXPECT_GE(face.number.upper, 1);
  EXPECT_LT(face.number.upper - face.number.lower, 1 + 1e-12);
  for (const Vec3& p : {Vec3{1, 1, 0.5}, Vec3{0, 0, 0}, Vec3{-0.0, 1, 0.1}}) {
    const Winding edge = winding(box, p);
    EXPECT_EQ(edge.side, Side::on);
    EXPECT_LE(edge.number.lower, 0);
    EXPECT_GE(edge.number.upper, 1);
  }
  // On the rim of a hole, too.
  const Winding rim = winding(WindingIndex(Body(open_box())), Vec3{0, 0, 0});
  EXPECT_EQ(rim.side, Side::on);
  EXPECT_LE(rim.number.lower, 0);
  EXPECT_GE(rim.number.upper, 1);
}

TEST(Winding, OfATJunctionWithoutHoleIsNearlyTheInteger) {
  // The edge from 0 to 1 of the first face ends in the middle for its neighbors.
  std::vector<Triangle> soup;
  const Mesh mesh = closed_box();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(static_cast<TriangleId>(i));
    const Vec3 middle = (t.a + t.b) * 0.5;
    if (i == 0) {
      soup.push_back({t.a, middle, t.c});
      soup.push_back({middle, t.b, t.c});
    } else {
      soup.push_back(t);
    }
  }
  const WindingIndex index{Body(test::soup_body(soup))};
  EXPECT_EQ(index.boundary_edges(), 3U);
  const Bracket number = winding(index, Vec3{0.4, 0.3, 0.2}).number;
  EXPECT_LE(number.lower, 1);
  EXPECT_GE(number.upper, 1);
  EXPECT_LT(number.upper - number.lower, 1e-12);
}

TEST(Winding, DoesNotDependOnTreesLayoutsOrThreads) {
  const Mesh mesh = squares(40);
  Rng rng(51);
  std::vector<Vec3> points;
  for (int i = 0; i < 600; ++i) {
    points.push_back({rng.uniform(-5, 45), rng.uniform(-5, 45), rng.uniform(-1, 1)});
  }
  const Pose pose = Pose::from_quaternion(0.5, 0.5, -0.5, 0.5, {1, 2, 3});
  const WindingIndex index{Body(mesh, pose)};
  const WindingBatch batch = winding(index, points);
  EXPECT_EQ(winding(index, points, {}, {.threads = 3}), batch);
  for (const Layout layout : {Layout::wide, Layout::compact}) {
    const ShapeOptions options{.build = {.rule = Rule::sah, .per_leaf = 1}, .layout = layout};
    const WindingBatch other = winding(WindingIndex(Body(Shape(mesh, options), pose)), points);
    EXPECT_EQ(other.lower, batch.lower);
    EXPECT_EQ(other.upper, batch.upper);
    EXPECT_EQ(other.side, batch.side);
  }
  for (std::size_t i = 0; i < points.size(); i += 50) {
    EXPECT_EQ(winding(index, points[i]), batch.at(i));
  }
}

TEST(Winding, TakesFarTrianglesTogetherAsTheWidthAllows) {
  const WindingIndex index{Body(squares(60))};
  EXPECT_EQ(index.boundary_edges(), 3U * 3600);
  Rng rng(7);
  std::vector<Vec3> points;
  for (int i = 0; i < 100; ++i) {
    points.push_back({rng.uniform(0, 60), rng.uniform(0, 60), rng.uniform(-3, 3)});
  }
  points.push_back({1e4, 2e4, 3e4});
  std::uint64_t edges = std::numeric_limits<std::uint64_t>::max();
  for (const double width : {0.0, 1e-9, 1e-5, 1e-2}) {
    const WindingBatch batch = winding(index, points, {.width = width});
    EXPECT_LT(batch.cost.triangle_tests, edges) << width;
    edges = batch.cost.triangle_tests;
    const std::vector<Bracket> twin = reference::winding_by_brute_force(index.body(), points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_LE(batch.lower[i], twin[i].upper);
      ASSERT_GE(batch.upper[i], twin[i].lower);
      ASSERT_LE(batch.upper[i] - batch.lower[i], width + 1e-9);
    }
  }
  // Far away, the root is all that is looked at.
  EXPECT_LT(winding(index, Vec3{1e6, 2e6, 3e6}).cost.triangle_tests, 10U);
}

// Rays cross triangles of many layers; those of far nodes are part of their moments.
TEST(Winding, CountsCrossingsOfFarTrianglesOnce) {
  std::vector<Triangle> layers;
  for (int i = 0; i < 24 * 24 * 48; ++i) {
    const Vec3 a{static_cast<double>(i % 24), static_cast<double>(i / 24 % 24), 0.4 * (i / 576)};
    layers.push_back({a, a + Vec3{0.9, 0, 0.1}, a + Vec3{0, 0.9, 0}});
  }
  const WindingIndex index{Body(test::soup_body(layers))};
  Rng rng(8);
  std::vector<Vec3> points;
  for (int i = 0; i < 100; ++i) {
    points.push_back({rng.uniform(0, 24), rng.uniform(0, 24), rng.uniform(0, 19)});
  }
  const WindingBatch batch = winding(index, points, {.width = 1});
  EXPECT_LT(batch.cost.triangle_tests, points.size() * 3 * layers.size() / 2);
  const std::vector<Bracket> twin = reference::winding_by_brute_force(index.body(), points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_LE(batch.lower[i], twin[i].upper);
    ASSERT_GE(batch.upper[i], twin[i].lower);
  }
}

TEST(Winding, IsNarrowBesideEdgesOfTheBoundary) {
  const WindingIndex index{Body(test::soup_body({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}))};
  for (int k = 1; k <= 52; k += 3) {
    const double off = std::ldexp(1.0, -k);
    const Winding beside = winding(index, Vec3{0.25, -off, off});
    EXPECT_LT(beside.number.upper - beside.number.lower, 1e-11) << k;
    EXPECT_NEAR(beside.number.lower, -0.125, off + 1e-12);
  }
  EXPECT_LT(winding(index, Vec3{0.25, -0x1p-70, 0}).number.upper, 1e-8);
}

TEST(Winding, OfTinyAndHugeTrianglesIsThatOfUsualOnes) {
  for (const int k : {-1070, -600, -300, 200, 290}) {
    const double unit = std::ldexp(1.0, k);
    const WindingIndex index{
        Body(test::mapped(open_box(), [&](const Vec3& v) { return v * (8 * unit); }))};
    const Bracket middle = winding(index, Vec3{4 * unit, 4 * unit, 4 * unit}).number;
    EXPECT_LE(middle.lower, 5.0 / 6);
    EXPECT_GE(middle.upper, 5.0 / 6);
    EXPECT_LT(middle.upper - middle.lower, 1e-12) << k;
  }
}

TEST(Winding, HasNothingInsideOfNothing) {
  const WindingIndex nothing{Body{}};
  EXPECT_EQ(winding(nothing, Vec3{1, 2, 3}), (Winding{.side = Side::outside}));
  EXPECT_EQ(winding(nothing, std::vector<Vec3>(3)).side, std::vector<Side>(3, Side::outside));
  EXPECT_EQ(winding(WindingIndex(Body(open_box())), std::vector<Vec3>{}), WindingBatch{});
}

TEST(Winding, LeavesPointsUndecidedAfterTheDeadline) {
  const WindingIndex index{Body(squares(20))};
  const std::vector<Vec3> points{{1, 2, 0.5}, {3, 4, 5}};
  const WindingBatch late =
      winding(index, points, {}, {.deadline = std::chrono::steady_clock::time_point::min()});
  EXPECT_EQ(late.coverage.front(), Coverage::cut);
  EXPECT_EQ(late.side, std::vector<Side>(2, Side::undecided));
  EXPECT_EQ(late.at(0).number, (Bracket{-kInfinite, kInfinite}));
  EXPECT_EQ(late.at(1).coverage, Coverage::cut);
}

TEST(Winding, RefusesWhatItCannotAnswer) {
  const WindingIndex index{Body(closed_box())};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(winding_error([&] {
              static_cast<void>(winding(index, Vec3{0, nan, 0}));
            }),
            ErrorKind::not_finite);
  EXPECT_EQ(winding_error([&] {
              static_cast<void>(winding(index, Vec3{0, 0, 0x1p301}));
            }),
            ErrorKind::out_of_range);
  for (const double width : {-1.0, 1.5, nan}) {
    EXPECT_EQ(winding_error([&] { static_cast<void>(winding(index, Vec3{}, {.width = width})); }),
              ErrorKind::usage);
  }
  Pose skewed;
  skewed.m[1] = 0.5;
  EXPECT_EQ(winding_error([&] { WindingIndex(Body(closed_box(), skewed)); }), ErrorKind::not_rigid);
  std::stop_source stopped;
  stopped.request_stop();
  EXPECT_EQ(winding_error([&] { WindingIndex(Body(squares(20)), {.stop = stopped.get_token()}); }),
            ErrorKind::cancelled);
  EXPECT_EQ(
      winding_error([&] {
        static_cast<void>(winding(index, std::vector<Vec3>(9), {}, {.stop = stopped.get_token()}));
      }),
      ErrorKind::cancelled);
}

TEST(Winding, IndexSaysWhatItHolds) {
  const WindingIndex index{Body(squares(20))};
  EXPECT_GT(index.memory(), 400U * 24);
  EXPECT_LT(index.memory(), 400U * 2000);
  const WindingIndex copy = index;
  EXPECT_EQ(copy, index);
}

}  // namespace
}  // namespace soms
