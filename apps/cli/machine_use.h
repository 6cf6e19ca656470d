/// \file
/// How much of the machine other programs used while something was measured.
#pragma once

#include <chrono>
#include <optional>

namespace soms::command {

/// Measures from its construction on.
class MachineUse {
 public:
  MachineUse();

  /// The share of all processors that others used, 0 to 1; nothing before half a second, in which
  /// the system counts too coarsely, and where it does not say.
  [[nodiscard]] std::optional<double> share_of_others() const;

 private:
  std::chrono::steady_clock::time_point begin_;
  std::optional<double> busy_;  ///< seconds of all processors
  double own_;                  ///< seconds of this process
};

/// Above this share times are said to be too long.
inline constexpr double kBusyShare = 0.1;

}  // namespace soms::command
