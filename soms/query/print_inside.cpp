#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/query/contains_parts.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/print.h"
#include "soms/query/winding.h"

#include <string>

namespace soms {

std::ostream& operator<<(std::ostream& out, const WindingIndex& value) {
  return out << PrintedFields("WindingIndex")
                    .item(printed(value.body()))
                    .item(printed_count(value.boundary_edges(), "boundary edge", "boundary edges"));
}

std::ostream& operator<<(std::ostream& out, const DividedPart& value) {
  PrintedFields fields("DividedPart");
  if (value.named != Part::kNoParent) {
    fields.add("named", value.named);
  }
  for (const std::uint32_t part : value.joined) {
    part == Part::kNoParent ? fields.item("no part") : fields.add("joined", part);
  }
  return out << fields.add("first", value.first)
                    .add("triangles", value.triangles)
                    .add("closed", value.closed)
                    .add("odd_edges", value.odd_edges);
}

std::ostream& operator<<(std::ostream& out, const DividedBody& value) {
  return out << PrintedFields("DividedBody")
                    .item(printed(value.body()))
                    .item(printed_count(value.parts().size(), "part", "parts"))
                    .item(std::to_string(value.open_parts()) + " open");
}

std::ostream& operator<<(std::ostream& out, const ContainsPartsBatch& value) {
  return out << PrintedFields("ContainsPartsBatch")
                    .item(printed_count(value.size(), "point", "points"))
                    .add("coverage", detail::coverage_of(value.coverage))
                    .add("cost", value.cost);
}

}  // namespace soms
