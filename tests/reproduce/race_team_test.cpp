#include "thesis/races/race_team.h"

#include "soms/base/error.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace soms::reproduce {
namespace {

/// Lines on their way from one thread to another.
class Lines {
 public:
  void put(std::string_view line) {
    const std::lock_guard lock(mutex_);
    lines_.emplace_back(line);
    changed_.notify_all();
  }

  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

  std::string take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || !lines_.empty(); });
    if (lines_.empty()) {
      throw Error(ErrorKind::cancelled, "gone", "");
    }
    std::string line = std::move(lines_.front());
    lines_.pop_front();
    return line;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> lines_;
  bool closed_ = false;
};

struct Ends {
  Lines to_follower;
  Lines to_leader;
};

class End : public LineChannel {
 public:
  End(Lines& out, Lines& in) : out_(&out), in_(&in) {}

  void send(std::string_view line) override { out_->put(line); }

  [[nodiscard]] std::string receive() override { return in_->take(); }

 private:
  Lines* out_;
  Lines* in_;
};

/// An experiment of two races, of which counting decides the second. Each process times its own
/// number, and what it was given to count.
RoundsByWork two_races(RaceProcess& process, double own, int& counted) {
  RoundsByWork all = process.gather("first", [&] {
    return RoundsByWork{{own, own + 0.1}, {1, 2}};
  });
  const Decision decision = process.decide("how much", [&] {
    ++counted;
    return Decision{0.1, 7};
  });
  RoundsByWork rest =
      process.gather("second", [&] { return RoundsByWork{{own + decision.at(1)}}; });
  all.push_back(std::move(rest.at(0)));
  return all;
}

/// A follower in a thread, as a process of its own would be.
class Follower {
 public:
  Follower(int processes, double own, std::vector<std::string>& items)
      : thread_([this, processes, own, &items] {
          End leader(ends_.to_leader, ends_.to_follower);
          RaceFollower follower(processes, leader);
          try {
            follower.serve([&](std::string_view item) {
              items.emplace_back(item);
              (void)two_races(follower, own, counted);
            });
          } catch (const Error&) {
            // The test is over.
          }
        }) {}

  ~Follower() {
    ends_.to_follower.close();
    thread_.join();
  }

  Follower(const Follower&) = delete;
  Follower& operator=(const Follower&) = delete;

  [[nodiscard]] std::unique_ptr<LineChannel> channel() {
    return std::make_unique<End>(ends_.to_follower, ends_.to_leader);
  }

  int counted = 0;

 private:
  Ends ends_;
  std::thread thread_;
};

TEST(RaceTeam, RoundsOfAllProcessesComeOneProcessAfterTheOther) {
  std::vector<std::string> items;
  Follower second(3, 20, items);
  std::vector<std::string> items_of_third;
  Follower third(3, 30, items_of_third);
  RaceLeader leader(3, [&] {
    RaceLeader::Followers followers;
    followers.push_back(second.channel());
    followers.push_back(third.channel());
    return followers;
  });
  int counted = 0;
  for (const char* const item : {"one", "two"}) {
    leader.begin(item);
    const RoundsByWork all = two_races(leader, 10, counted);
    EXPECT_EQ(all,
              (RoundsByWork{{10, 10.1, 20, 20.1, 30, 30.1}, {1, 2, 1, 2, 1, 2}, {17, 27, 37}}));
  }
  leader.begin("three");  // followers leave the item before
  EXPECT_EQ(items, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(items_of_third, items);
  EXPECT_EQ(counted, 2);
  EXPECT_EQ(second.counted, 0);  // it gets what was counted
}

TEST(RaceTeam, WithoutARaceNoProcessIsStarted) {
  int started = 0;
  RaceLeader leader(5, [&] {
    ++started;
    return RaceLeader::Followers();
  });
  leader.begin("counts");
  EXPECT_EQ(leader.decide("a", [] { return Decision{1}; }), Decision{1});
  leader.begin("counts, too");
  EXPECT_EQ(started, 0);
}

/// Says these lines, whatever it hears.
class Script : public LineChannel {
 public:
  explicit Script(std::deque<std::string> lines) : lines_(std::move(lines)) {}

  void send(std::string_view) override {}

  [[nodiscard]] std::string receive() override {
    if (lines_.empty()) {
      throw Error(ErrorKind::unsupported, "ended", "");
    }
    std::string line = std::move(lines_.front());
    lines_.pop_front();
    return line;
  }

 private:
  std::deque<std::string> lines_;
};

RoundsByWork race_against(const std::string& answer) {
  RaceLeader leader(2, [&] {
    RaceLeader::Followers followers;
    followers.push_back(std::make_unique<Script>(std::deque<std::string>{"ready", answer}));
    return followers;
  });
  leader.begin("item");
  return leader.gather("bunny, level 15", [] { return RoundsByWork{{1, 2}}; });
}

TEST(RaceTeam, AnotherRaceIsAnError) {
  EXPECT_EQ(race_against("race bunny, level 15\t0.5\t3 4"), (RoundsByWork{{1, 2, 3, 4}}));
  for (const char* const wrong :
       {"race bunny, level 14\t0.5\t3 4", "race bunny, level 15\t0.5\t3",
        "race bunny, level 15\t0.5\t3 4 5", "race bunny, level 15\t0.5\t3 x", "end"}) {
    EXPECT_THROW((void)race_against(wrong), std::logic_error) << wrong;
  }
}

TEST(RaceTeam, ProcessThatEndsIsAnError) {
  RaceLeader leader(2, [] {
    RaceLeader::Followers followers;
    followers.push_back(std::make_unique<Script>(std::deque<std::string>{"ready"}));
    return followers;
  });
  leader.begin("item");
  EXPECT_THROW((void)leader.gather("race", [] { return RoundsByWork{{1}}; }), Error);
}

TEST(RaceTeam, FollowerThatDecidesSomethingElseIsAnError) {
  Script leader({"item one", "decision how many\t1", "go"});
  RaceFollower follower(2, leader);
  EXPECT_THROW(follower.serve([&](std::string_view) {
    (void)follower.decide("how much", [] { return Decision{}; });
  }),
               std::logic_error);
}

TEST(RaceTeam, EachProcessTimesItsShareOfTheRounds) {
  Script leader({});
  const RaceFollower five(5, leader);
  EXPECT_EQ(rounds_of_each(five, 20), 4);
  EXPECT_EQ(rounds_of_each(five, 21), 5);
  EXPECT_EQ(rounds_of_each(five, 2), 1);
  EXPECT_EQ(rounds_of_each(sole_process(), 20), 20);
  int runs = 0;
  const std::vector<std::function<void()>> works{[&] { ++runs; }};
  const std::vector<Timing> alone =
      time_in_turn(sole_process(), {.label = "race", .rounds = 6, .warm_up = 2}, {}, works);
  EXPECT_EQ(runs, 8);
  EXPECT_EQ(alone.at(0).processes, 1);
}

}  // namespace
}  // namespace soms::reproduce
