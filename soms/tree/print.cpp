#include "soms/tree/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/geometry/print.h"
#include "soms/tree/file/shape_bytes.h"
#include "soms/tree/shape.h"
#include "soms/tree/statistics.h"
#include "soms/tree/tree.h"
#include "soms/tree/visits.h"

namespace soms {

std::ostream& operator<<(std::ostream& out, const Tree& value) {
  return out << PrintedFields("Tree")
                    .item(printed_count(value.nodes.size(), "node", "nodes"))
                    .item(printed_count(value.primitives.size(), "triangle", "triangles"));
}

std::ostream& operator<<(std::ostream& out, const Node& value) {
  PrintedFields fields("Node");
  if (value.id != kNoTreeId) {
    fields.add("id", value.id);
  }
  fields.add("depth", value.depth).add("first", value.first).add("count", value.count);
  if (value.is_leaf()) {
    fields.item("leaf");
  } else {
    fields.add("left", value.left).add("right", value.right);
  }
  return out << fields.add("undividable", value.undividable).add("bounds", value.bounds);
}

std::ostream& operator<<(std::ostream& out, const TreeStatistics& value) {
  return out << PrintedFields("TreeStatistics")
                    .add("nodes", value.nodes)
                    .add("leaves", value.leaves)
                    .add("one", value.one)
                    .add("lt5", value.lt5)
                    .add("undividable", value.undividable)
                    .add("capped", value.capped)
                    .add("empty", value.empty)
                    .add("depth", value.depth)
                    .add("min_leaf_depth", value.min_leaf_depth)
                    .add("max_leaf_depth", value.max_leaf_depth)
                    .add("largest_leaf", value.largest_leaf)
                    .add("balanced_level", value.balanced_level);
}

std::ostream& operator<<(std::ostream& out, const Visits& value) {
  return out << PrintedFields("Visits")
                    .add("nodes", value.nodes)
                    .add("leaves", value.leaves)
                    .add("triangles", value.triangles);
}

std::ostream& operator<<(std::ostream& out, const ExpectedVisits& value) {
  return out << PrintedFields("ExpectedVisits")
                    .add("nodes", value.nodes)
                    .add("leaves", value.leaves)
                    .add("triangles", value.triangles);
}

std::ostream& operator<<(std::ostream& out, const BuildOptions& value) {
  PrintedFields fields("BuildOptions");
  fields.add("rule", value.rule).add("midpoint", value.midpoint).add("c_vertex", value.c_vertex);
  if (value.axis_from) {
    fields.add("axis_from", *value.axis_from);
  }
  return out << fields.add("empty_side", value.empty_side)
                    .add("level", value.level)
                    .add("root_level", value.root_level)
                    .add("per_leaf", value.per_leaf);
}

std::ostream& operator<<(std::ostream& out, const Shape& value) {
  PrintedFields fields("Shape");
  fields.item(printed(value.mesh()));
  fields.add("layout", value.layout_kind());
  fields.add("keep_tree", value.tree() != nullptr);
  return out << fields.add("sah_degradation", value.sah_degradation());
}

std::ostream& operator<<(std::ostream& out, const ShapeOptions& value) {
  return out << PrintedFields("ShapeOptions")
                    .add("build", value.build)
                    .add("keep_tree", value.keep_tree)
                    .add("layout", value.layout);
}

std::ostream& operator<<(std::ostream& out, const OpenOptions& value) {
  return out << PrintedFields("OpenOptions").add("check", value.check).add("load", value.load);
}

std::ostream& operator<<(std::ostream& out, const TreeFileName& value) {
  return out << PrintedFields("TreeFileName").item(quoted_text(value.path)).add("hash", value.hash);
}

}  // namespace soms
