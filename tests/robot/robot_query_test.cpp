#include "soms/robot/robot_query.h"

#include "soms/base/error.h"
#include "soms/base/print.h"
#include "soms/query/print.h"
#include "soms/robot/print.h"

#include "tests/robot/robots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace soms {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

RobotAnswer at(const RobotModel& model, const std::vector<double>& state,
               const RobotOptions& options = {}, const Limits& limits = {}) {
  return robot_contacts(model, state, options, limits).at(0);
}

TEST(RobotContacts, AreExact) {
  const RobotModel model(test::sliding_robot({test::cube(1), test::cube(1)}));
  EXPECT_EQ(at(model, {0, 2}).verdict, RobotVerdict::contact);
  EXPECT_EQ(at(model, {0, std::nextafter(2.0, 3.0)}).verdict, RobotVerdict::free);
  const RobotAnswer touching = at(model, {0, 2});
  ASSERT_EQ(touching.contacts.size(), 1U);
  EXPECT_EQ(touching.contacts[0], (RobotContact{{1, false, 2}, true}));
  EXPECT_EQ(touching.coverage, Coverage::complete);
  EXPECT_EQ(at(model, {0, 5}).contacts.size(), 0U);
}

TEST(RobotContacts, FindLinksInsideOfClosedBodies) {
  const RobotModel small_first(test::sliding_robot({test::cube(1), test::cube(3)}));
  const RobotModel large_first(test::sliding_robot({test::cube(3), test::cube(1)}));
  for (const RobotModel* const model : {&small_first, &large_first}) {
    const RobotAnswer inside = at(*model, {0, 0.5});
    EXPECT_EQ(inside.verdict, RobotVerdict::contact);
    ASSERT_EQ(inside.contacts.size(), 1U);
    EXPECT_FALSE(inside.contacts[0].surfaces_meet);
    EXPECT_TRUE(at(*model, {0, 2.5}).contacts.at(0).surfaces_meet);
    EXPECT_EQ(at(*model, {0, 4.5}).verdict, RobotVerdict::free);
  }
}

TEST(RobotContacts, FindAnOpenLinkInsideOfAClosedOneAndNotTheOtherWay) {
  EXPECT_EQ(
      at(RobotModel(test::sliding_robot({test::open_cube(1), test::cube(3)})), {0, 0}).verdict,
      RobotVerdict::contact);
  // What is inside of an open body nobody knows.
  const RobotModel open(test::sliding_robot({test::cube(1), test::open_cube(3)}));
  EXPECT_EQ(at(open, {0, 0}).verdict, RobotVerdict::undecided);
  EXPECT_EQ(at(open, {0, 5}).verdict, RobotVerdict::free);
}

TEST(RobotContacts, FindOneOfSeveralConnectedPartsInside) {
  // Two cubes, 10 apart; the other link is a large cube that holds the second alone.
  const Mesh two = test::joined(test::cube(1), test::mapped(test::cube(1), [](Vec3 v) {
                                  return v + Vec3{0, 10, 0};
                                }));
  const RobotModel model(test::sliding_robot({two, test::mapped(test::cube(3), [](Vec3 v) {
                                                return v + Vec3{0, 10, 0};
                                              })}));
  const RobotAnswer answer = at(model, {0, 0});
  ASSERT_EQ(answer.contacts.size(), 1U);
  EXPECT_FALSE(answer.contacts[0].surfaces_meet);
}

TEST(RobotContacts, OfAVoidAreNone) {
  // A hollow cube: outside where it is hollow, as `contains` says.
  Mesh hollow = test::joined(test::cube(5), test::cube(3));
  hollow.parts.clear();
  EXPECT_EQ(at(RobotModel(test::sliding_robot({test::cube(1), hollow})), {0, 0}).verdict,
            RobotVerdict::free);
  EXPECT_EQ(at(RobotModel(test::sliding_robot({test::cube(0.5), hollow})), {4, 0}).verdict,
            RobotVerdict::contact);
}

TEST(RobotContacts, WithTheCellNameItsParts) {
  Mesh cell = test::joined(test::mapped(test::cube(1),
                                        [](Vec3 v) {
                                          return v + Vec3{5, 0, 0};
                                        }),
                           test::mapped(test::cube(1), [](Vec3 v) {
                             return v + Vec3{-5, 0, 0};
                           }));
  cell.parts = {{.name = "right", .first = 0, .count = 12},
                {.name = "left", .first = 12, .count = 12}};
  const std::vector<Mesh> meshes{cell};
  const RobotModel model(test::sliding_robot({test::cube(1)}), meshes);
  EXPECT_EQ(at(model, {0}).verdict, RobotVerdict::free);
  ASSERT_EQ(at(model, {-3}).contacts.size(), 1U);
  EXPECT_EQ(at(model, {-3}).contacts[0].pair, (RobotPair{1, true, 1}));
  EXPECT_EQ(at(model, {3.5}).contacts.at(0).pair, (RobotPair{1, true, 0}));
  const RobotModel moved(test::sliding_robot({test::cube(1)}), meshes,
                         {.base = Pose::translation(4, 0, 0)});
  EXPECT_EQ(at(moved, {0}).contacts.at(0).pair, (RobotPair{1, true, 0}));
}

