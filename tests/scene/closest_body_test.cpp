// The nearest of many bodies to points, against a loop over all bodies.
#include "soms/base/error.h"
#include "soms/scene/body_index.h"
#include "soms/scene/print.h"
#include "soms/scene/reference/body_queries.h"

#include "tests/scene/many_bodies.h"
#include "tests/scene/random_bodies.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace soms {
namespace {

constexpr double kEndlessly = std::numeric_limits<double>::infinity();

BodyClosest free_of_cost(BodyClosest answer) {
  answer.cost = {};
  return answer;
}

Body cube_at(double x) {
  return Body(test::box_body({x, 0, 0}, {x + 1, 1, 1}));
}

TEST(ClosestBody, NamesBodyAndTriangle) {
  const std::vector<Body> bodies{cube_at(0), cube_at(4), cube_at(8)};
  const BodyIndex index(bodies);
  const BodyClosest answer = index.closest({5.25, 0.5, 0.5});
  EXPECT_EQ(answer.body, 1U);
  EXPECT_EQ(answer.distance, (Bracket{0.25, 0.25}));
  EXPECT_EQ(answer.point, (Vec3{5, 0.5, 0.5}));
  EXPECT_EQ(answer.triangle, closest(bodies[1], {5.25, 0.5, 0.5}).triangle);
  EXPECT_EQ(index.size(), 3U);
  EXPECT_EQ(index.body(2), bodies[2]);
}

TEST(ClosestBody, WithoutTrianglesIsEndlesslyFar) {
  for (const std::vector<Body>& bodies : {std::vector<Body>(), std::vector<Body>(3)}) {
    for (const double at_most : {kEndlessly, 2.0}) {
      const BodyClosest answer = BodyIndex(bodies).closest({1, 2, 3}, {.at_most = at_most});
      EXPECT_EQ(answer.distance, (Bracket{kEndlessly, kEndlessly}));
      EXPECT_FALSE(answer.farther);
      EXPECT_EQ(answer.body, std::nullopt);
      EXPECT_EQ(answer.triangle, std::nullopt);
      EXPECT_EQ(answer.coverage, Coverage::complete);
    }
  }
}

TEST(ClosestBody, EquallyNearOnesAreDecidedByNumber) {
  const std::vector<Body> bodies{Body(), cube_at(4), cube_at(2), cube_at(4), cube_at(2)};
  const BodyIndex index(bodies);
  EXPECT_EQ(index.closest({3.5, 0.5, 0.5}).body, 1U);  // 0.5 from all four
  EXPECT_EQ(index.closest({2.25, 0.5, 0.5}).body, 2U);
}

// Where no double is the distance, brackets of all are alike, and only exact numbers decide.
TEST(ClosestBody, DistancesBetweenTheSameDoublesAreCompared) {
  const auto slope = [](double lift) {
    return Body(test::soup_body({{{-9, -9, 9 + lift}, {9, -9, 9 + lift}, {0, 9, -9 + lift}}}));
  };
  const Vec3 point{0.1, 1000.3, 1000.2};
  const std::vector<Body> bodies{slope(0), slope(0x1p-48), slope(0x1p-49), slope(0x1p-48)};
  const Closest first = closest(bodies[0], point);
  const Closest second = closest(bodies[1], point);
  ASSERT_EQ(first.distance, second.distance);
  ASSERT_LT(first.distance.lower, first.distance.upper);
  const BodyClosest answer = BodyIndex(bodies).closest(point);
  EXPECT_EQ(answer.body, 1U);
  EXPECT_EQ(answer, BodyIndex(bodies).closest(point));
  EXPECT_EQ(free_of_cost(answer), free_of_cost(reference::closest_by_brute_force(bodies, point)));
}

TEST(ClosestBody, AnswersAsALoopOverAllBodies) {
  test::for_each_case("scene/closest-body", 300, [](Rng& rng) {
    const std::vector<Body> bodies = test::many_bodies(rng);
    const BodyIndex index(bodies);
    std::vector<Vec3> points;
    for (int k = 0; k < 5; ++k) {
      points.push_back(test::point_among(bodies, rng));
    }
    const BodyClosestBatch one = index.closest(points);
    const BodyClosestBatch two = index.closest(points, {}, {}, {.threads = 2});
    ASSERT_EQ(one, two);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const BodyClosest truth = reference::closest_by_brute_force(bodies, points[i]);
      ASSERT_EQ(free_of_cost(one.at(i)), free_of_cost(truth));
      ASSERT_EQ(one.at(i), index.closest(points[i]));
    }
  });
}

