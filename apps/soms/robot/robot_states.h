/// \file
/// States of the verb `robot`: of a file, or random ones.
#pragma once

#include "soms/base/box.h"
#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/io/robot_states.h"

#include "apps/soms/robot/robot.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soms::command {

class Console;

/// The values of movable joints that --home gives to those that no column names; nothing where it
/// is not given. \errors ErrorKind::usage for a state that the SRDF file does not have.
[[nodiscard]] std::optional<std::vector<double>> home_values(const RobotModels& models,
                                                             const std::string& home);

/// States row by row, each checked: an error names its row.
class RobotStates {
 public:
  /// \errors As `RobotStateReader` and `home_values`; ErrorKind::timed_out.
  RobotStates(const RobotVerbOptions& options, const RobotModels& models, const Console& console);

  /// The next state, valid until the next call; nothing at the end.
  /// \errors As `RobotStateReader::next`; ErrorKind::out_of_range for a state that takes the robot
  ///         beyond 2^300; bad_file for a file without rows, and with --strict for a joint outside
  ///         of its limits; timed_out.
  [[nodiscard]] std::optional<std::span<const double>> next();

  /// True if `next` will not wait.
  [[nodiscard]] bool ready() { return !reader_ || reader_->ready(); }

  /// The box of the robot in the state that `next` gave last; it may be somewhat too large.
  [[nodiscard]] const Box& box() const { return box_; }

 private:
  void open(const std::string& path, std::optional<std::vector<double>> home);
  [[nodiscard]] std::optional<std::span<const double>> read();
  void check_state(std::span<const double> state);
  [[noreturn]] void fail(const Error& error) const;

  const RobotModels& models_;
  const Console& console_;
  std::string name_;
  std::optional<RobotStateReader> reader_;  ///< none: random states
  Rng rng_;
  std::uint64_t left_ = 0;  ///< random states
  std::vector<double> state_;
  std::uint64_t rows_ = 0;
  bool strict_ = false;
  Box box_;
};

}  // namespace soms::command
