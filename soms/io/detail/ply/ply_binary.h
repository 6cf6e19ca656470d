/// \file
/// Bodies of binary PLY files.
#pragma once

#include "soms/io/detail/ply/ply.h"

#include <memory>

namespace soms::detail {

/// \pre The format is not ascii.
[[nodiscard]] std::unique_ptr<PlyBody> make_ply_binary(Source& source, MeshBuilder& builder,
                                                       const PlyHeader& header);

}  // namespace soms::detail
