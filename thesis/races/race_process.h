/// \file
/// Races whose rounds come from several processes that take turns: where a process has its code and
/// data in memory can change a time as much as what is compared, and all rounds of one process
/// share it.
#pragma once

#include "soms/base/limits.h"

#include "thesis/trips/timing.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace soms::reproduce {

/// Milliseconds by work, then by round.
using RoundsByWork = std::vector<std::vector<double>>;

/// Numbers by which counting decides what is timed: frames, passes, offsets.
using Decision = std::vector<double>;

/// The part of this process in the races of a run. By itself, a process that times all rounds.
class RaceProcess {
 public:
  RaceProcess() = default;
  virtual ~RaceProcess() = default;
  RaceProcess(const RaceProcess&) = delete;
  RaceProcess& operator=(const RaceProcess&) = delete;

  /// Processes that share the rounds of a race.
  [[nodiscard]] virtual int processes() const { return 1; }

  /// True if this process times for another one, which counts; what it counts is used by nobody.
  [[nodiscard]] virtual bool times_only() const { return false; }

  /// Processes that the rounds of `gather` come from: one that times only has its own alone.
  [[nodiscard]] int gathered_processes() const { return times_only() ? 1 : processes(); }

  /// What `count` decides. A process that times only gets it from the leader.
  /// \errors Those of `count`; std::logic_error if the other process decides something else now.
  virtual Decision decide(const std::string& label, const std::function<Decision()>& count);

  /// The rounds of a race by all processes, one after the other, from what this one times: as many
  /// from each. Each process must come to the same races in the same order.
  /// \errors Those of `time`; std::logic_error if another process times another race.
  virtual RoundsByWork gather(const std::string& label, const std::function<RoundsByWork()>& time);
};

/// The process that times by itself.
[[nodiscard]] RaceProcess& sole_process();

/// Rounds that each process times, so that all together time at least `rounds`.
[[nodiscard]] int rounds_of_each(const RaceProcess& process, int rounds);

/// A race as its processes name it, and how its rounds are shared.
struct RaceRounds {
  std::string label;  ///< the same in each process
  int rounds = 0;     ///< of all processes together, rounded up to as many in each
  int warm_up = 1;    ///< in each process
};

/// `time_in_turn` by all processes. \shape one Timing a work. \errors Those of `gather`.
[[nodiscard]] std::vector<Timing> time_in_turn(RaceProcess& process, const RaceRounds& race,
                                               const Limits& limits,
                                               std::span<const std::function<void()>> works);

}  // namespace soms::reproduce
