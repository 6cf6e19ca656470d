/// \file
/// What the process gives up before it reads a model that nobody vouches for.
#pragma once

#include <string>

namespace soms::import_program {

/// Takes away from this process, for good, every system call that reading a model from memory does
/// not need. What is left: private memory that cannot be executed, writing to standard output and
/// standard error, clocks, locks, random numbers, signals to itself, and the end. All else fails
/// with EPERM: no file is opened, created or removed, no program or process started, no other
/// process reached, no network. A system call of another architecture (32-bit x86, x32) kills.
/// Call it while there is one thread and all files are open.
/// Returns the empty string if that holds from here on; otherwise the
/// reason, worded for the middle of a sentence, and nothing is taken away.
/// \threads Of the calling thread and those that it starts.
[[nodiscard]] std::string enter_sandbox();

}  // namespace soms::import_program
