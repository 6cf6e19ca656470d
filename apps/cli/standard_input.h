/// \file
/// Standard input in the place of a file.
#pragma once

#include "soms/base/error.h"

#include <string>
#include <string_view>

namespace soms::command {

/// Where readers of files find standard input, which arguments call "-".
inline constexpr std::string_view kStandardInput = "/dev/stdin";

/// What messages call it.
inline constexpr std::string_view kStandardInputName = "standard input";

/// A terminal, into which nobody types a file, and the device that is always empty are no faults of
/// a file: whoever wrote "-" has named none.
/// \param what What to pipe: "a model".
/// \errors ErrorKind::cannot_open for a terminal, ErrorKind::bad_file for /dev/null.
void check_standard_input(std::string_view what);

/// The same error with standard input by its name.
[[nodiscard]] Error of_standard_input(const Error& error);

}  // namespace soms::command
