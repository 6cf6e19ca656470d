/// \file
/// What the command line says of a model, in words.
#pragma once

#include "soms/geometry/mesh.h"

#include <string>

namespace soms::command {

struct ModelOptions;

/// 'x', 'y' or 'z'. \pre `axis` is known.
[[nodiscard]] char axis_letter(UpAxis axis);

/// "--crs-b" beside "--up-b"; nothing beside "--mover-up", as movers are placed.
[[nodiscard]] std::string crs_option(const std::string& up_name);

/// What a model was scaled and turned by, or was said to be: ", --scale 0.001, --up y"; empty if
/// nothing was stated.
[[nodiscard]] std::string stated_options(const ModelOptions& options, const std::string& scale_name,
                                         const std::string& up_name);

}  // namespace soms::command
