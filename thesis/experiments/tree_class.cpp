// Figures 4.14 to 4.16, 4.18 and 4.21: the tree as an array by TreeID, and what TreeIDs tell.
#include "soms/thesis/implicit.h"
#include "soms/tree/build.h"

#include "thesis/experiments/experiments.h"
#include "thesis/page/listing.h"
#include "thesis/pictures/tree_diagram.h"
#include "thesis/pictures/tree_pictures.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trees/toy_sets.h"
#include "thesis/trips/levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

/// Levels of the complete tree of eight triangles.
constexpr int kCompleteLevels = 4;

Tree tree_of(const Mesh& mesh, int level = kObjectLevel) {
  return build(mesh, thesis_options(Rule::soms, level));
}

std::string numbers_of(std::span<const TriangleId> triangles) {
  std::string words;
  for (const TriangleId id : triangles) {
    words += fmt::format("{}{}", words.empty() ? "" : " ", id);
  }
  return words;
}

std::string box_words(const Box& box) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g})", box.lower.x,
                     box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z);
}

/// Eight triangles that are alike but unevenly spread.
const ToySet& uneven_set() {
  static const ToySet set = flat_toy_sets().front();
  return set;
}

/// The fields of a slot. A field more or less does not compile.
Table field_table(const ImplicitTree& tree) {
  Table table{.id = "figure_4_14_fields",
              .caption =
                  "Fields of a node as it is stored, their bytes, and what they hold in the "
                  "root and in its right child.",
              .columns = {{"field"}, {"bytes"}, {"meaning"}, {"node_0"}, {"node_2"}}};
  const auto& [bounds, first, count, used, undividable] = tree.slots[0];
  const ImplicitTree::Slot& right = tree.slots[2];
  const auto add = [&](const char* name, std::size_t bytes, const char* meaning, std::string root,
                       std::string child) {
    table.rows.push_back({word_cell(name), count_cell(bytes), word_cell(meaning), std::move(root),
                          std::move(child)});
  };
  add("bounds", sizeof bounds, "least and greatest point", box_words(bounds),
      box_words(right.bounds));
  add("first", sizeof first, "place of its first triangle", std::to_string(first),
      std::to_string(right.first));
  add("count", sizeof count, "triangles below", std::to_string(count), std::to_string(right.count));
  add("used", sizeof used, "the node exists", used ? "yes" : "no", right.used ? "yes" : "no");
  add("undividable", sizeof undividable, "the rule failed", undividable ? "yes" : "no",
      right.undividable ? "yes" : "no");
  return table;
}

/// Depth of a TreeID by way of its parents, as the listing of figure 4.18 says.
struct WayUp {
  int depth = 0;
  std::string way;

  explicit WayUp(TreeId id) : way(std::to_string(id)) {
    while (id > 0) {
      id = (id - 1) / 2;
      ++depth;
      way += fmt::format(" {}", id);
    }
  }
};

std::string_view side_of(TreeId id) {
  return id == 0 ? "root" : id % 2 == 1 ? "left" : "right";
}

/// Nodes in the order of their TreeIDs.
std::vector<const Node*> by_tree_id(const Tree& tree) {
  std::vector<const Node*> nodes;
  for (const Node& node : tree.nodes) {
    nodes.push_back(&node);
  }
  std::sort(nodes.begin(), nodes.end(), [](const Node* a, const Node* b) { return a->id < b->id; });
  return nodes;
}

/// The TreeIDs that a node's children name as their parent's must be its own.
void check_parents(const Tree& tree) {
  for (const Node& node : tree.nodes) {
    if (!node.is_leaf()) {
      for (const std::uint32_t child : {node.left, node.right}) {
        require((tree.nodes[child].id - 1) / 2 == node.id, "TreeIDs of figure 4.21");
      }
    }
  }
}

std::string half(TreeId id) {
  return fmt::format("({} - 1)/2 = {}", id, (id - 1) / 2);
}

}  // namespace

Result figure_4_14(const Context&) {
  const ToySet set = eight_toy_set();
  const ImplicitTree tree = to_implicit(tree_of(set.mesh), kCompleteLevels);
  Result result = listing_result(
      "figure_4_14",
      "The tree of boxes as a class: what it holds and what follows from a TreeID. Beside it the "
      "fields of a node, from the tree of eight triangles.",
      {.title = "The class of a tree",
       .lines = {{0, "tree:"},
                 {1, "nodes: 2^level - 1 slots, by TreeID"},
                 {1, "triangles: their numbers, side by side"},
                 {0, "node:"},
                 {1, "bounds, first, count, used, undividable"},
                 {0, "of node i:"},
                 {1, "left child: 2 i + 1"},
                 {1, "right child: 2 i + 2"},
                 {1, "parent: (i - 1) / 2, rounded down"},
                 {1, "leaf: its left child is not used"},
                 {1, "its triangles: count of them from first"}},
       .heading = fmt::format("the set \"{}\", SOMS", set.title)},
      field_table(tree));
  result.remarks = {fmt::format(
      "A node takes {} bytes, padding included. The library stores trees by TreeID on request; by "
      "default only nodes that exist are stored.",
      sizeof(ImplicitTree::Slot))};
  return result;
}

