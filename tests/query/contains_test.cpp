#include "soms/query/contains.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/query/reference/contains.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <string>
#include <vector>

namespace soms {
namespace {

/// The box from (0, 0, 0) to (1, 1, 1).
Mesh unit_cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(
        {static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1), static_cast<double>(i >> 2)});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

template <class Ask>
Error contains_error(const Ask& ask) {
  try {
    ask();
  } catch (const Error& error) {
    return error;
  }
  return {ErrorKind::usage, "no error", ""};
}

TEST(Contains, TellsInsideOutsideAndOn) {
  const ClosedBody cube{Body(unit_cube())};
  EXPECT_EQ(contains(cube, Vec3{0.5, 0.25, 0.75}).side, Side::inside);
  EXPECT_EQ(contains(cube, Vec3{1.5, 0.25, 0.75}).side, Side::outside);
  EXPECT_EQ(contains(cube, Vec3{1, 0.25, 0.75}).side, Side::on);
  EXPECT_EQ(contains(cube, Vec3{0, 0, 0}).side, Side::on);
  EXPECT_EQ(contains(cube, Vec3{-0.0, 1, 0.5}).side, Side::on);
  EXPECT_EQ(contains(cube, Vec3{0x1p-1074, 0.5, 0.5}).side, Side::inside);
  EXPECT_EQ(contains(cube, Vec3{-0x1p-1074, 0.5, 0.5}).side, Side::outside);
  EXPECT_EQ(contains(cube, Vec3{0x1p300, -0x1p300, 0.5}).side, Side::outside);
  EXPECT_EQ(contains(ClosedBody(Body(unit_cube())), Vec3{0.5, 0.5, 0.5}).side, Side::inside);
}

TEST(Contains, HasNothingInsideOfNothing) {
  const ClosedBody nothing{Body{}};
  EXPECT_EQ(contains(nothing, Vec3{0, 0, 0}), (Contains{.side = Side::outside}));
  EXPECT_EQ(contains(nothing, std::vector<Vec3>(3)).side, std::vector<Side>(3, Side::outside));
  EXPECT_EQ(contains(ClosedBody(Body(unit_cube())), std::vector<Vec3>{}), ContainsBatch{});
}

TEST(Contains, RefusesAnOpenBodyAndNamesItsEdges) {
  Mesh mesh = unit_cube();
  mesh.source = "box.ply";
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);  // the lid
  const Error error = contains_error([&] { static_cast<void>(ClosedBody(Body(mesh))); });
  EXPECT_EQ(error.kind(), ErrorKind::not_closed);
  EXPECT_EQ(error.place(),
            "box.ply: not closed: 4 edges belong to an odd number of triangles, the first of "
            "triangle 3 from (1, 0, 1) to (0, 0, 1), of triangle 5 from (0, 1, 1) to (1, 1, 1), of "
            "triangle 7 from (0, 0, 1) to (0, 1, 1)");
  const Error moved = contains_error(
      [&] { static_cast<void>(ClosedBody(Body(mesh, Pose::translation(8, 0, 0)))); });
  EXPECT_EQ(moved.kind(), ErrorKind::not_closed);
  EXPECT_NE(moved.place().find("from (9, 0, 1) to (8, 0, 1)"), std::string::npos);
}

TEST(Contains, RefusesPointsAndPosesThatAreNone) {
  const ClosedBody cube{Body(unit_cube())};
  const Error nan = contains_error([&] {
    static_cast<void>(contains(cube, Vec3{0, std::numeric_limits<double>::quiet_NaN(), 0}));
  });
  EXPECT_EQ(nan.kind(), ErrorKind::not_finite);
  EXPECT_EQ(nan.place(), "point: y is not a finite number");
  const std::vector<Vec3> points{{0, 0, 0}, {0, 0, std::numeric_limits<double>::infinity()}};
  const Error infinite = contains_error([&] { static_cast<void>(contains(cube, points)); });
  EXPECT_EQ(infinite.kind(), ErrorKind::not_finite);
  EXPECT_EQ(infinite.place(), "point 1: z is not a finite number");
  const Error far = contains_error([&] {
    static_cast<void>(contains(cube, Vec3{0x1.1p300, 0, 0}));
  });
  EXPECT_EQ(far.kind(), ErrorKind::out_of_range);
  Pose skewed;
  skewed.m[1] = 0.5;
  EXPECT_EQ(contains_error([&] { static_cast<void>(cube.at(skewed)); }).kind(),
            ErrorKind::not_rigid);
  EXPECT_EQ(
      contains_error([&] { static_cast<void>(ClosedBody(Body(unit_cube(), skewed))); }).kind(),
      ErrorKind::not_rigid);
}

