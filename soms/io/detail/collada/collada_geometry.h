/// \file
/// One geometry of a COLLADA document.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/collada/collada_left_out.h"

#include <cstdint>

namespace soms::detail {

struct ColladaGeometry {
  Mesh mesh;                ///< vertices as stored; no parts
  std::uint32_t faces = 0;  ///< faces of the file, those without triangles too
  ColladaLeftOut lines;     ///< lines and strips of lines
  ColladaLeftOut curved;    ///< splines, curved surfaces and hulls
  ColladaLeftOut unknown;   ///< elements that COLLADA does not have there
  ColladaLeftOut surplus;   ///< numbers of positions that no vertex has
};

/// Reads an element <geometry>: triangles, polylists, polygons, strips and fans.
/// \pre `document.source().allow_empty`.
/// \errors ErrorKind::bad_file, not_finite, out_of_range, unsupported (a polygon with holes),
///         out_of_memory, cancelled.
[[nodiscard]] ColladaGeometry read_geometry(ColladaDocument& document, pugi::xml_node geometry);

}  // namespace soms::detail
