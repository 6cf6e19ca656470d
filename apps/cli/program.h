/// \file
/// From the words of a command line to an exit status.
#pragma once

#include "apps/cli/verb.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// A program of soms.
struct Program {
  std::string_view name;        ///< as in its messages and usage lines
  std::string_view summary;     ///< the first line of --help
  std::span<const Verb> verbs;  ///< sorted by name
};

/// What the help of a program says of its verbs.
[[nodiscard]] std::string about_verbs(const Program& program);

/// And of answers and the exit status.
inline constexpr const char* kAboutAnswers =
    "Answers go to standard output, everything else to standard error. Exit status:\n"
    "  0 answered  1 a condition of --fail-if holds  2 usage  3 bad input\n"
    "  4 not enough memory or time  5 could not write  6 --verify found a difference\n"
    "  130 interrupted\n";

/// The text of --help.
[[nodiscard]] std::string help_of(const Program& program);

/// Runs one command line (`words`, without the program's name) and returns its exit status: 0
/// answered, 1 a condition of --fail-if holds, 2 usage, 3 bad input, 4 not enough memory or time, 5
/// could not write, 6 --verify found a difference, 130 interrupted.
[[nodiscard]] int run_program(const Program& program, const std::vector<std::string>& words);

}  // namespace soms::command
