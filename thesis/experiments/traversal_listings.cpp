// Figures 4.31, 4.34, 4.36 and 4.37: traversals in pseudo code, each beside a run.
#include "soms/thesis/implicit.h"
#include "soms/thesis/traversals.h"

#include "thesis/experiments/experiments.h"
#include "thesis/page/listing.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trips/frames.h"
#include "thesis/trips/traversal_course.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr int kToyLevel = 4;

/// "the two bodies of figure 5.9", which all small runs use.
constexpr std::string_view kToyHeading = "the bodies of figure 5.9; pairs: TreeIDs, still|moving";

/// The listing of figure 4.36 as it runs, with a row for each pair that leaves the stack.
class DepthFirst {
 public:
  explicit DepthFirst(const ToyPair& toy) : toy_(toy) {}

  std::vector<std::vector<Cell>> run() {
    stack_ = {NodePair{}};
    while (!stack_.empty()) {
      const NodePair p = stack_.back();
      stack_.pop_back();
      order.push_back(p);
      const std::string done = visit(p);
      rows_.push_back({count_cell(rows_.size() + 1), pair_words(toy_, p), done, stack_words()});
    }
    return rows_;
  }

  std::vector<NodePair> order = {};  ///< in which pairs were tested

 private:
  std::string visit(NodePair p) {
    if (!overlaps(toy_.boxes_a.boxes()[p.a], toy_.boxes_b.boxes()[p.b])) {
      return "apart";
    }
    const Node& a = toy_.tree_a.nodes[p.a];
    const Node& b = toy_.tree_b.nodes[p.b];
    if (a.is_leaf() && b.is_leaf()) {
      return "leaves: report";
    }
    std::vector<NodePair> children;
    for (const std::uint32_t i : parts_of(a, p.a)) {
      for (const std::uint32_t j : parts_of(b, p.b)) {
        children.push_back({i, j});
      }
    }
    stack_.insert(stack_.end(), children.rbegin(), children.rend());
    return fmt::format("overlap: push {}", children.size());
  }

  /// Children of a node; a leaf stands for itself.
  static std::vector<std::uint32_t> parts_of(const Node& node, std::uint32_t index) {
    return node.is_leaf() ? std::vector{index} : std::vector{node.left, node.right};
  }

  [[nodiscard]] std::string stack_words() const {
    std::string words;
    for (std::size_t k = stack_.size(); k > 0; --k) {
      words += fmt::format("{}{}", words.empty() ? "" : " ", pair_words(toy_, stack_[k - 1]));
    }
    return words.empty() ? "empty" : words;
  }

  const ToyPair& toy_;
  std::vector<NodePair> stack_;
  std::vector<std::vector<Cell>> rows_;
};

/// The descents that Ericson's generic traversal may have.
constexpr std::array<std::pair<Traversal, const char*>, 5> kDescents{
    {{Traversal::a_first, "still tree first"},
     {Traversal::b_first, "moving tree first"},
     {Traversal::alternate, "both in turn"},
     {Traversal::larger, "larger volume"},
     {Traversal::simultaneous, "both at once"}}};

}  // namespace

Result figure_4_31(const Context&) {
  const ToyPair toy;
  const Course course = record(toy, "ericson", {.traversal = Traversal::simultaneous});
  Table table{.id = "figure_4_31_steps",
              .caption = "The simultaneous traversal of two small trees, test by test.",
              .columns = {{"test"}, {"pair"}, {"outcome"}}};
  for (const Event& event : course.events) {
    if (event.what == "test") {
      table.rows.push_back(
          {count_cell(table.rows.size() + 1), pair_words(toy, event.pair), event.outcome});
    } else if (event.what == "report") {
      table.rows.back().back() = word_cell("overlap: two leaves, test their triangles");
    }
  }
  return listing_result("figure_4_31",
                        "How two trees are tested for collision, with a real run beside it.",
                        {.title = "Collision of two trees",
                         .lines = {{0, "collide (A, B):"},
                                   {1, "if the boxes of A and B are apart:"},
                                   {2, "no collision below; done"},
                                   {1, "if A and B are leaves:"},
                                   {2, "test their triangles; done"},
                                   {1, "for A or each child of A, if it has any:"},
                                   {2, "for B or each child of B, if it has any:"},
                                   {3, "collide (that, this)"}},
                         .heading = std::string(kToyHeading)},
                        std::move(table));
}

