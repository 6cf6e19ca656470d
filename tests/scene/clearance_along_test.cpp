#include "soms/scene/clearance_along.h"

#include "soms/base/error.h"
#include "soms/query/distance.h"
#include "soms/scene/print.h"
#include "soms/scene/reference/clearance_along.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

namespace soms {
namespace {

constexpr double kQuarter = 1.57079632679489661923;

Shape cube(double half) {
  return Shape(test::box_mesh({{-half, -half, -half}, {half, half, half}}));
}

Body block(const Vec3& lower, const Vec3& upper) {
  return Body(test::box_mesh({lower, upper}));
}

MotionPath straight(double length) {
  return motion_path({Pose(), Pose::translation(length, 0, 0)});
}

Clearance along(const Shape& mover, const MotionPath& path, const std::vector<Body>& fixed,
                const ClearanceOptions& options) {
  return clearance_along(mover, path, fixed, options);
}

void expect_right(const Clearance& answer, const Shape& mover, const MotionPath& path,
                  const std::vector<Body>& fixed, const ClearanceOptions& options,
                  std::size_t samples) {
  const reference::ClearanceCheck found =
      reference::check_clearance(answer, mover, path, fixed, options, samples);
  EXPECT_EQ(found.wrong, 0U) << found.first << " in " << answer;
}

TEST(ClearanceAlong, StationsAreRowsAndMultiples) {
  const MotionPath path =
      motion_path({Pose(), Pose::translation(2.5, 0, 0), Pose::about_z(kQuarter, {2.5, 0, 0}),
                   Pose::about_z(kQuarter, {2.5, 1.5, 0})});
  const Clearance answer =
      along(cube(0.5), path, {block({9, 9, 9}, {10, 10, 10})}, {.every = 1, .accuracy = 0.1});
  std::vector<double> chainages;
  for (const ClearanceStation& station : answer.stations) {
    chainages.push_back(station.chainage);
  }
  EXPECT_EQ(chainages, (std::vector<double>{0, 1, 2, 2.5, 2.5, 3, 4}));
  EXPECT_EQ(answer.stretches.size(), 6U);
  EXPECT_EQ(answer.stations[4].pose, path.poses[2]);
}

// A pole beside the way, half a meter from where the side of the cube passes it.
TEST(ClearanceAlong, FindsTheLeastGapBetweenStations) {
  const std::vector<Body> pole{block({5.2, 1, -2}, {5.3, 1.1, 2})};
  const ClearanceOptions options{.every = 4, .accuracy = 0.001};
  const Clearance answer = along(cube(0.5), straight(12), pole, options);
  EXPECT_EQ(answer.least.gap, (Bracket{0.5, 0.5}));
  EXPECT_GE(answer.at_least, 0.499);
  EXPECT_LE(answer.at_least, 0.5);
  EXPECT_GT(answer.least.chainage, 4.6);
  EXPECT_LT(answer.least.chainage, 5.9);
  EXPECT_FALSE(answer.first_contact.has_value());
  EXPECT_EQ(answer.coverage, Coverage::complete);
  expect_right(answer, cube(0.5), straight(12), pole, options, 50);
}

// At each station of it the body is free, and a plate thinner than any step is between.
TEST(ClearanceAlong, APlateBetweenTwoStationsIsFound) {
  const std::vector<Body> plate{block({5, -3, -3}, {5.001, 3, 3})};
  const ClearanceOptions options{.every = 10, .accuracy = 0.01};
  const Clearance answer = along(cube(0.05), straight(10), plate, options);
  ASSERT_EQ(answer.stations.size(), 2U);
  EXPECT_FALSE(answer.stations[0].overlaps());
  EXPECT_FALSE(answer.stations[1].overlaps());
  ASSERT_TRUE(answer.first_contact.has_value());
  EXPECT_LE(answer.first_contact->free_until, 4.95);
  EXPECT_GE(answer.first_contact->free_until, 4.93);
  EXPECT_GE(answer.first_contact->station.chainage, 4.95);
  EXPECT_LE(answer.first_contact->station.chainage, 4.97);
  EXPECT_TRUE(answer.first_contact->station.overlaps());
  EXPECT_EQ(verdict(answer.stretches[0], 0), ClearanceVerdict::contact);
  expect_right(answer, cube(0.05), straight(10), plate, options, 200);
}

// The corner of a square that turns on the spot sweeps beyond its sides.
TEST(ClearanceAlong, ATurnOnTheSpotIsSweptToo) {
  const std::vector<Body> wall{block({1.2, -5, -5}, {1.3, 5, 5})};
  const MotionPath turn = motion_path({Pose(), Pose::about_z(kQuarter)});
  const ClearanceOptions options{.every = 1, .accuracy = 0.001};
  const Clearance answer = along(cube(1), turn, wall, options);
  ASSERT_TRUE(answer.first_contact.has_value());
  EXPECT_EQ(answer.stations[0].chainage, answer.stations[1].chainage);
  EXPECT_EQ(verdict(answer.stretches[0], 0), ClearanceVerdict::contact);
  const std::vector<Body> farther{block({1.5, -5, -5}, {1.6, 5, 5})};
  const Clearance free = along(cube(1), turn, farther, options);
  EXPECT_FALSE(free.first_contact.has_value());
  EXPECT_NEAR(free.least.gap.lower, 1.5 - std::sqrt(2), 0.001);
  EXPECT_GE(free.at_least, 1.5 - std::sqrt(2) - 0.002);
}

TEST(ClearanceAlong, AClearanceDecidesLengths) {
  const std::vector<Body> wall{block({2, 1, -1}, {6, 2, 1})};
  const ClearanceOptions options{.every = 1, .accuracy = 0.001, .clearance = 1};
  const Clearance answer = along(cube(0.5), straight(8), wall, options);
  // Beside the wall the gap is 0.5; before and after it, less than 1 within sqrt(0.75) of its ends.
  const double length = 5 + 2 * std::sqrt(0.75);
  EXPECT_LE(answer.below.lower, length);
  EXPECT_GE(answer.below.upper, length);
  EXPECT_LE(answer.below.upper - answer.below.lower, 0.01);
  EXPECT_EQ(verdict(answer.stretches.front(), 1), ClearanceVerdict::below);
  EXPECT_EQ(verdict(answer.stretches.back(), 1), ClearanceVerdict::below);
  EXPECT_GE(answer.at_least, 0.499);
  expect_right(answer, cube(0.5), straight(8), wall, options, 10);
  const Clearance narrow = along(cube(0.5), straight(8), wall, {1, 0.05, 0.25});
  for (const ClearanceStretch& stretch : narrow.stretches) {
    EXPECT_EQ(verdict(stretch, 0.25), ClearanceVerdict::ok);
  }
  EXPECT_EQ(narrow.below, (Bracket{0, 0}));
  EXPECT_LT(narrow.queries, 200U);
}

// A body that moves along a wall at exactly the clearance: no station is below it, and no bound
// proves it.
TEST(ClearanceAlong, ExactlyTheClearanceStaysUndecided) {
  const std::vector<Body> wall{block({-9, 1, -9}, {20, 2, 9})};
  const Clearance answer = along(cube(0.5), straight(1), wall, {0.5, 0.01, 0.5});
  EXPECT_EQ(verdict(answer.stations[0], 0.5), ClearanceVerdict::ok);
  EXPECT_EQ(verdict(answer.stretches[0], 0.5), ClearanceVerdict::undecided);
  EXPECT_EQ(answer.below.lower, 0);
  EXPECT_EQ(answer.below.upper, 1);
}

TEST(ClearanceAlong, NamesTheNearestOfManyBodies) {
  const std::vector<Body> blocks{block({0, 3, 0}, {1, 4, 1}), block({4, 2, 0}, {5, 4, 1}),
                                 block({8, 2, 0}, {9, 4, 1}), block({4, 2, 0}, {5, 4, 1})};
  const Clearance answer = along(cube(0.5), straight(10), blocks, {1, 0.01, 0});
  EXPECT_EQ(answer.stations[0].body, 0U);
  EXPECT_EQ(answer.stations[4].body, 1U);  // the fourth is the same, and comes later
  EXPECT_EQ(answer.stations[9].body, 2U);
}

TEST(ClearanceAlong, AnswersAPathOfOnePoseAndNothingToBeNearTo) {
  const Clearance one = along(cube(1), motion_path({Pose()}), {block({2, -1, -1}, {3, 1, 1})},
                              {.every = 1, .accuracy = 0.1});
  ASSERT_EQ(one.stations.size(), 1U);
  EXPECT_TRUE(one.stretches.empty());
  EXPECT_EQ(one.least.gap, (Bracket{1, 1}));
  EXPECT_EQ(one.at_least, 1);
  const Clearance none = along(cube(1), straight(3), {}, {.every = 1, .accuracy = 0.1});
  EXPECT_EQ(none.stations.size(), 4U);
  EXPECT_EQ(none.at_least, std::numeric_limits<double>::infinity());
  const Clearance empty = along(Shape(), straight(3), {block({0, 0, 0}, {1, 1, 1})},
                                {.every = 1, .accuracy = 0.1, .clearance = 2});
  EXPECT_EQ(empty.at_least, std::numeric_limits<double>::infinity());
  EXPECT_EQ(empty.below, (Bracket{0, 0}));
}

TEST(ClearanceAlong, RefusesOptionsThatMakeNoSense) {
  const auto kind_of = [](const ClearanceOptions& options, double length) {
    try {
      static_cast<void>(along(cube(1), straight(length), {}, options));
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::cancelled;
  };
  EXPECT_EQ(kind_of({.every = 0, .accuracy = 1}, 1), ErrorKind::usage);
  EXPECT_EQ(kind_of({.every = 1, .accuracy = 0}, 1), ErrorKind::usage);
  EXPECT_EQ(kind_of({.every = 1, .accuracy = 1, .clearance = -1}, 1), ErrorKind::usage);
  EXPECT_EQ(kind_of({.every = std::numeric_limits<double>::quiet_NaN(), .accuracy = 1}, 1),
            ErrorKind::usage);
  EXPECT_EQ(kind_of({.every = 1e-9, .accuracy = 1}, 1000), ErrorKind::usage);
}

TEST(ClearanceAlong, AStopThrowsOrKeepsWhatIsDone) {
  StopSource source;
  source.request_stop();
  const std::vector<Body> wall{block({2, 1, -1}, {6, 2, 1})};
  ClearanceOptions options{.every = 1, .accuracy = 0.01};
  EXPECT_THROW(static_cast<void>(clearance_along(cube(1), straight(4), wall, options,
                                                 {.stop = source.get_token()})),
               Error);
  options.keep_on_stop = true;
  const Clearance answer =
      clearance_along(cube(1), straight(4), wall, options, {.stop = source.get_token()});
  EXPECT_EQ(answer.coverage, Coverage::cut);
  EXPECT_TRUE(answer.stations.empty());
}

TEST(ClearanceAlong, ADeadlineCutsIt) {
  const std::vector<Body> wall{block({2, 1, -1}, {6, 2, 1})};
  const ClearanceOptions options{.every = 1, .accuracy = 0.01};
  const Clearance answer =
      clearance_along(cube(1), straight(4), wall, options,
                      {.deadline = std::chrono::steady_clock::time_point::min()});
  EXPECT_EQ(answer.coverage, Coverage::cut);
  EXPECT_TRUE(answer.stations.empty());
}

// Stopped at its second block of places: the first is there, and its bounds hold.
TEST(ClearanceAlong, AStopInTheMiddleLeavesTrueBounds) {
  StopSource source;
  const std::vector<Body> wall{block({2, 1, -1}, {6, 2, 1})};
  const ClearanceOptions options{.every = 0.001, .accuracy = 1e-5, .keep_on_stop = true};
  const Limits limits{.stop = source.get_token(),
                      .progress = [&](double) { source.request_stop(); }};
  const Clearance answer = clearance_along(cube(0.5), straight(4), wall, options, limits);
  EXPECT_EQ(answer.coverage, Coverage::cut);
  EXPECT_EQ(answer.stations.size(), 1024U);
  EXPECT_EQ(answer.stretches.size(), 1023U);
  expect_right(answer, cube(0.5), straight(4), wall, options, 1);
}

/// Turns and shifts of a few poses, some on the spot, some alike.
std::vector<Pose> random_poses(Rng& rng, double scale, double far) {
  std::vector<Pose> poses;
  const std::size_t count = 2 + rng.below(3);
  while (poses.size() < count) {
    Pose pose = test::random_pose(rng, 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pose.m[4 * axis + 3] = scale * pose.m[4 * axis + 3] + far;
    }
    if (!poses.empty() && rng.below(4) == 0) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        pose.m[4 * axis + 3] = poses.back().m[4 * axis + 3];
      }
    }
    poses.push_back(rng.below(8) == 0 && !poses.empty() ? poses.back() : pose);
  }
  return poses;
}

Mesh scaled_mesh(Rng& rng, double scale, double far) {
  Mesh mesh = test::random_mesh(rng);
  for (Vec3& v : mesh.vertices) {
    v = v * scale + Vec3{far, far, far};
  }
  return mesh;
}

// Random, touching, degenerate, tiny and far away: no dense sample refutes a bound, and stations
// are those of brute force.
TEST(ClearanceAlong, NoDenseSampleIsNearerThanTheBounds) {
  test::for_each_case("clearance-along/twin", 120, [](Rng& rng) {
    constexpr std::array kScales{1.0, 1.0, 0x1p-70, 1e3};
    const double scale = kScales[rng.below(kScales.size())];
    const double far = scale == 1 && rng.below(3) == 0 ? 1e6 : 0;
    const Shape mover(scaled_mesh(rng, scale, 0));
    std::vector<Body> fixed;
    for (std::uint64_t k = 0; k <= rng.below(3); ++k) {
      fixed.emplace_back(scaled_mesh(rng, scale, far));
    }
    constexpr std::array kPivots{0.0, 0.0, 1.5};
    const MotionPath path =
        motion_path(random_poses(rng, scale, far),
                    scale * kPivots[rng.below(kPivots.size())] * Vec3{1, -1, 0.5});
    const ClearanceOptions options{.every = scale * rng.uniform(0.4, 3),
                                   .accuracy = scale * rng.uniform(0.05, 0.5),
                                   .clearance = rng.below(2) == 0 ? 0 : scale * rng.uniform(0, 2)};
    const Clearance answer = clearance_along(mover, path, fixed, options);
    const reference::ClearanceCheck found =
        reference::check_clearance(answer, mover, path, fixed, options, 7);
    ASSERT_EQ(found.wrong, 0U) << found.first << " in " << answer;
  });
}

TEST(ClearanceAlong, TheSameForAnyNumberOfThreads) {
  Rng rng(7);
  const Shape mover(test::random_mesh(rng));
  const std::vector<Body> fixed{Body(test::random_mesh(rng)), Body(test::random_mesh(rng))};
  const MotionPath path = motion_path(random_poses(rng, 1, 0));
  const ClearanceOptions options{.every = 0.1, .accuracy = 0.01, .clearance = 0.5};
  const Clearance one = clearance_along(mover, path, fixed, options);
  EXPECT_EQ(clearance_along(mover, path, fixed, options, {.threads = 4}), one);
}

// The twin must be able to refute: bounds that are too good by a little are found out.
TEST(ClearanceAlong, TheTwinRefutesWhatIsWrong) {
  const std::vector<Body> pole{block({5.2, 1, -2}, {5.3, 1.1, 2})};
  const ClearanceOptions options{.every = 4, .accuracy = 0.001};
  const Clearance answer = along(cube(0.5), straight(12), pole, options);
  const auto wrong_of = [&](const Clearance& changed) {
    return reference::check_clearance(changed, cube(0.5), straight(12), pole, options, 20).wrong;
  };
  EXPECT_EQ(wrong_of(answer), 0U);
  Clearance changed = answer;
  changed.stretches[1].at_least = 0.501;
  EXPECT_GT(wrong_of(changed), 0U);
  changed = answer;
  changed.stations[2].gap.lower = std::nextafter(changed.stations[2].gap.lower, 0);
  EXPECT_GT(wrong_of(changed), 0U);
  changed = answer;
  changed.stretches[0].least.triangles->b ^= 1U;
  EXPECT_GT(wrong_of(changed), 0U);
}

}  // namespace
}  // namespace soms
