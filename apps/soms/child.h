/// \file
/// Other programs of soms, run in the place of the command.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soms::command {

class Console;

/// Runs `program` with `words`, on the command's own standard input, output and error, and waits.
/// Returns its exit status, 128 + n where signal n ended it. Ctrl-C and --timeout end it.
/// \errors ErrorKind::unsupported where it cannot be started; ErrorKind::timed_out; cancelled.
[[nodiscard]] int run_child(const std::filesystem::path& program,
                            const std::vector<std::string>& words, const Console& console);

}  // namespace soms::command
