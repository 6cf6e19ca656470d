/// \file
/// A program that reads a model for us, as a child process with limits.
#pragma once

#include "soms/io/detail/source.h"

#include <string>
#include <string_view>

namespace soms::detail {

/// Lets the program of `find_import_program` read the source's bytes; returns what it writes. It
/// gets no shell, no file but the model, no more memory than the source has left and a fixed room
/// for the program itself, and `Source::import_seconds`. Nothing of it is left when this returns or
/// throws, but what it started itself where the host ignores SIGCHLD: then it is unknown whose that
/// is. \errors ErrorKind::unsupported (not found), bad_file, timed_out, out_of_memory, cancelled.
[[nodiscard]] std::string run_import(Source& source, std::string_view extension);

/// Text of the child made fit for a message: at most 200 characters, unprintable ones as '?'.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace soms::detail