Result figure_4_15(const Context&) {
  const ToySet& set = uneven_set();
  Table steps{.id = "figure_4_15_levels",
              .caption = fmt::format("Slots that are made for each level, their bytes, and how "
                                     "many the SOMS tree of \"{}\" then uses.",
                                     set.title),
              .columns = {{"level"}, {"slots"}, {"bytes"}, {"used"}}};
  std::uint64_t used_by_last = 0;
  for (int level = 1; level <= kObjectLevel; ++level) {
    const Tree tree = tree_of(set.mesh, level);
    const ImplicitTree stored = to_implicit(tree, level);
    used_by_last = 0;
    for (const ImplicitTree::Slot& slot : stored.slots) {
      used_by_last += slot.used ? 1U : 0U;
    }
    require(used_by_last == tree.nodes.size(), "slots and nodes of figure 4.15");
    steps.rows.push_back({static_cast<std::int64_t>(level), count_cell(stored.slots.size()),
                          count_cell(stored.slots.size() * sizeof(ImplicitTree::Slot)),
                          count_cell(used_by_last)});
  }
  Result result = listing_result(
      "figure_4_15",
      "Making an empty tree: the greatest level decides how many slots there are, before any node "
      "is made. Each level doubles them; a small set soon uses no more.",
      {.title = "How a tree begins",
       .lines = {{0, "begin (level, triangles):"},
                 {1, "slots = 2^level - 1"},
                 {1, "for each slot:"},
                 {2, "bounds = empty, count = 0"},
                 {2, "used = no, undividable = no"},
                 {1, "list = the numbers of all triangles, in order"},
                 {1, "slot 0: used = yes, first = 0, count = all"},
                 {1, "split from TreeID 0 (figure 4.17)"}},
       .heading = fmt::format("slots by level; used by \"{}\"", set.title)},
      std::move(steps));
  result.remarks = {fmt::format(
      "By the captions of tables 5.3 and 5.9 the greatest level is what the declared array can "
      "hold. At level {} these are {} slots, of which this tree uses {}.",
      kObjectLevel, (1 << kObjectLevel) - 1, used_by_last)};
  return result;
}

Result figure_4_16(const Context&) {
  const ToySet set = eight_toy_set();
  const Tree tree = tree_of(set.mesh);
  Table table{.id = "figure_4_16_depths",
              .caption = fmt::format("The SOMS tree of \"{}\" depth by depth.", set.title),
              .columns = {{"depth"},
                          {"level"},
                          {"nodes"},
                          {"first_tree_id"},
                          {"last_tree_id"},
                          {"triangles_per_node"}}};
  Drawing drawing{.title = "Boxes of the tree, depth by depth", .view = flat_view()};
  for (int level = 1; level <= kCompleteLevels; ++level) {
    const LevelCount count = count_level(tree, level);
    const TreeId first = (TreeId{1} << static_cast<unsigned>(level - 1)) - 1;
    require(count.nodes == static_cast<std::int64_t>(first) + 1 && count.most == count.fewest,
            "the complete tree of figure 4.16");
    table.rows.push_back({static_cast<std::int64_t>(level - 1), static_cast<std::int64_t>(level),
                          count.nodes, count_cell(first), count_cell(2 * first), count.most});
    drawing.panels.push_back(
        level_panel(set.mesh, tree, level, fmt::format("depth {}", level - 1)));
  }
  const TreeDiagram diagram{
      .title = "A tree of depth 3, whose root has TreeID 0 and depth 0",
      .subtitle = fmt::format("{}, divided by SOMS; below each node its triangles", set.title),
      .tree = &tree,
      .words = [&](const Node& node) { return std::vector{numbers_of(tree.triangles_of(node))}; },
      .row_words =
          [](std::uint32_t depth) {
            return std::vector{fmt::format("depth {}", depth), fmt::format("level {}", depth + 1)};
          }};
  Result result;
  result.figures = {{.id = "figure_4_16",
                     .caption = "The tree of eight triangles, built by SOMS: three divisions leave "
                                "each triangle alone. Drawn from the caption, whose \"depth = 3 "
                                "where root is equal to 0\" fits both the root's depth and its "
                                "TreeID.",
                     .svg = draw_tree(diagram),
                     .alt = "A complete binary tree of depth 3 with TreeIDs 0 to 14."},
                    {.id = "figure_4_16_boxes",
                     .caption = "The boxes of the same tree at depths 0 to 3.",
                     .svg = draw(drawing),
                     .alt = "Eight triangles in one, two, four and eight boxes."}};
  result.tables = {std::move(table)};
  return result;
}

