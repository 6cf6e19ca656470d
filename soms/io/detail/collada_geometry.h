/// \file
/// One geometry of a COLLADA document.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/collada_document.h"

#include <cstdint>

namespace soms::detail {

struct ColladaGeometry {
  Mesh mesh;                 ///< vertices as stored; no parts
  std::uint32_t faces = 0;   ///< faces of the file, those without triangles too
  std::uint64_t lines = 0;   ///< lines and strips of lines, which are not read
  std::uint64_t curved = 0;  ///< splines, curved surfaces and hulls, which are not read
};

/// Reads an element <geometry>: triangles, polylists, polygons, strips and fans.
/// \pre `document.source().allow_empty`.
/// \errors ErrorKind::bad_file, not_finite, out_of_range, unsupported (a polygon with holes),
///         out_of_memory, cancelled.
[[nodiscard]] ColladaGeometry read_geometry(ColladaDocument& document, pugi::xml_node geometry);

}  // namespace soms::detail