TEST(RobotContacts, StopAtTheFirstOnRequest) {
  const RobotModel model(
      test::sliding_robot({test::cube(1), test::cube(1), test::cube(1), test::cube(1)}));
  const std::vector<double> state{0, 1, 1.5, 50};
  EXPECT_EQ(at(model, state).contacts.size(), 3U);
  const RobotAnswer first = at(model, state, {.first_contact = true});
  EXPECT_EQ(first.coverage, Coverage::first);
  ASSERT_EQ(first.contacts.size(), 1U);
  EXPECT_EQ(first.contacts[0].pair, (RobotPair{1, false, 2}));
  EXPECT_EQ(at(model, {0, 20, 40, 60}, {.first_contact = true}).coverage, Coverage::complete);
}

TEST(RobotContacts, MeasureTheLeastGap) {
  const RobotModel model(test::sliding_robot({test::cube(1), test::cube(1), test::cube(1)}));
  const RobotAnswer answer = at(model, {0, 5, 9}, {.distance = true});
  ASSERT_TRUE(answer.gap);
  EXPECT_EQ(answer.gap->distance, (Bracket{2, 2}));
  EXPECT_EQ(answer.gap->pair, (RobotPair{2, false, 3}));
  ASSERT_TRUE(answer.gap->points);
  EXPECT_EQ(answer.gap->points->front().x, 6);
  EXPECT_EQ(answer.gap->points->back().x, 8);
  EXPECT_FALSE(at(model, {0, 5, 9}).gap);
  // Equally near: the least pair.
  EXPECT_EQ(at(model, {0, 5, 10}, {.distance = true}).gap->pair, (RobotPair{1, false, 2}));
  EXPECT_EQ(at(model, {10, 5, 0}, {.distance = true}).gap->pair, (RobotPair{1, false, 2}));
  const RobotGap contact = *at(model, {0, 1, 9}, {.distance = true}).gap;
  EXPECT_EQ(contact.distance, (Bracket{0, 0}));
  EXPECT_EQ(contact.pair, (RobotPair{1, false, 2}));
  EXPECT_FALSE(contact.points);
}

TEST(RobotContacts, MeasureNoFartherThanWanted) {
  const RobotModel model(test::sliding_robot({test::cube(1), test::cube(1)}));
  const auto gap = [&](double x, double most) {
    return *at(model, {0, x}, {.distance = true, .at_most = most}).gap;
  };
  EXPECT_TRUE(gap(5, 2).farther);
  EXPECT_EQ(gap(5, 2).distance, (Bracket{2, kNever}));
  EXPECT_FALSE(gap(5, 3).farther);
  EXPECT_EQ(gap(5, 3).distance, (Bracket{3, 3}));
  EXPECT_EQ(gap(2, 0).distance, (Bracket{0, 0}));
}

TEST(RobotContacts, OfNothingComparedAreNone) {
  const RobotModel model(test::sliding_robot({test::cube(1)}));
  const RobotAnswer answer = at(model, {0}, {.distance = true, .at_most = 1});
  EXPECT_EQ(answer.verdict, RobotVerdict::free);
  EXPECT_EQ(answer.gap->distance, (Bracket{kNever, kNever}));
  EXPECT_FALSE(answer.gap->farther);
  const Robot still{.name = "still", .links = {{.name = "only"}}};
  EXPECT_EQ(robot_contacts(RobotModel(still), {}).size(), 1U);
}

TEST(RobotContacts, SayWhichJointsAreBeyondTheirLimits) {
  const RobotModel model(test::sliding_robot({test::cube(1), test::cube(1)}));
  const RobotAnswer answer = at(model, {101, 0});
  EXPECT_EQ(answer.beyond_limits, std::vector<std::uint32_t>{0});
  EXPECT_EQ(answer.verdict, RobotVerdict::free);
}

TEST(RobotContacts, RefuseStatesThatAreNoneAndNameThem) {
  const RobotModel model(test::sliding_robot({test::cube(1), test::cube(1)}));
  const auto message = [&](const std::vector<double>& states, const RobotOptions& options = {}) {
    try {
      static_cast<void>(robot_contacts(model, states, options));
    } catch (const Error& error) {
      return error.place();
    }
    return std::string("none");
  };
  EXPECT_EQ(message({1, 2, 3}), "3 numbers are not whole states of 2");
  EXPECT_NE(message({0, 0, 0, 1e300}).find("state 1: link b: "), std::string::npos);
  EXPECT_NE(message({0, 0, std::nan(""), 0}).find("state 1: the value of joint"),
            std::string::npos);
  EXPECT_NE(message({0, 0}, {.at_most = 1}), "none");
  EXPECT_NE(message({0, 0}, {.distance = true, .at_most = -1}), "none");
  EXPECT_EQ(message({0, 0}, {.distance = true, .at_most = 0}), "none");
}

TEST(RobotContacts, ArePastADeadlineUndecided) {
  const RobotModel model(test::sliding_robot({test::cube(1), test::cube(1)}));
  const RobotAnswer answer =
      at(model, {0, 1}, {}, {.deadline = std::chrono::steady_clock::time_point::min()});
  EXPECT_EQ(answer.verdict, RobotVerdict::undecided);
  EXPECT_EQ(answer.coverage, Coverage::cut);
}

TEST(RobotContacts, EndWhereTheCallerStopsThem) {
  const RobotModel model(test::sliding_robot({test::cube(1), test::cube(1)}));
  StopSource source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(robot_contacts(model, std::vector<double>{0, 1}, {},
                                                {.stop = source.get_token()})),
               Error);
}

}  // namespace
}  // namespace soms
