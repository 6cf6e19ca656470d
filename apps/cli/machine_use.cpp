#include "apps/cli/machine_use.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <string>

namespace soms::command {

namespace {

/// Lines of /proc/stat for one processor each: all of the machine, whichever this program may use.
int processors_of_machine() {
  std::ifstream stat("/proc/stat");
  int count = 0;
  for (std::string line; std::getline(stat, line);) {
    count += line.starts_with("cpu") && line.size() > 3 && line[3] != ' ' ? 1 : 0;
  }
  return std::max(1, count);
}

/// Seconds that all processors were busy since the machine started. \source proc(5), /proc/stat.
std::optional<double> busy_seconds() {
  std::ifstream stat("/proc/stat");
  std::string name;
  std::array<double, 8> ticks{};  // user nice system idle iowait irq softirq steal
  stat >> name;
  for (double& tick : ticks) {
    stat >> tick;
  }
  if (!stat || name != "cpu") {
    return std::nullopt;
  }
  const double busy = ticks[0] + ticks[1] + ticks[2] + ticks[5] + ticks[6] + ticks[7];
  return busy / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Processor time of this process, with all its threads.
double own_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

MachineUse::MachineUse()
    : begin_(std::chrono::steady_clock::now()), busy_(busy_seconds()), own_(own_seconds()) {
}

std::optional<double> MachineUse::share_of_others() const {
  constexpr double kLeastSeconds = 0.5;
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  const std::optional<double> busy = busy_seconds();
  if (!busy_ || !busy || seconds < kLeastSeconds) {
    return std::nullopt;
  }
  const double others = *busy - *busy_ - (own_seconds() - own_);
  return std::clamp(others / (seconds * processors_of_machine()), 0.0, 1.0);
}

}  // namespace soms::command
