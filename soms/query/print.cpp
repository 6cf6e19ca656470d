#include "soms/query/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/query/overlap.h"
#include "soms/query/overlap_run.h"
#include "soms/tree/print.h"

#include <algorithm>

namespace soms {

namespace {

std::string pairs_in_words(const std::vector<TrianglePair>& pairs) {
  return printed_count(pairs.size(), "pair", "pairs");
}

/// Poses with an answer of at least one pair, of all.
template <class Answers, class Hit>
std::string hits_in_words(const Answers& answers, const Hit& hit) {
  const auto hits = std::count_if(answers.begin(), answers.end(), hit);
  return std::to_string(hits) + " of " + printed_count(answers.size(), "pose", "poses") +
         " with an overlap";
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Body& value) {
  return out << PrintedFields("Body")
                    .item(quoted_text(value.name))
                    .item(printed(value.shape))
                    .item(printed(value.pose));
}

std::ostream& operator<<(std::ostream& out, const Cost& value) {
  return out << PrintedFields("Cost")
                    .add("node_tests", value.node_tests)
                    .add("triangle_tests", value.triangle_tests)
                    .add("exact_tests", value.exact_tests);
}

std::ostream& operator<<(std::ostream& out, Coverage value) {
  return out << printed_name("Coverage", static_cast<int>(value), {"complete", "first", "cut"});
}

std::ostream& operator<<(std::ostream& out, const Overlap& value) {
  PrintedFields fields("Overlap");
  fields.add("any", value.any)
      .item(pairs_in_words(value.pairs))
      .add("coverage", value.coverage)
      .add("cost", value.cost);
  if (value.traversal != TraversalCounts{}) {
    fields.add("traversal", value.traversal);
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const OverlapBatch& value) {
  return out << PrintedFields("OverlapBatch")
                    .item(hits_in_words(value.any, [](std::uint8_t any) { return any != 0; }))
                    .item(pairs_in_words(value.pairs))
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const RunAnswers& value) {
  return out << PrintedFields("RunAnswers")
                    .item(hits_in_words(value.poses,
                                        [](const RunAnswers::Answer& a) { return a.any; }))
                    .item(pairs_in_words(value.pairs));
}

std::ostream& operator<<(std::ostream& out, const OverlapOptions& value) {
  PrintedFields fields("OverlapOptions");
  fields.add("mode", value.mode);
  if (value.limit != std::numeric_limits<std::uint64_t>::max()) {
    fields.add("limit", value.limit);
  }
  if (value.deadline) {
    fields.item("deadline set");
  }
  return out << fields.add("traversal", value.traversal);
}

std::ostream& operator<<(std::ostream& out, OverlapMode value) {
  return out << printed_name("OverlapMode", static_cast<int>(value), {"all", "any", "first"});
}

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

std::ostream& operator<<(std::ostream& out, Traversal value) {
  return out << printed_name("Traversal", static_cast<int>(value),
                             {"fast", "a_first", "b_first", "alternate", "larger", "simultaneous",
                              "ericson", "larsson", "e_node", "e_node_front"});
}

std::ostream& operator<<(std::ostream& out, Descent value) {
  return out << printed_name("Descent", static_cast<int>(value),
                             {"both", "larger", "cross", "fewest"});
}

std::ostream& operator<<(std::ostream& out, EntryOrder value) {
  return out << printed_name("EntryOrder", static_cast<int>(value), {"tree", "volume"});
}

std::ostream& operator<<(std::ostream& out, BoxUpdate value) {
  return out << printed_name("BoxUpdate", static_cast<int>(value), {"refit", "rebox"});
}

}  // namespace soms
