// Bodies that are chosen for what short cuts could overlook.
#include "soms/query/solid.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/query/overlap.h"
#include "soms/query/reference/solid.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::joined;

Relation turned_round(Relation relation) {
  return relation == Relation::a_in_b   ? Relation::b_in_a
         : relation == Relation::b_in_a ? Relation::a_in_b
                                        : relation;
}

Mesh cube(double lower, double upper) {
  return box_body({lower, lower, lower}, {upper, upper, upper});
}

/// Expects a relation, both ways round, in both layouts, and of the twin.
void expect_solid(const Mesh& a, const Mesh& b, Relation relation, bool surfaces_meet) {
  for (const Layout layout : {Layout::wide, Layout::compact}) {
    const Body body_a(Shape(a, {.layout = layout}));
    const Body body_b(Shape(b, {.layout = layout}));
    const Solid answer = solid(body_a, body_b);
    EXPECT_EQ(answer.relation, relation);
    EXPECT_EQ(answer.surfaces_meet, surfaces_meet);
    EXPECT_EQ(solid(body_b, body_a).relation, turned_round(relation));
  }
  const Solid truth = reference::solid_by_brute_force(Body(a), Body(b));
  EXPECT_EQ(truth.relation, relation);
  EXPECT_EQ(truth.surfaces_meet, surfaces_meet);
}

/// Each triangle twice: bounds nothing.
Mesh doubled(const Mesh& mesh) {
  return joined(mesh, mesh);
}

TEST(Solid, ABodyInAVoidIsClear) {
  const Mesh shell = joined(cube(0, 10), cube(2, 8));
  expect_solid(shell, cube(3, 5), Relation::clear, false);
  expect_solid(shell, cube(2, 4), Relation::touching, true);
  expect_solid(shell, cube(2, 8), Relation::touching, true);
  expect_solid(shell, cube(0.5, 1.5), Relation::b_in_a, false);
  // Around the void: the shell has no interior in it, and the body has.
  expect_solid(shell, cube(1, 9), Relation::crossing, false);
  expect_solid(shell, cube(-1, 11), Relation::a_in_b, false);
  expect_solid(shell, shell, Relation::same, true);
}

TEST(Solid, PartsTogetherDecide) {
  const Mesh two = joined(cube(0, 1), cube(4, 5));
  expect_solid(two, cube(-1, 6), Relation::a_in_b, false);
  expect_solid(two, cube(-1, 2), Relation::crossing, false);
  expect_solid(two, cube(2, 3), Relation::clear, false);
  expect_solid(two, joined(cube(4, 5), cube(0, 1)), Relation::same, true);
  expect_solid(two, cube(4, 5), Relation::b_in_a, true);
  // One part touches, another is inside; each touches the void of the other body with a corner.
  expect_solid(joined(cube(0, 1), cube(4, 5)), joined(cube(1, 2), cube(3, 6)), Relation::crossing,
               true);
  expect_solid(joined(cube(0, 1), cube(2, 3)), joined(cube(1, 2), cube(-5, 5)), Relation::a_in_b,
               true);
}

TEST(Solid, DoubledFacesBoundNothing) {
  const Mesh nothing = doubled(cube(0, 1));
  expect_solid(nothing, cube(-1, 2), Relation::clear, false);
  expect_solid(nothing, cube(0, 1), Relation::touching, true);
  expect_solid(nothing, nothing, Relation::touching, true);
  expect_solid(nothing, cube(0.5, 2), Relation::touching, true);
  // The doubled part touches; what is inside hangs together with nothing that does.
  const Mesh with_ghost = joined(doubled(box_body({-3, 0, 0}, {-2, 1, 1})), cube(0, 1));
  expect_solid(with_ghost, cube(-2, 2), Relation::a_in_b, true);
  expect_solid(with_ghost, cube(0, 1), Relation::same, true);
}

