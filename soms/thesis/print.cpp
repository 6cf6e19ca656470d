#include "soms/thesis/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/query/print.h"
#include "soms/thesis/overlap.h"
#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/traversal_options.h"

namespace soms {

std::ostream& operator<<(std::ostream& out, const TraversalCounts& value) {
  return out << PrintedFields("TraversalCounts")
                    .add("box_tests", value.box_tests)
                    .add("entered", value.entered)
                    .add("leaf_pairs", value.leaf_pairs)
                    .add("triangle_pairs", value.triangle_pairs)
                    .add("first_tests", value.first_tests)
                    .add("max_stack", value.max_stack);
}

std::ostream& operator<<(std::ostream& out, const NodePair& value) {
  return out << PrintedFields("NodePair").add("a", value.a).add("b", value.b);
}

std::ostream& operator<<(std::ostream& out, const TraversalOptions& value) {
  return out << PrintedFields("TraversalOptions")
                    .add("traversal", value.traversal)
                    .add("descent", value.descent)
                    .add("order", value.order)
                    .add("ericson_rule", value.ericson_rule)
                    .add("recursive", value.recursive)
                    .add("prune", value.prune)
                    .add("update", value.update);
}

std::ostream& thesis::operator<<(std::ostream& out, const CountedOverlap& value) {
  return out
         << PrintedFields("CountedOverlap").add("answer", value.answer).add("counts", value.counts);
}

}  // namespace soms
