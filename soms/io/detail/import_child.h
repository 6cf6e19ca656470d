/// \file
/// The program soms-import as a child process with limits.
#pragma once

#include "soms/io/detail/source.h"

#include <string>
#include <string_view>

namespace soms::detail {

/// Lets soms-import read the source's bytes; returns what it writes. It is found by the variable
/// SOMS_IMPORT, else beside this program or in libexec/soms beside it or the library. It gets no
/// shell, no file but the model, no more memory than the source has left and a fixed room for the
/// program itself, and `Source::import_seconds`. Nothing of it is left when this returns or throws.
/// \errors ErrorKind::unsupported (not found), bad_file, timed_out, out_of_memory, cancelled.
[[nodiscard]] std::string run_import(Source& source, std::string_view ending);

/// Text of the child made fit for a message: at most 200 characters, unprintable ones as '?'.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace soms::detail
