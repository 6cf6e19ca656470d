// Ways between states: what is proved of them, against states in between.
#include "soms/robot/robot_path.h"

#include "soms/base/error.h"
#include "soms/robot/print.h"

#include "tests/robot/chains.h"
#include "tests/robot/robots.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <span>
#include <vector>

namespace soms {
namespace {

constexpr double kNotOnTheWay = std::numeric_limits<double>::infinity();

std::vector<double> rows(const std::vector<std::vector<double>>& states) {
  std::vector<double> numbers;
  for (const std::vector<double>& state : states) {
    numbers.insert(numbers.end(), state.begin(), state.end());
  }
  return numbers;
}

/// An arm along x that turns about z.
Robot arm(double length) {
  Robot robot{.links = {{.name = "root"}}};
  robot.links.push_back({"arm", {test::box_body({0, -0.01, -0.01}, {length, 0.01, 0.01})}});
  robot.joints.push_back(
      {.name = "turn", .type = JointType::continuous, .parent = 0, .child = 1, .axis = {0, 0, 3}});
  return robot;
}

/// Whether two bodies of `pair` touch in a state.
bool touches(const RobotModel& model, const std::vector<double>& state) {
  return robot_contacts(model, state).front().verdict == RobotVerdict::contact;
}

TEST(RobotPath, AThinPostBetweenTwoFreeStatesIsHit) {
  const std::vector<Mesh> cell{test::box_body({0.9, 0.1, -1}, {0.901, 0.101, 1})};
  const RobotModel model(arm(1), cell);
  const RobotPath path = robot_path(model, std::vector<double>{-0.5, 0, 0.5, -6});
  ASSERT_EQ(path.segments.size(), 3U);
  EXPECT_EQ(path.segments[0].verdict, ContactVerdict::free);
  EXPECT_EQ(path.segments[0].t, (Bracket{1, kNotOnTheWay}));
  EXPECT_EQ(path.segments[0].pair, std::nullopt);
  const RobotSegment& hit = path.segments[1];
  EXPECT_EQ(hit.verdict, ContactVerdict::contact);
  EXPECT_LT(hit.t.upper - hit.t.lower, 1e-9);
  EXPECT_TRUE(touches(model, {0.5 * hit.t.upper}));
  EXPECT_EQ(hit.pair, (RobotPair{1, true, 0}));
  ASSERT_TRUE(hit.point);
  EXPECT_NEAR(hit.point->x, 0.9, 2e-3);
  EXPECT_EQ(path.segments[2].verdict, ContactVerdict::contact);  // by the numbers: more than a turn
  EXPECT_EQ(path.blocked, 1U);
  for (const RobotAnswer& state : path.states) {
    EXPECT_EQ(state.verdict, RobotVerdict::free);
  }
}

// The forearm is turned back as the upper arm turns, so it shifts along a circle.
TEST(RobotPath, AForearmThatIsTurnedBackKeepsItsDirection) {
  Robot robot = arm(1);
  robot.links.push_back({"fore", {test::box_body({0, -0.01, 0.02}, {1, 0.01, 0.03})}});
  robot.joints.push_back({.name = "elbow",
                          .type = JointType::continuous,
                          .parent = 1,
                          .child = 2,
                          .origin = Pose::translation(1, 0, 0),
                          .axis = {0, 0, 1}});
  robot.joints[1].mimic = Mimic{.joint = 0, .multiplier = -1};
  const auto way = [&](double lower, double upper) {
    // At the middle of the way, the end of the forearm is at x = 2, y = 0.
    const std::vector<Mesh> cell{test::box_body({lower, -0.001, 0}, {upper, 0.001, 1})};
    return robot_path(RobotModel(robot, cell), std::vector<double>{-1, 1}).segments.front();
  };
  EXPECT_EQ(way(2.0001, 3).verdict, ContactVerdict::free);
  const RobotSegment hit = way(1.999, 3);
  EXPECT_EQ(hit.verdict, ContactVerdict::contact);
  EXPECT_EQ(hit.pair, (RobotPair{2, true, 0}));
  EXPECT_NEAR(hit.t.upper, 0.5, 0.05);
}

TEST(RobotPath, LinksThatPassThroughEachOtherAreFound) {
  Robot robot = test::sliding_robot({test::cube(0.5), test::cube(0.5)});
  const RobotModel model(robot);
  const RobotPath path = robot_path(model, rows({{0, 2}, {4, 2}, {4, 8}, {2, 6}}));
  EXPECT_EQ(path.segments[0].verdict, ContactVerdict::contact);
  EXPECT_EQ(path.segments[0].pair, (RobotPair{1, false, 2}));
  EXPECT_NEAR(path.segments[0].t.upper, 0.25, 1e-9);
  EXPECT_EQ(path.segments[1].verdict, ContactVerdict::contact);
  EXPECT_NEAR(path.segments[1].t.upper, 0.5 / 3, 1e-9);
  EXPECT_EQ(path.segments[2].verdict, ContactVerdict::free);  // both shift alike
}

TEST(RobotPath, StatesAreThoseOfRobotContacts) {
  const RobotModel model(test::sliding_robot({test::cube(0.5), test::open_cube(2)}));
  // In contact; inside of what is open; free.
  const std::vector<double> states = rows({{0, 2}, {0, 0}, {0, 5}, {0, 6}, {0, 2}});
  const RobotPathOptions options{.states = {.distance = true}};
  const RobotPath path = robot_path(model, states, options);
  EXPECT_EQ(path.states, robot_contacts(model, states, options.states));
  EXPECT_EQ(path.segments[0].verdict, ContactVerdict::started);
  EXPECT_EQ(path.segments[0].t, (Bracket{0, 0}));
  EXPECT_EQ(path.segments[1].verdict, ContactVerdict::contact);
  EXPECT_EQ(path.segments[1].t.lower, 0);  // it may have been inside all the way
  EXPECT_EQ(path.segments[1].undecided, 1U);
  EXPECT_EQ(path.segments[2].verdict, ContactVerdict::free);
  EXPECT_EQ(path.segments[3].verdict, ContactVerdict::contact);
  EXPECT_EQ(path.blocked, 0U);
}

TEST(RobotPath, WhatAnOpenBodyMayHoldIsNotFree) {
  // The small cube stays inside of the large one.
  const RobotModel model(test::sliding_robot({test::cube(0.5), test::open_cube(2)}));
  const RobotPath path = robot_path(model, rows({{0, 0}, {1, 0}}));
  EXPECT_EQ(path.segments[0].verdict, ContactVerdict::grazing);
  EXPECT_EQ(path.segments[0].t, (Bracket{0, kNotOnTheWay}));
  EXPECT_EQ(path.segments[0].undecided, 2U);
}

TEST(RobotPath, ABodyInsideAClosedOneHasStarted) {
  const RobotModel model(test::sliding_robot({test::cube(0.5), test::cube(2)}));
  const RobotPath path = robot_path(model, rows({{0, 0}, {1, 0}, {1, 6}, {6, 6}}));
  EXPECT_EQ(path.segments[0].verdict, ContactVerdict::started);
  EXPECT_EQ(path.segments[1].verdict, ContactVerdict::started);
  // It goes inside through the surface, and the last state is in contact without one.
  EXPECT_EQ(path.segments[2].verdict, ContactVerdict::contact);
  EXPECT_NEAR(path.segments[2].t.upper, 0.5, 1e-9);
}

TEST(RobotPath, AContactInTheLastStateAloneIsFound) {
  const RobotModel model(test::sliding_robot({test::cube(0.5), test::cube(0.5)}));
  const RobotPath path = robot_path(model, rows({{0, 2}, {1, 2}}));
  EXPECT_EQ(path.segments[0].verdict, ContactVerdict::contact);
  EXPECT_GT(path.segments[0].t.lower, 1 - 1e-9);
  EXPECT_EQ(path.segments[0].t.upper, 1);
}

TEST(RobotPath, OneStateHasNoSegment) {
  const RobotModel model(test::sliding_robot({test::cube(0.5)}));
  EXPECT_TRUE(robot_path(model, std::vector<double>{0}).segments.empty());
  EXPECT_EQ(robot_path(model, std::vector<double>{0}).states.size(), 1U);
  EXPECT_TRUE(robot_path(model, {}).states.empty());
}

TEST(RobotPath, MayEndAtTheFirstThatIsBlocked) {
  const RobotModel model(test::sliding_robot({test::cube(0.5), test::cube(0.5)}));
  std::vector<double> states;
  for (int k = 0; k < 40; ++k) {
    states.insert(states.end(), {k % 13 == 7 ? 4.0 : 0.1 * k, 20.0});
    if (k == 20) {
      states.insert(states.end(), {40, 20});
    }
  }
  const RobotPath all = robot_path(model, states);
  ASSERT_EQ(all.blocked, 20U);
  for (const int threads : {1, 3}) {
    const RobotPath path = robot_path(model, states, {.first_blocked = true}, {.threads = threads});
    EXPECT_EQ(path.blocked, all.blocked);
    EXPECT_EQ(path.segments, std::vector(all.segments.begin(), all.segments.begin() + 21));
  }
}

TEST(RobotPath, ADeadlineLeavesSegmentsCut) {
  const RobotModel model(test::sliding_robot({test::cube(0.5), test::cube(0.5)}));
  const RobotPath path = robot_path(model, rows({{0, 2}, {4, 2}}), {},
                                    {.deadline = std::chrono::steady_clock::time_point::min()});
  EXPECT_EQ(path.segments[0].verdict, ContactVerdict::grazing);
  EXPECT_EQ(path.segments[0].coverage, Coverage::cut);
  EXPECT_EQ(path.segments[0].t, (Bracket{0, kNotOnTheWay}));
}

TEST(RobotPath, RefusesWhatItCannotFollow) {
  const std::vector<Mesh> cell{test::box_body({5, 5, 5}, {6, 6, 6})};
  const RobotModel model(arm(1), cell);
  const auto kind = [&](const std::vector<double>& states) {
    try {
      static_cast<void>(robot_path(model, states));
    } catch (const Error& error) {
      EXPECT_EQ(error.place().find(error.kind() == ErrorKind::out_of_range ? "segment 0: " : ""),
                0U);
      return error.kind();
    }
    return ErrorKind::cannot_open;
  };
  EXPECT_EQ(kind({0, 1e7}), ErrorKind::out_of_range);
  EXPECT_EQ(kind({1e13, 1e13}), ErrorKind::out_of_range);
  EXPECT_EQ(kind({0, 6.25}), ErrorKind::cannot_open);  // no error
  EXPECT_EQ(kind({0, std::nan("")}), ErrorKind::not_finite);
  StopSource stop;
  stop.request_stop();
  EXPECT_THROW(static_cast<void>(
                   robot_path(model, std::vector<double>{0, 1}, {}, {.stop = stop.get_token()})),
               Error);
}

/// What was seen of segments, so that no test passes by seeing one kind alone.
struct PathsSeen {
  int free = 0;
  int contact = 0;
  int grazing = 0;
  int between = 0;  ///< contacts between two free states
  int links = 0;    ///< contacts of two links
};

/// Checks one segment against states in between.
void expect_as_sampled(const RobotModel& model, const std::vector<double>& from,
                       const std::vector<double>& to, const RobotSegment& segment) {
  if (segment.t.upper <= 1) {
    const RobotAnswer there = robot_contacts(model, state_between(from, to, segment.t.upper)).at(0);
    ASSERT_EQ(there.verdict, RobotVerdict::contact) << segment;
    const bool named = std::any_of(there.contacts.begin(), there.contacts.end(),
                                   [&](const RobotContact& c) { return c.pair == segment.pair; });
    ASSERT_TRUE(named) << segment;
  }
  std::vector<double> times{std::nextafter(segment.t.lower, 0.0), segment.t.lower * (1 - 1e-12)};
  for (int k = 1; k < 60; ++k) {
    times.push_back(k / 60.0);
  }
  for (const double t : times) {
    if (t < segment.t.lower && t > 0) {
      const RobotAnswer there = robot_contacts(model, state_between(from, to, t)).front();
      ASSERT_TRUE(there.contacts.empty()) << segment << " but at " << t << ": " << there;
    }
  }
}

void expect_paths_as_sampled(Rng& rng, PathsSeen& seen) {
  const double length = rng.below(4) == 0 ? 0x1p-30 : 1;
  const Robot robot = test::random_tree(rng, length);
  std::vector<Mesh> cell;
  for (int k = 0; k < 3; ++k) {
    const Vec3 place = test::random_vector(rng, 3 * length);
    cell.push_back(test::mapped(test::beam(rng, length), [&](const Vec3& v) { return v + place; }));
  }
  const RobotModel model(robot, cell, {.base = Pose::about_z(rng.uniform(-3, 3), {0, 0, length})});
  std::vector<std::vector<double>> states{random_state(model.kinematics(), rng)};
  for (int k = 0; k < 6; ++k) {
    states.push_back(test::random_next_state(rng, model.kinematics(), states.back(), length));
  }
  const RobotPath path = robot_path(model, rows(states));
  if (rng.below(8) == 0) {
    ASSERT_EQ(robot_path(model, rows(states), {}, {.threads = 3}), path);
  }
  if (model.kinematics().size() == 0) {
    return;
  }
  for (std::size_t k = 0; k < path.segments.size(); ++k) {
    const RobotSegment& segment = path.segments[k];
    expect_as_sampled(model, states[k], states[k + 1], segment);
    seen.free += segment.verdict == ContactVerdict::free ? 1 : 0;
    seen.contact += segment.verdict == ContactVerdict::contact ? 1 : 0;
    seen.grazing += segment.verdict == ContactVerdict::grazing ? 1 : 0;
    seen.links += segment.verdict == ContactVerdict::contact && !segment.pair->cell ? 1 : 0;
    seen.between += segment.verdict == ContactVerdict::contact &&
                            path.states[k + 1].verdict == RobotVerdict::free
                        ? 1
                        : 0;
  }
}

TEST(RobotPath, AgreesWithStatesInBetween) {
  PathsSeen seen;
  test::for_each_case("robot-path/sampled", 1000,
                      [&](Rng& rng) { expect_paths_as_sampled(rng, seen); });
  EXPECT_GT(seen.free, 100);
  EXPECT_GT(seen.contact, 40);
  EXPECT_GT(seen.between, 10);
  EXPECT_GT(seen.links, 5);
  EXPECT_LT(seen.grazing, seen.contact / 10);
}

}  // namespace
}  // namespace soms
