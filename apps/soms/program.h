/// \file
/// From the words of a command line to an exit status.
#pragma once

#include <string>
#include <vector>

namespace soms::command {

/// Runs one command line (without the program's name) and returns its exit status: 0 answered,
/// 1 a condition of --fail-if holds, 2 usage, 3 bad input, 4 not enough memory or time, 5 could not
/// write, 6 --verify found a difference, 130 interrupted.
[[nodiscard]] int run_program(const std::vector<std::string>& words);

}  // namespace soms::command