TEST(Contains, IsCutByADeadlineAndSaysSo) {
  const ClosedBody cube{Body(unit_cube())};
  Limits late{.deadline = std::chrono::steady_clock::time_point::min()};
  const Contains answer = contains(cube, Vec3{0.5, 0.5, 0.5}, late);
  EXPECT_EQ(answer.side, Side::undecided);
  EXPECT_EQ(answer.coverage, Coverage::cut);
  const std::vector<Vec3> points(3000, {0.5, 0.5, 0.5});
  late.threads = 2;
  const ContainsBatch batch = contains(cube, points, late);
  EXPECT_EQ(batch.side, std::vector<Side>(3000, Side::undecided));
  EXPECT_EQ(batch.coverage, std::vector<Coverage>(batch.size(), Coverage::cut));
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(contains_error([&] {
              static_cast<void>(contains(cube, points, {.stop = source.get_token()}));
            }).kind(),
            ErrorKind::cancelled);
}

TEST(Contains, CountsItsWork) {
  const ClosedBody cube{Body(unit_cube())};
  const Contains far = contains(cube, Vec3{7, 7, 7});
  EXPECT_EQ(far.cost, Cost{});
  const Contains answer = contains(cube, Vec3{0.5, 0.25, 0.75});
  EXPECT_GT(answer.cost.node_tests, 0U);
  EXPECT_GT(answer.cost.triangle_tests, 0U);
  const std::vector<Vec3> points{{7, 7, 7}, {0.5, 0.25, 0.75}, {0.5, 0.25, 0.75}};
  Cost twice = answer.cost;
  twice += answer.cost;
  const ContainsBatch batch = contains(cube, points);
  EXPECT_EQ(batch.cost, twice);
  EXPECT_EQ(batch.at(0), far);
  EXPECT_EQ(batch.at(2), answer);
}

// The surface that moves is the rounded one: a T-junction may open, and is whole at other poses.
TEST(Contains, OfABodyWithATJunctionDependsOnItsPose) {
  Mesh mesh;  // a tetrahedron with a corner on one of its edges
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {1, 2, 0}, {1, 1, 3}, {1, 0, 0}};
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 0, 3}, {0, 4, 3}, {4, 1, 3}};
  const Vec3 middle{1.25, 0.75, 0.75};
  const ClosedBody body{Body(mesh)};
  EXPECT_EQ(contains(body, middle).side, Side::inside);
  const Pose shift = Pose::translation(4, -8, 16);
  EXPECT_EQ(contains(body.at(shift), shift.apply(middle)).side, Side::inside);
  const Pose turn = Pose::from_axis_angle({1, 2, 3}, 0.7);
  EXPECT_EQ(contains_error([&] { static_cast<void>(body.at(turn)); }).kind(),
            ErrorKind::not_closed);
  mesh.triangles.push_back({0, 1, 4});  // fills the gap
  EXPECT_EQ(contains(ClosedBody(Body(mesh, turn)), turn.apply(middle)).side, Side::inside);
}

TEST(Contains, ComparesBodiesByShapeAndPose) {
  const ClosedBody cube{Body(unit_cube())};
  EXPECT_EQ(cube, ClosedBody(Body(unit_cube())));
  EXPECT_EQ(cube.at({}), cube);
  EXPECT_FALSE(cube.at(Pose::translation(1, 0, 0)) == cube);
}

// Blocks of points are shared out among threads; what they answer is one.
TEST(Contains, AnswersManyPointsAlikeForAnyNumberOfThreads) {
  const ClosedBody body{Body(generate_knot(3000))};
  const Box box = body.body().shape.bounds();
  Rng rng(3);
  std::vector<Vec3> points;
  for (int i = 0; i < 5000; ++i) {
    points.push_back({rng.uniform(box.lower.x, box.upper.x), rng.uniform(box.lower.y, box.upper.y),
                      rng.uniform(box.lower.z, box.upper.z)});
  }
  const ContainsBatch one = contains(body, points);
  EXPECT_EQ(contains(body, points, {.threads = 2}), one);
  EXPECT_EQ(contains(body, points, {.threads = 5}), one);
  const std::vector<Vec3> some(points.begin(), points.begin() + 100);
  EXPECT_EQ(reference::contains_by_brute_force(body.body(), some),
            std::vector<Side>(one.side.begin(), one.side.begin() + 100));
}

}  // namespace
}  // namespace soms