Result figure_4_34(const Context&) {
  const ToyPair toy;
  const ImplicitTree arrays = to_implicit(toy.tree_a, kToyLevel);
  Table table{.id = "figure_4_34_nodes",
              .caption = fmt::format("Every place of the still tree of figure 5.9 in arrays of "
                                     "level {}: is there a node, and is it internal.",
                                     kToyLevel),
              .columns = {{"tree_id"}, {"node"}, {"left_child"}, {"internal"}}};
  std::size_t nodes = 0;
  for (TreeId id = 0; id < arrays.slots.size(); ++id) {
    const TreeId left = left_child_of(id);
    const bool exists = arrays.find(id) != nullptr;
    const bool internal = exists && arrays.find(left) != nullptr;
    nodes += exists ? 1U : 0U;
    require(exists == (find_node(toy.tree_a, id) != nullptr) &&
                internal == (exists && !find_node(toy.tree_a, id)->is_leaf()),
            "internal nodes in the arrays and in the tree");
    table.rows.push_back({count_cell(id), yes_cell(exists), count_cell(left), yes_cell(internal)});
  }
  require(nodes == toy.tree_a.nodes.size(), "nodes in the arrays and in the tree");
  return listing_result(
      "figure_4_34", "Whether a node is internal, with a real tree beside it.",
      {.title = "Is a node internal?",
       .lines = {{0, "is internal (TreeID):"},
                 {1, "left = 2 TreeID + 1"},
                 {1, "if left is past the end of the arrays:"},
                 {2, "no"},
                 {1, "yes, if there is a node left; else no"}},
       .heading = fmt::format("the still body of figure 5.9, level {}", kToyLevel)},
      std::move(table));
}

Result figure_4_36(const Context&) {
  const ToyPair toy;
  DepthFirst traversal(toy);
  Table table{.id = "figure_4_36_steps",
              .caption = "The simultaneous traversal of two small trees by a stack, pair by pair.",
              .columns = {{"step"}, {"pair"}, {"outcome"}, {"stack"}}};
  table.rows = traversal.run();
  std::vector<NodePair> tested;
  for (const Event& event :
       record(toy, "simultaneous", {.traversal = Traversal::simultaneous}).events) {
    if (event.what == "test") {
      tested.push_back(event.pair);
    }
  }
  require(tested == traversal.order, "the listing and the traversal, pair by pair");
  return listing_result("figure_4_36",
                        "Depth-first traversal with a stack, with a real run beside it.",
                        {.title = "Depth-first traversal",
                         .lines = {{0, "depth first (root A, root B):"},
                                   {1, "push the roots"},
                                   {1, "while the stack is not empty:"},
                                   {2, "pop a pair"},
                                   {2, "if its boxes are apart: next"},
                                   {2, "if both are leaves:"},
                                   {3, "report it; next"},
                                   {2, "push the pairs of their children,"},
                                   {2, "the last first"}},
                         .heading = std::string(kToyHeading)},
                        std::move(table));
}

Result figure_4_37(const Context& context) {
  const Model& object = context.models.objects.front();
  const Trip trip = orientation_trip(object, Approach::right, thesis_rules(kObjectLevel).back());
  Table table{.id = "figure_4_37_descents",
              .caption = fmt::format("Test right, {}, SOMS trees of level {}: the generic "
                                     "traversal with each descent, summed over all frames "
                                     "(max_stack: the greatest).",
                                     object.name, kObjectLevel),
              .columns = {{"descent"}}};
  add_count_columns(table);
  std::uint64_t leaf_pairs = 0;
  for (const auto& [rule, words] : kDescents) {
    const NamedTraversal traversal{words, {.traversal = Traversal::ericson, .ericson_rule = rule}};
    const TraversalCounts counts = totals(traverse_frames(trip, traversal, context.limits)).counts;
    require(table.rows.empty() || counts.leaf_pairs == leaf_pairs,
            "leaf pairs by two descents of the generic traversal");
    leaf_pairs = counts.leaf_pairs;
    std::vector<Cell> row{word_cell(words)};
    add_count_cells(row, counts);
    table.rows.push_back(std::move(row));
  }
  Result result = listing_result(
      "figure_4_37",
      "Ericson's generic traversal in our words: one recursion, and a rule that says which node to "
      "descend. Below, what the rules cost in the orientation test right.",
      {.title = "Generic traversal",
       .lines = {{0, "generic (A, B):"},
                 {1, "if the boxes of A and B are apart: done"},
                 {1, "if A and B are leaves:"},
                 {2, "report the pair; done"},
                 {1, "if the rule descends A:"},
                 {2, "generic (left child of A, B)"},
                 {2, "generic (right child of A, B)"},
                 {1, "else if it descends B:"},
                 {2, "generic (A, left child of B)"},
                 {2, "generic (A, right child of B)"},
                 {1, "else:"},
                 {2, "generic (each child of A, each child of B)"}},
       .heading = fmt::format("test right, {}, SOMS, all frames", object.name)},
      std::move(table));
  result.remarks = {
      "Which rule the thesis uses was not available to us; its figures 5.6 to 5.8 are made here "
      "with the larger volume."};
  return result;
}

}  // namespace soms::reproduce