TEST(ClosestBody, LimitsAreKeptExactly) {
  test::for_each_case("scene/closest-body/limits", 200, [](Rng& rng) {
    const std::vector<Body> bodies = test::many_bodies(rng);
    const BodyIndex index(bodies);
    const Vec3 point = test::point_among(bodies, rng);
    const BodyClosest truth = free_of_cost(index.closest(point));
    if (!truth.triangle) {
      return;
    }
    const Bracket& d = truth.distance;
    for (const double at_most : {0.0, std::max(0.0, std::nextafter(d.lower, -1.0)), d.lower,
                                 d.upper, std::nextafter(d.upper, kEndlessly)}) {
      const BodyClosest answer = free_of_cost(index.closest(point, {.at_most = at_most}));
      if (at_most >= d.upper) {
        ASSERT_EQ(answer, truth);
      } else {
        BodyClosest farther;
        farther.distance = {at_most, kEndlessly};
        farther.farther = true;
        ASSERT_EQ(answer, farther);
      }
    }
  });
}

TEST(ClosestBody, ABodyThatIsLeftOutTakesNoPart) {
  test::for_each_case("scene/closest-body/except", 200, [](Rng& rng) {
    std::vector<Body> bodies = test::many_bodies(rng);
    if (bodies.empty()) {
      return;
    }
    const BodyIndex index(bodies);
    const Vec3 point = test::point_among(bodies, rng);
    const BodyClosest nearest = index.closest(point);
    const auto out = nearest.body.value_or(0);
    const BodyClosest answer = index.closest(point, {}, {.except = out});
    bodies[out] = Body();
    ASSERT_EQ(free_of_cost(answer), free_of_cost(reference::closest_by_brute_force(bodies, point)));
    ASSERT_FALSE(answer.farther);
    const BodyClosest far = index.closest(point, {.at_most = 0}, {.except = out});
    ASSERT_EQ(far.farther, answer.triangle && answer.distance.upper > 0);
  });
}

// What is far is not visited: the cost is that of few bodies.
TEST(ClosestBody, FarBodiesCostNothing) {
  const Shape cube(test::box_body({0, 0, 0}, {1, 1, 1}));
  std::vector<Body> bodies;
  for (int k = 0; k < 4096; ++k) {
    bodies.emplace_back(cube, Pose::translation(3.0 * (k % 64), 3.0 * (k / 64), 0));
  }
  const BodyIndex index(bodies);
  const BodyClosest answer = index.closest({90.2, 90.2, 1.5});
  EXPECT_EQ(answer.body, 30U * 64U + 30U);
  EXPECT_LT(answer.cost.triangle_tests, 4U * 12U);
  EXPECT_LT(answer.cost.node_tests, 256U);
}

TEST(ClosestBody, ADeadlineCutsIt) {
  const std::vector<Body> bodies{cube_at(0), cube_at(4)};
  const Limits late{.deadline = std::chrono::steady_clock::time_point::min()};
  const BodyClosest answer = BodyIndex(bodies).closest({6, 0.5, 0.5}, {}, {}, late);
  EXPECT_EQ(answer.coverage, Coverage::cut);
  EXPECT_LE(answer.distance.lower, 1);
  EXPECT_GE(answer.distance.upper, 1);
  EXPECT_FALSE(answer.farther);
}

TEST(ClosestBody, FaultsAreNamed) {
  std::vector<Body> bodies{cube_at(0), cube_at(4)};
  const BodyIndex index(bodies);
  const auto kind_of = [](const auto& call) {
    try {
      call();
    } catch (const Error& error) {
      return error.kind();
    }
    ADD_FAILURE() << "no error";
    return ErrorKind::cancelled;
  };
  EXPECT_EQ(kind_of([&] { (void)index.closest({0, kEndlessly, 0}); }), ErrorKind::not_finite);
  EXPECT_EQ(kind_of([&] { (void)index.closest({0, 0, 0}, {.at_most = -1}); }), ErrorKind::usage);
  EXPECT_EQ(kind_of([&] { (void)index.closest({0, 0, 0}, {}, {.except = 2}); }), ErrorKind::usage);
  EXPECT_EQ(kind_of([&] { (void)index.body(2); }), ErrorKind::usage);
  EXPECT_EQ(kind_of([&] { (void)BodyIndex().closest({0, kEndlessly, 0}); }), ErrorKind::not_finite);
  bodies[1].pose.m[0] = 2;
  try {
    const BodyIndex bad(bodies);
    FAIL() << "a pose that is not rigid was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_rigid);
    EXPECT_EQ(error.place().rfind("body 1", 0), 0U) << error.place();
  }
}

}  // namespace
}  // namespace soms
