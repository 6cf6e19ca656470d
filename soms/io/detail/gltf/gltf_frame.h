/// \file
/// What the numbers of a glTF document mean, and what soms adds where they mean something else.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/json_document.h"

#include <string>

namespace soms::detail {

/// Gives a mesh its unit, up axis and georeference: glTF means meters, y up, and no place on the
/// Earth. A file that soms wrote of another mesh says so in `asset.extras.soms`, or that they are
/// not known: a unit of 0, and `unknown`.
/// \errors ErrorKind::bad_file.
void read_gltf_frame(const JsonValue& root, Mesh& mesh);

/// The member `extras` of `asset` that `read_gltf_frame` reads back, behind a comma; empty where
/// glTF means what the mesh means. Numbers stay as they are.
[[nodiscard]] std::string gltf_frame_extras(const MeshView& mesh);

}  // namespace soms::detail
