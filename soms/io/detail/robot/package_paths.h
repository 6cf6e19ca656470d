/// \file
/// Where the files are that a URDF file names.
#pragma once

#include "soms/io/robot.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace soms::detail {

/// The path that `uri` means, for a file in `folder` (none for bytes in memory). That it exists is
/// not checked.
/// \errors ErrorKind::cannot_open for a package that is not found; unsupported for another
/// protocol,
///         or a path from a folder where there is none.
[[nodiscard]] std::filesystem::path resolved_uri(std::string_view uri,
                                                 const std::optional<std::filesystem::path>& folder,
                                                 const RobotReadOptions& options);

}  // namespace soms::detail
