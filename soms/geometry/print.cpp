#include "soms/geometry/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/geometry/bodies_of.h"
#include "soms/geometry/closedness.h"
#include "soms/geometry/common_points.h"
#include "soms/geometry/defects.h"
#include "soms/geometry/frames.h"
#include "soms/geometry/georeference.h"
#include "soms/geometry/mesh.h"
#include "soms/geometry/midpoint.h"
#include "soms/geometry/orientation.h"
#include "soms/geometry/part_runs.h"
#include "soms/geometry/point_distance.h"
#include "soms/geometry/triangle_distance.h"

namespace soms {

std::ostream& operator<<(std::ostream& out, const Mesh& value) {
  return out << MeshView(value);
}

std::ostream& operator<<(std::ostream& out, const MeshView& value) {
  return out << PrintedFields("Mesh")
                    .item(printed_count(value.triangles.size(), "triangle", "triangles"))
                    .item(printed_count(value.vertices.size(), "vertex", "vertices"))
                    .item(printed_count(value.parts.size(), "part", "parts"));
}

std::ostream& operator<<(std::ostream& out, const Attribute& value) {
  return out
         << PrintedFields("Attribute").item(quoted_text(value.name)).item(quoted_text(value.value));
}

std::ostream& operator<<(std::ostream& out, const Part& value) {
  PrintedFields fields("Part");
  fields.item(quoted_text(value.name));
  fields.item(printed_count(value.count, "triangle", "triangles") + " from " +
              std::to_string(value.first));
  if (value.parent != Part::kNoParent) {
    fields.add("parent", value.parent);
  }
  if (!value.id.empty()) {
    fields.add("id", quoted_text(value.id));
  }
  if (!value.type.empty()) {
    fields.add("type", quoted_text(value.type));
  }
  if (!value.attributes.empty()) {
    fields.item(printed_count(value.attributes.size(), "attribute", "attributes"));
  }
  if (value.continues != Part::kNoParent) {
    fields.add("continues", value.continues);
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const PartGroup& value) {
  PrintedFields fields("PartGroup");
  for (const std::uint32_t part : value.parts) {
    if (part == Part::kNoParent) {
      fields.item("no part");
    } else {
      fields.add("part", part);
    }
  }
  return out << fields.add("closed", value.closed);
}

std::ostream& operator<<(std::ostream& out, const PartRun& value) {
  PrintedFields fields("PartRun");
  fields.add("first", value.first);
  return value.part == Part::kNoParent ? out << fields.item("no part")
                                       : out << fields.add("part", value.part);
}

std::ostream& operator<<(std::ostream& out, const Defects& value) {
  return out << PrintedFields("Defects")
                    .add("degenerate", value.degenerate)
                    .add("repeated_corner", value.repeated_corner)
                    .add("duplicate", value.duplicate)
                    .add("doubled", value.doubled)
                    .add("open_edges", value.open_edges)
                    .add("non_manifold_edges", value.non_manifold_edges)
                    .add("flipped_edges", value.flipped_edges)
                    .add("unused_vertices", value.unused_vertices)
                    .add("repeated_vertices", value.repeated_vertices)
                    .add("closed", value.closed())
                    .add("by_index", value.by_index)
                    .item(printed_count(value.parts.size(), "part", "parts"))
                    .add("places", value.places);
}

std::ostream& operator<<(std::ostream& out, const DefectPlaces& value) {
  return out << PrintedFields("DefectPlaces")
                    .add("repeated_corner", value.repeated_corner.size())
                    .add("collinear", value.collinear.size())
                    .add("duplicate", value.duplicate.size())
                    .add("doubled", value.doubled.size())
                    .add("open_edges", value.open_edges.size())
                    .add("non_manifold_edges", value.non_manifold_edges.size())
                    .add("flipped_edges", value.flipped_edges.size())
                    .add("unused_vertices", value.unused_vertices.size())
                    .add("repeated_vertices", value.repeated_vertices.size());
}

std::ostream& operator<<(std::ostream& out, const DefectOptions& value) {
  return out
         << PrintedFields("DefectOptions").add("places", value.places).add("parts", value.parts);
}

std::ostream& operator<<(std::ostream& out, const EdgeCounts& value) {
  return out << PrintedFields("EdgeCounts")
                    .add("open", value.open)
                    .add("non_manifold", value.non_manifold)
                    .add("flipped", value.flipped)
                    .add("none", value.none);
}

std::ostream& operator<<(std::ostream& out, const EdgePlace& value) {
  return out << PrintedFields("EdgePlace")
                    .add("triangle", value.triangle)
                    .add("corner", value.corner)
                    .add("other", value.other)
                    .add("uses", value.uses);
}

std::ostream& operator<<(std::ostream& out, const TriangleCopy& value) {
  return out << PrintedFields("TriangleCopy")
                    .add("triangle", value.triangle)
                    .add("original", value.original);
}

std::ostream& operator<<(std::ostream& out, const VertexCopy& value) {
  return out
         << PrintedFields("VertexCopy").add("vertex", value.vertex).add("original", value.original);
}

std::ostream& operator<<(std::ostream& out, const TriangleDistance& value) {
  return out << PrintedFields("TriangleDistance")
                    .add("distance", value.distance)
                    .add("point_a", value.point_a)
                    .add("point_b", value.point_b);
}

std::ostream& operator<<(std::ostream& out, const Closedness& value) {
  return out << PrintedFields("Closedness")
                    .add("whole", value.whole)
                    .add("places", value.places.size())
                    .add("connected", value.connected.size())
                    .add("parts", value.parts.size());
}

std::ostream& operator<<(std::ostream& out, const ClosednessOptions& value) {
  return out << PrintedFields("ClosednessOptions")
                    .add("pose", value.pose)
                    .add("places", value.places)
                    .add("connected", value.connected)
                    .add("parts", value.parts);
}

std::ostream& operator<<(std::ostream& out, const PartClosedness& value) {
  return out << PrintedFields("PartClosedness")
                    .add("closed", value.closed)
                    .add("first", value.first)
                    .add("triangles", value.triangles)
                    .add("degenerate", value.degenerate)
                    .add("odd_edges", value.odd_edges)
                    .add("odd_proper_edges", value.odd_proper_edges);
}

std::ostream& operator<<(std::ostream& out, const PointDistance& value) {
  return out << PrintedFields("PointDistance")
                    .add("distance", value.distance)
                    .add("point", value.point)
                    .add("feature", value.feature);
}

std::ostream& operator<<(std::ostream& out, const CommonPoints& value) {
  PrintedFields corners("CommonPoints");
  for (const Vec3& corner : value.points()) {
    corners.item(printed(corner));
  }
  return out << (value.empty() ? corners.item("empty") : corners);
}

std::ostream& operator<<(std::ostream& out, Sign value) {
  return out << (value == Sign::negative ? "negative" : value == Sign::zero ? "zero" : "positive");
}

std::ostream& operator<<(std::ostream& out, const CoordinateFrame& value) {
  return out << PrintedFields("CoordinateFrame")
                    .add("unit", value.unit)
                    .add("up", value.up)
                    .add("unit_is_stated", value.unit_is_stated)
                    .add("up_is_stated", value.up_is_stated)
                    .add("scale", value.scale)
                    .add("georeference", value.georeference)
                    .add("georeference_is_stated", value.georeference_is_stated);
}

std::ostream& operator<<(std::ostream& out, const Georeference& value) {
  PrintedFields fields("Georeference");
  if (!value.crs.empty()) {
    fields.add("crs", quoted_text(value.crs));
  }
  if (!value.vertical_datum.empty()) {
    fields.add("vertical_datum", quoted_text(value.vertical_datum));
  }
  if (value.map_conversion) {
    fields.add("map_conversion", *value.map_conversion);
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const MapConversion& value) {
  return out << PrintedFields("MapConversion")
                    .add("eastings", value.eastings)
                    .add("northings", value.northings)
                    .add("height", value.height)
                    .add("abscissa", value.abscissa)
                    .add("ordinate", value.ordinate)
                    .add("scale", value.scale)
                    .add("factors", value.factors)
                    .add("unit", value.unit);
}

std::ostream& operator<<(std::ostream& out, FrameDoubt value) {
  return out << name(value);
}

}  // namespace soms