// The parts that touch hang together with the rest by a doubled triangle, or one without area: from
// neither the rest can be judged.
TEST(Solid, WhatTouchesOnlyWithIdleTrianglesIsLookedAtWhole) {
  Mesh needle = cube(0, 1);
  needle.vertices.push_back({0, 0, 5});
  needle.triangles.push_back({0, static_cast<std::uint32_t>(needle.vertices.size() - 1), 0});
  expect_solid(needle, box_body({-1, -1, 5}, {2, 2, 6}), Relation::touching, true);
  expect_solid(needle, joined(box_body({-1, -1, 5}, {2, 2, 6}), cube(-2, 3)), Relation::a_in_b,
               true);
  Mesh fin = cube(0, 1);
  const auto tip = static_cast<std::uint32_t>(fin.vertices.size());
  fin.vertices.push_back({0, 0, 5});
  fin.vertices.push_back({0.5, 0, 5});
  fin.triangles.push_back({0, tip, tip + 1});
  fin.triangles.push_back({0, tip + 1, tip});
  expect_solid(fin, box_body({-1, -1, 5}, {2, 2, 6}), Relation::touching, true);
  expect_solid(fin, joined(box_body({-1, -1, 5}, {2, 2, 6}), cube(-2, 3)), Relation::a_in_b, true);
}

TEST(Solid, NoCornerOfCrossingBarsIsInTheOther) {
  expect_solid(box_body({-5, -1, -1}, {5, 1, 1}), box_body({-1, -5, -1}, {1, 5, 1}),
               Relation::crossing, true);
  expect_solid(box_body({-5, -1, -1}, {5, 1, 1}), box_body({-1, -5, -2}, {1, 5, 2}),
               Relation::crossing, true);
}

TEST(Solid, BoxesTouchWithFacesEdgesAndCorners) {
  const Mesh box = cube(0, 2);
  expect_solid(box, box_body({2, 0, 0}, {3, 2, 2}), Relation::touching, true);
  expect_solid(box, box_body({2, 0.5, 0.5}, {3, 1, 1}), Relation::touching, true);
  expect_solid(box, box_body({2, 2, 0}, {3, 3, 2}), Relation::touching, true);
  expect_solid(box, cube(2, 3), Relation::touching, true);
  expect_solid(box, cube(0, 1), Relation::b_in_a, true);
  expect_solid(box, box_body({0.5, 0.5, 0}, {1, 1, 2}), Relation::b_in_a, true);
}

TEST(Solid, OfAnEmptyMeshIsClear) {
  const ClosedBody nothing{Body{}};
  EXPECT_EQ(solid(nothing, ClosedBody(Body(cube(0, 1)))).relation, Relation::clear);
  EXPECT_EQ(solid(nothing, nothing).relation, Relation::clear);
}

TEST(Solid, OfAnOpenBodyIsAnError) {
  Mesh open = cube(0, 1);
  open.triangles.pop_back();
  try {
    static_cast<void>(solid(Body(open), Body(cube(0, 1))));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_closed);
    EXPECT_NE(std::string(error.what()).find("3 edges"), std::string::npos) << error.what();
  }
}

TEST(Solid, IsUndecidedWhenTimeIsUp) {
  const Limits late{.deadline = std::chrono::steady_clock::time_point::min()};
  const Solid answer = solid(Body(cube(0, 1)), Body(box_body({1, 0, 0}, {2, 1, 1}, 4)), late);
  EXPECT_EQ(answer.relation, Relation::undecided);
  EXPECT_EQ(answer.why, Undecided::deadline);
  EXPECT_EQ(answer.coverage, Coverage::cut);
}

// At the second pose rounding takes a corner of the T-junction off its edge.
TEST(Solid, IsUndecidedAtAPoseThatOpensTheMover) {
  Mesh mesh;  // a tetrahedron with a corner on one of its edges
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {1, 2, 0}, {1, 1, 3}, {1, 0, 0}};
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 0, 3}, {0, 4, 3}, {4, 1, 3}};
  const std::vector<Pose> poses{Pose{}, Pose::from_axis_angle({1, 2, 3}, 0.7)};
  const ClosedBody mover{Body(mesh)};
  ASSERT_THROW(static_cast<void>(mover.at(poses[1])), Error);
  const SolidBatch batch = solid(mover, poses, ClosedBody(Body(cube(-9, 9))));
  EXPECT_EQ(batch.relation, (std::vector<Relation>{Relation::a_in_b, Relation::undecided}));
  EXPECT_EQ(batch.why, (std::vector<Undecided>{Undecided::none, Undecided::open}));
}

