/// \file
/// A scene taken apart into the objects of its file.
#pragma once

#include "soms/geometry/mesh.h"

#include <vector>

namespace soms::reproduce {

/// The triangles of each part of a mesh as a mesh of its own, in their order; a triangle belongs to
/// the innermost part that holds it, those of no part come last together, and parts without
/// triangles are left out. Every triangle has corners of its own.
[[nodiscard]] std::vector<Mesh> object_meshes(const Mesh& mesh);

}  // namespace soms::reproduce
