#include "soms/clash/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/clash/clash.h"
#include "soms/query/print.h"

namespace soms {

std::ostream& operator<<(std::ostream& out, const Penetration& value) {
  return out << PrintedFields("Penetration")
                    .add("depth", value.depth)
                    .add("direction", value.direction);
}

std::ostream& operator<<(std::ostream& out, const Clash& value) {
  PrintedFields fields("Clash");
  fields.add("a", value.a)
      .add("b", value.b)
      .add("kind", value.kind)
      .add("relation", value.relation)
      .add("why", value.why)
      .item(printed_count(value.triangle_pairs, "pair", "pairs") + " of triangles")
      .add("gap", value.gap)
      .add("place", value.place)
      .add("box", value.box);
  if (value.penetration) {
    fields.add("penetration", *value.penetration);
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const ClashList& value) {
  return out << PrintedFields("ClashList")
                    .item(printed_count(value.clashes.size(), "clash", "clashes"))
                    .add("compared", value.compared)
                    .add("left_out", value.left_out)
                    .add("coverage", value.coverage)
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const OpenUnion& value) {
  const std::size_t parts = value.body ? value.body->joined.size() + 1 : 0;
  return out << PrintedFields("OpenUnion").item(printed_count(parts, "part", "parts"));
}

std::ostream& operator<<(std::ostream& out, const PartBody& value) {
  PrintedFields fields("PartBody");
  if (value.part != Part::kNoParent) {
    fields.add("part", value.part);
  }
  for (const std::uint32_t part : value.joined) {
    part == Part::kNoParent ? fields.item("no part") : fields.add("joined", part);
  }
  if (value.together.body) {
    fields.add("together", value.together);
  }
  return out << fields.item(printed_count(value.triangles.size(), "triangle", "triangles"))
                    .add("closed", value.closed.has_value())
                    .add("odd_edges", value.odd_edges);
}

std::ostream& operator<<(std::ostream& out, const PartComponent& value) {
  return out << PrintedFields("PartComponent").add("corner", value.corner).add("box", value.box);
}

}  // namespace soms
