#include "soms/scene/contact_tracker.h"

#include "soms/base/error.h"
#include "soms/scene/print.h"
#include "soms/scene/scene.h"

#include "tests/scene/random_bodies.h"
#include "tests/scene/scenes.h"
#include "tests/support/support.h"

#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace soms {

namespace {

using PairSet = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Changes by looking up every pair.
template <typename Event>
std::vector<Event> changes_by_look_up(const PairSet& before, const PairSet& now) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, ContactChange> changes;
  for (const auto& pair : before) {
    changes[pair] = now.count(pair) != 0 ? ContactChange::stay : ContactChange::end;
  }
  for (const auto& pair : now) {
    changes.emplace(pair, ContactChange::begin);
  }
  std::vector<Event> events;
  for (const auto& [pair, change] : changes) {
    events.push_back({pair.first, pair.second, change});
  }
  return events;
}

TEST(ContactTracker, FollowsWhoTouchesWhomFromStepToStep) {
  std::map<ContactChange, std::size_t> seen;
  test::for_each_case("scene/contact-tracker", 30, [&](Rng& rng) {
    Scene scene = test::random_scene(rng, 6, 20, 5);
    ContactTracker tracker;
    PairSet parts_before;
    PairSet movers_before;
    for (int step = 0; step < 8; ++step) {
      const OverlapMode mode = rng.below(2) == 0 ? OverlapMode::all : OverlapMode::any;
      PairSet parts;
      PairSet movers;
      const StepReport expected = test::scan(scene);
      for (const EnvironmentContact& contact : expected.environment) {
        parts.emplace(contact.mover, contact.part);
      }
      for (const MoverContact& contact : expected.movers) {
        movers.emplace(contact.a, contact.b);
      }
      const ContactEvents events = tracker.follow(scene.step({.mode = mode}));
      ASSERT_EQ(events.environment, changes_by_look_up<EnvironmentEvent>(parts_before, parts));
      ASSERT_EQ(events.movers, changes_by_look_up<MoverEvent>(movers_before, movers));
      for (const EnvironmentEvent& event : events.environment) {
        ++seen[event.change];
      }
      parts_before = parts;
      movers_before = movers;
      for (const MoverId id : scene.movers()) {
        if (rng.below(3) == 0) {
          scene.set_pose(id, test::random_pose(rng, 6));
        } else if (rng.below(20) == 0) {
          scene.remove_mover(id);
        }
      }
    }
  });
  EXPECT_GT(seen[ContactChange::begin], 100U);
  EXPECT_GT(seen[ContactChange::stay], 100U);
  EXPECT_GT(seen[ContactChange::end], 100U);
}

TEST(ContactTracker, IsAValueAndItsEventsAreText) {
  StepReport report;
  report.environment = {{3, 0, 7, 8}, {3, 0, 9, 1}, {4, 1, 0, 0}};
  report.movers = {{3, 5, 1, 1}};
  ContactTracker tracker;
  const ContactTracker fresh = tracker;
  const ContactEvents first = tracker.follow(report);
  EXPECT_NE(tracker, fresh);
  ContactTracker copy = tracker;
  EXPECT_EQ(copy, tracker);
  report.environment = {{3, 0, 9, 9}};
  report.movers = {{3, 6, 1, 1}};
  const ContactEvents second = tracker.follow(report);
  EXPECT_EQ(copy.follow(report), second);
  EXPECT_NE(second, first);
  std::ostringstream text;
  text << second << '\n';
  for (const EnvironmentEvent& event : second.environment) {
    text << event << '\n';
  }
  for (const MoverEvent& event : second.movers) {
    text << event << '\n';
  }
  EXPECT_EQ(text.str(),
            "ContactEvents{environment: 2, movers: 2}\n"
            "EnvironmentEvent{mover: 3, part: 0, change: stay}\n"
            "EnvironmentEvent{mover: 4, part: 1, change: end}\n"
            "MoverEvent{a: 3, b: 5, change: end}\n"
            "MoverEvent{a: 3, b: 6, change: begin}\n");
  tracker.clear();
  EXPECT_EQ(tracker, fresh);
  EXPECT_EQ(tracker.follow(report).environment.front().change, ContactChange::begin);
}

TEST(ContactTracker, RefusesReportsThatLackPairs) {
  const auto refused = [](ContactTracker& tracker, const StepReport& report) {
    try {
      static_cast<void>(tracker.follow(report));
    } catch (const Error& error) {
      return error.kind() == ErrorKind::usage;
    }
    return false;
  };
  Rng rng(2);
  Scene scene = test::random_scene(rng, 4, 10, 3);
  ContactTracker tracker;
  EXPECT_TRUE(refused(tracker, scene.step({.scope = StepScope::first_contact})));
  EXPECT_EQ(tracker, ContactTracker());
  const StepReport all = scene.step();
  static_cast<void>(tracker.follow(all));
  const ContactTracker before = tracker;
  EXPECT_TRUE(refused(tracker, scene.step({.mover_mover = false})));
  EXPECT_EQ(tracker, before);
  tracker.clear();
  EXPECT_FALSE(refused(tracker, scene.step({.mover_mover = false})));
  EXPECT_TRUE(refused(tracker, all));
}

}  // namespace

}  // namespace soms
