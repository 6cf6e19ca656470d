#include "thesis/races/race_process.h"

#include <utility>

namespace soms::reproduce {

Decision RaceProcess::decide(const std::string&, const std::function<Decision()>& count) {
  return count();
}

RoundsByWork RaceProcess::gather(const std::string&, const std::function<RoundsByWork()>& time) {
  return time();
}

RaceProcess& sole_process() {
  static RaceProcess process;
  return process;
}

int rounds_of_each(const RaceProcess& process, int rounds) {
  return (rounds + process.processes() - 1) / process.processes();
}

std::vector<Timing> time_in_turn(RaceProcess& process, const RaceRounds& race, const Limits& limits,
                                 std::span<const std::function<void()>> works) {
  RoundsByWork all = process.gather(race.label, [&] {
    RoundsByWork own;
    for (Timing& timing :
         time_in_turn(rounds_of_each(process, race.rounds), limits, works, race.warm_up)) {
      own.push_back(std::move(timing.rounds));
    }
    return own;
  });
  std::vector<Timing> timings;
  timings.reserve(all.size());
  for (std::vector<double>& of_work : all) {
    timings.push_back(summarize(std::move(of_work), process.gathered_processes()));
  }
  return timings;
}

}  // namespace soms::reproduce
