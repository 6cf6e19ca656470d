/// \file
/// Meshes of tiles as one mesh, with a part around each.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"

#include <string>
#include <vector>

namespace soms::detail {

/// What was read of one tile.
struct NamedMesh {
  std::string name;
  Mesh mesh;
};

/// The triangles of all meshes in their order, those of each in a part of its name, around its own
/// parts. One without triangles gives no part. Notes begin with the name.
/// \errors ErrorKind::out_of_range, out_of_memory, cancelled.
/// \pre No mesh has faces of more than three corners.
[[nodiscard]] Mesh join_tiles(Source& source, std::vector<NamedMesh> meshes);

/// Tiles number their objects each for itself. An id that several objects have is put behind the
/// names of the parts around the object ("ll.b3dm/7"), and behind a number where that is not
/// enough. \errors ErrorKind::out_of_memory.
void make_ids_unique(Source& source, Mesh& mesh);

}  // namespace soms::detail
