#include "thesis/races/race_team.h"

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <span>
#include <stdexcept>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::string_view kItem = "item ";
constexpr std::string_view kDecision = "decision ";
constexpr std::string_view kRace = "race ";
constexpr std::string_view kGo = "go";
constexpr std::string_view kOver = "over";
constexpr std::string_view kReady = "ready";
constexpr std::string_view kEnd = "end";

/// Leaves an experiment whose last race is over. No error: nothing that handles those may stop it.
struct ItemOver {};

/// Processor time of all threads of this process.
double own_processor_seconds() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

std::logic_error out_of_step(std::string_view expected, std::string_view got) {
  return std::logic_error(
      fmt::format("processes that time races are out of step at '{}', another one is at '{}': a "
                  "fault of soms, please report it",
                  expected, got.substr(0, got.find('\t'))));
}

/// What comes before the first tab of a line, or all; the line is cut to what comes after.
std::string_view cut(std::string_view& line) {
  const std::size_t tab = line.find('\t');
  const std::string_view word = line.substr(0, tab);
  line = tab == std::string_view::npos ? std::string_view() : line.substr(tab + 1);
  return word;
}

/// Shortest digits that give the same numbers again.
std::string words_of(std::span<const double> numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

std::vector<double> numbers_of(std::string_view text) {
  const std::string words(text);
  std::vector<double> numbers;
  const char* at = words.c_str();
  for (char* end = nullptr; *at != '\0'; at = end) {
    numbers.push_back(std::strtod(at, &end));
    if (end == at) {
      throw out_of_step("numbers", words);
    }
  }
  return numbers;
}

std::string line_of(std::string_view label, double seconds, const RoundsByWork& rounds) {
  std::vector<double> all;
  for (const std::vector<double>& of_work : rounds) {
    all.insert(all.end(), of_work.begin(), of_work.end());
  }
  return fmt::format("{}{}\t{}\t{}", kRace, label, seconds, words_of(all));
}

/// What a follower timed.
struct Timed {
  double seconds = 0;
  RoundsByWork rounds = {};
};

/// Reads a follower's line. \shape as many works, and rounds of each, as in `own`.
Timed timed_of(std::string_view line, std::string_view label, const RoundsByWork& own) {
  const std::string_view got = line;
  if (!line.starts_with(kRace)) {
    throw out_of_step(label, got);
  }
  line.remove_prefix(kRace.size());
  if (cut(line) != label) {
    throw out_of_step(label, got);
  }
  Timed timed{.seconds = numbers_of(cut(line)).at(0)};
  const std::vector<double> numbers = numbers_of(line);
  auto at = numbers.begin();
  for (const std::vector<double>& of_work : own) {
    if (of_work.size() > static_cast<std::size_t>(numbers.end() - at)) {
      throw out_of_step(label, got);
    }
    const auto end = at + static_cast<std::ptrdiff_t>(of_work.size());
    timed.rounds.emplace_back(at, end);
    at = end;
  }
  if (at != numbers.end()) {
    throw out_of_step(label, got);
  }
  return timed;
}

}  // namespace

RaceLeader::RaceLeader(int processes, std::function<Followers()> start)
    : processes_(processes), start_(std::move(start)) {
}

Decision RaceLeader::decide(const std::string& label, const std::function<Decision()>& count) {
  decisions_.emplace_back(label, count());
  return decisions_.back().second;
}

void RaceLeader::start_followers() {
  if (followers_) {
    return;
  }
  followers_ = start_();
  for (const auto& follower : *followers_) {
    if (const std::string line = follower->receive(); line != kReady) {
      throw out_of_step(kReady, line);
    }
  }
}

RoundsByWork RaceLeader::gather(const std::string& label,
                                const std::function<RoundsByWork()>& time) {
  start_followers();
  const RoundsByWork own = time();
  RoundsByWork all = own;
  for (const auto& follower : *followers_) {
    if (!begun_) {
      follower->send(fmt::format("{}{}", kItem, item_));
    }
    for (const auto& [name, decision] : decisions_) {
      follower->send(fmt::format("{}{}\t{}", kDecision, name, words_of(decision)));
    }
    follower->send(kGo);
    const Timed timed = timed_of(follower->receive(), label, own);
    processor_seconds_ += timed.seconds;
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].insert(all[i].end(), timed.rounds[i].begin(), timed.rounds[i].end());
    }
  }
  begun_ = true;
  decisions_.clear();
  return all;
}

void RaceLeader::begin(std::string_view item) {
  if (begun_) {
    for (const auto& follower : *followers_) {
      follower->send(kOver);
    }
  }
  begun_ = false;
  decisions_.clear();
  item_ = item;
}

Decision RaceFollower::decide(const std::string& label, const std::function<Decision()>&) {
  if (decisions_.empty() || decisions_.front().first != label) {
    throw out_of_step(label, decisions_.empty() ? "no decision" : decisions_.front().first);
  }
  Decision decision = std::move(decisions_.front().second);
  decisions_.pop_front();
  return decision;
}

RoundsByWork RaceFollower::gather(const std::string& label,
                                  const std::function<RoundsByWork()>& time) {
  RoundsByWork own = time();
  const double seconds = own_processor_seconds();
  leader_->send(line_of(label, seconds - std::exchange(reported_seconds_, seconds), own));
  wait_for_turn();
  return own;
}

void RaceFollower::wait_for_turn() {
  for (std::string line = leader_->receive(); line != kGo; line = leader_->receive()) {
    if (line == kOver) {
      throw ItemOver();
    }
    std::string_view rest = line;
    if (!rest.starts_with(kDecision)) {
      throw out_of_step(kGo, line);
    }
    rest.remove_prefix(kDecision.size());
    const std::string_view label = cut(rest);
    decisions_.emplace_back(label, numbers_of(rest));
  }
}

void RaceFollower::serve(const std::function<void(std::string_view item)>& run) {
  leader_->send(kReady);
  while (true) {
    const std::string line = leader_->receive();
    if (!line.starts_with(kItem)) {
      throw out_of_step(kItem, line);
    }
    try {
      wait_for_turn();
      run(std::string_view(line).substr(kItem.size()));
      leader_->send(kEnd);
      wait_for_turn();
    } catch (const ItemOver&) {
      decisions_.clear();
    }
  }
}

}  // namespace soms::reproduce
