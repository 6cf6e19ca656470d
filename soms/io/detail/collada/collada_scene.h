/// \file
/// What a scene of a COLLADA document shows.
#pragma once

#include "soms/io/detail/collada/collada_document.h"
#include "soms/io/detail/mesh_builder.h"

namespace soms::detail {

/// Puts every triangle that a <visual_scene> shows into `builder`, with its parts and notes. A null
/// `scene` shows every geometry once. \pre `document.source().allow_empty`: a geometry may be empty
/// where the scene is not. \errors ErrorKind::bad_file, not_finite, out_of_range, unsupported,
/// out_of_memory, cancelled.
void show_scene(ColladaDocument& document, pugi::xml_node scene, MeshBuilder& builder);

}  // namespace soms::detail
