/// \file
/// The program soms-import as a child process with limits.
#pragma once

#include "soms/io/detail/source.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// Lets soms-import read the source's bytes; returns what it writes. It is found by the variable
/// SOMS_IMPORT, else beside this program or in libexec/soms beside it or the library. It gets no
/// shell, no file but the model, no more memory than the source has left and a fixed room for the
/// program itself, and `Source::import_seconds`. Nothing of it is left when this returns or throws,
/// but what it started itself where the host ignores SIGCHLD: then it is unknown whose that is.
/// \errors ErrorKind::unsupported (not found), bad_file, timed_out, out_of_memory, cancelled.
[[nodiscard]] std::string run_import(Source& source, std::string_view extension);

/// Folders where soms-import may lie, the nearest first, for a program and a library at these
/// places. None is far from them: what somebody else put into a folder above them must not be
/// started. A place that is not known, or not from the root on, gives none: nor must what lies in
/// the folder that is current.
[[nodiscard]] std::vector<std::filesystem::path> import_folders(
    const std::filesystem::path& program, const std::filesystem::path& library);

/// Text of the child made fit for a message: at most 200 characters, unprintable ones as '?'.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace soms::detail