Result figure_4_18(const Context&) {
  const ToySet& set = uneven_set();
  const Tree tree = tree_of(set.mesh);
  Table steps{.id = "figure_4_18_depths",
              .caption = fmt::format("TreeIDs of the SOMS tree of \"{}\": the way up to the root "
                                     "by parents, its length, and TreeID + 1 in binary.",
                                     set.title),
              .columns = {{"tree_id"}, {"way_up"}, {"depth"}, {"level"}, {"plus_1_in_binary"}}};
  for (const Node* node : by_tree_id(tree)) {
    const WayUp up(node->id);
    require(up.depth == depth_of(node->id) && up.depth == static_cast<int>(node->depth),
            "depths of figure 4.18");
    steps.rows.push_back({count_cell(node->id), up.way, static_cast<std::int64_t>(up.depth),
                          static_cast<std::int64_t>(up.depth + 1),
                          fmt::format("{:b}", node->id + 1)});
  }
  Result result = listing_result(
      "figure_4_18",
      "Depth and level of a node from its TreeID alone, on an uneven tree of eight triangles.",
      {.title = "How deep a node is",
       .lines = {{0, "depth (TreeID):"},
                 {1, "depth = 0"},
                 {1, "while TreeID > 0:"},
                 {2, "TreeID = (TreeID - 1) / 2, rounded down"},
                 {2, "depth = depth + 1"},
                 {1, "level = depth + 1"}},
       .heading = fmt::format("the set \"{}\", SOMS", set.title)},
      std::move(steps));
  result.remarks = {
      "The depth is floor(log2(TreeID + 1)): the digits of TreeID + 1 in binary, less one. At each "
      "node this run compared both with the depth that the tree stores. Below the first digit, 0 "
      "is a step to the left and 1 to the right."};
  return result;
}

Result figure_4_21(const Context&) {
  const ToySet set = eight_toy_set();
  const Tree tree = tree_of(set.mesh);
  check_parents(tree);
  Table table{
      .id = "figure_4_21_tree_ids",
      .caption = fmt::format("Nodes of the SOMS tree of \"{}\": half of TreeID - 1, and the "
                             "parent, which is this rounded down.",
                             set.title),
      .columns = {{"tree_id"}, {"side"}, {"half"}, {"parent"}, {"depth"}, {"triangles"}}};
  for (const Node* node : by_tree_id(tree)) {
    const bool root = node->id == 0;
    table.rows.push_back({count_cell(node->id), word_cell(side_of(node->id)),
                          root ? Cell{} : Cell{static_cast<double>(node->id - 1) / 2},
                          root ? Cell{} : count_cell(parent_of(node->id)), count_cell(node->depth),
                          count_cell(node->count)});
  }
  const TreeDiagram diagram{
      .title = "TreeIDs: the parent of each node is (TreeID - 1)/2, rounded down",
      .subtitle = "Left children (blue) are odd, right children (orange) are even",
      .tree = &tree,
      .words =
          [](const Node& node) {
            return node.id == 0 ? std::vector<std::string>() : std::vector{half(node.id)};
          },
      .row_words = [](std::uint32_t depth) { return std::vector{fmt::format("depth {}", depth)}; }};
  Result result;
  result.figures = {
      {.id = "figure_4_21",
       .caption = fmt::format("TreeIDs of the tree of eight triangles and the parents "
                              "that follow from them. The caption's examples: left "
                              "node 1, {}; right node 4, {}.",
                              half(1), half(4)),
       .svg = draw_tree(diagram),
       .alt = "A complete binary tree with TreeIDs 0 to 14 and the parent's TreeID "
              "below each."}};
  result.tables = {std::move(table)};
  result.remarks = {fmt::format(
      "(4 - 1)/2 is {}: the caption's {} is a division of integers, which rounds down. The halves "
      "of left children are whole, those of right children are not.",
      static_cast<double>(4 - 1) / 2, parent_of(4))};
  return result;
}

}  // namespace soms::reproduce
