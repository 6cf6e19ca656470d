/// \file
/// Processes of this program that time races for a run (thesis/races/race_team.h).
#pragma once

#include "soms/base/limits.h"

#include "apps/cli/verb.h"
#include "thesis/races/race_team.h"

#include <string>
#include <vector>

namespace soms::command {

/// The verb that they are started with. It is not for people and not in the help.
inline constexpr const char* kTimingVerb = "timing-process";

/// What they need to know.
struct TimingOptions {
  std::string models;  ///< as given to `soms reproduce`
  bool quick = false;
};

/// So many processes can share the rounds of a race here: 1 where the program does not find itself.
[[nodiscard]] int possible_timing_processes();

/// Starts `count` of them. They end with what is returned, at once; a stop of `limits` ends waiting
/// for them. \errors ErrorKind::unsupported where one cannot be started, and later, from a channel,
/// where one ended by itself; out_of_memory; cancelled.
[[nodiscard]] reproduce::RaceLeader::Followers start_timing_processes(int count,
                                                                      const TimingOptions& options,
                                                                      const Shared& shared,
                                                                      const Limits& limits);

Action add_timing_process(Parser& parser, Shared& shared);

}  // namespace soms::command