TEST(Solid, BadPosesAreNamed) {
  const ClosedBody body{Body(cube(0, 1))};
  Pose bad;
  bad.m[0] = 2;
  try {
    static_cast<void>(solid(body, std::vector<Pose>{Pose{}, bad}, body));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_rigid);
    EXPECT_NE(std::string(error.what()).find("pose 1"), std::string::npos) << error.what();
  }
}

// Bodies that cross plainly are recognized by a few corners, however large they are.
TEST(Solid, CrossingBodiesCostLittleMoreThanAnyOverlap) {
  const ClosedBody a{Body(generate_knot(20000))};
  const ClosedBody b{Body(generate_knot(20000), Pose::translation(0.4, 0.3, 0.2))};
  const Solid answer = solid(a, b);
  EXPECT_EQ(answer.relation, Relation::crossing);
  const Cost any = overlap(a.body(), b.body(), {.mode = OverlapMode::any}).cost;
  EXPECT_LT(answer.cost.triangle_tests, any.triangle_tests + 1000);
  EXPECT_LT(answer.cost.exact_tests, any.exact_tests + 20);
}

/// A cube from `lower` to `lower` + n, of 12 n^2 triangles.
Mesh fine_cube(int n, const Vec3& lower) {
  Mesh mesh;
  for (std::size_t face = 0; face < 6; ++face) {
    const std::size_t axis = face / 2;
    const auto corner = [&](int i, int j) {
      Vec3 p = lower;
      p[axis] += face % 2 == 0 ? 0 : n;
      p[(axis + 1) % 3] += i;
      p[(axis + 2) % 3] += j;
      mesh.vertices.push_back(p);
      return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const std::uint32_t a = corner(i, j);
        const std::uint32_t b = corner(i + 1, j);
        const std::uint32_t c = corner(i + 1, j + 1);
        const std::uint32_t d = corner(i, j + 1);
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      }
    }
  }
  return mesh;
}

// Of a dozen triangles around one in the same plane none cuts it. With them it was three times as
// many.
TEST(Solid, NeighborsInAPlaneCutNothing) {
  constexpr int kSide = 6;
  const ClosedBody cube_a{Body(fine_cube(kSide, {0, 0, 0}))};
  const ClosedBody beside{Body(fine_cube(kSide, {kSide, 0, 0}))};
  const Solid touching = solid(cube_a, beside);
  EXPECT_EQ(touching.relation, Relation::touching);
  constexpr std::uint64_t kInContact = 2 * (2 * kSide * kSide + 8 * kSide);  // and those at the rim
  EXPECT_LT(touching.cost.exact_tests, 16 * kInContact);
  const Solid same = solid(cube_a, cube_a);
  EXPECT_EQ(same.relation, Relation::same);
  EXPECT_LT(same.cost.exact_tests, std::uint64_t{2} * 12 * kSide * kSide * 12);
}

// No corner of the bars is in the other one.
TEST(Solid, PointsBesideACrossingSpareTheCells) {
  const ClosedBody a{Body(box_body({-5, -1, -1}, {5, 1, 1}))};
  const ClosedBody b{Body(box_body({-1, -5, -2}, {1, 5, 2}))};
  const Solid answer = solid(a, b);
  EXPECT_EQ(answer.relation, Relation::crossing);
  const Cost any = overlap(a.body(), b.body(), {.mode = OverlapMode::any}).cost;
  EXPECT_LT(answer.cost.exact_tests, any.exact_tests + 30);
}

}  // namespace
}  // namespace soms
