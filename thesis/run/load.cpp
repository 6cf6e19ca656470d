#include "thesis/run/load.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <cstdlib>

namespace soms::reproduce {

std::vector<std::string> signs_of_load(const Load& load) {
  std::vector<std::string> signs;
  if (load.timed_seconds <= 0) {
    return signs;
  }
  if (load.start && load.start->front() > kMostLoad * load.processors) {
    signs.push_back(fmt::format("the load average of the minute before the run was {:.2f} on {} {}",
                                load.start->front(), load.processors,
                                load.processors == 1 ? "processor" : "processors"));
  }
  const double share = load.timed_processor_seconds / load.timed_seconds;
  if (load.timed_seconds >= kLeastSeconds && share < kLeastShare) {
    signs.push_back(
        fmt::format("the experiments with times took {:.1f} s and got {:.1f} s of processor time "
                    "({:.0f} %)",
                    load.timed_seconds, load.timed_processor_seconds, 100 * share));
  }
  return signs;
}

bool shows_times(const Result& result) {
  const auto has_times = [](const Table& table) {
    return std::any_of(table.columns.begin(), table.columns.end(),
                       [](const Column& column) { return column.kind == ColumnKind::timed; });
  };
  return std::any_of(result.tables.begin(), result.tables.end(), has_times) ||
         std::any_of(result.figures.begin(), result.figures.end(),
                     [](const Figure& figure) { return figure.timed; });
}

LoadAverages load_averages() {
  std::array<double, 3> averages{};
  const int known = getloadavg(averages.data(), static_cast<int>(averages.size()));
  return known == static_cast<int>(averages.size()) ? LoadAverages(averages) : std::nullopt;
}

double processor_seconds() {
  double seconds = 0;
  for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(whose, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
  }
  return seconds;
}

}  // namespace soms::reproduce
