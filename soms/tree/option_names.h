/// \file
/// Names of the build options' values, as in files and on the command line.
#pragma once

#include "soms/tree/build_options.h"

#include <string_view>

namespace soms {

/// The value with this name, in snake_case or kebab-case.
/// \errors  ErrorKind::usage, which lists the names.
[[nodiscard]] Midpoint midpoint_named(std::string_view name);
[[nodiscard]] AxisFrom axis_from_named(std::string_view name);
[[nodiscard]] EmptySide empty_side_named(std::string_view name);

}  // namespace soms
