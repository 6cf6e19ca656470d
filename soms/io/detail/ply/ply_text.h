/// \file
/// Bodies of ascii PLY files.
#pragma once

#include "soms/io/detail/ply/ply.h"

#include <memory>

namespace soms::detail {

[[nodiscard]] std::unique_ptr<PlyBody> make_ply_text(Source& source, MeshBuilder& builder,
                                                     const PlyHeader& header);

}  // namespace soms::detail
