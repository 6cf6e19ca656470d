// Figures 4.17, 4.19 and 4.20: how nodes come to be. Each listing is run as it is written, and what
// it makes is compared with the tree that the library builds.
#include "soms/thesis/implicit.h"
#include "soms/tree/build.h"

#include "thesis/experiments/experiments.h"
#include "thesis/page/listing.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trees/toy_sets.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::reproduce {

namespace {

/// Few enough levels that the rule meets the last one.
constexpr int kLastLevel = 4;
/// Enough for every triangle of the eight.
constexpr int kWholeLevel = 5;

using Numbers = std::vector<TriangleId>;

Numbers all_of(const Mesh& mesh) {
  Numbers all(mesh.triangles.size());
  for (TriangleId id = 0; id < all.size(); ++id) {
    all[id] = id;
  }
  return all;
}

std::string number_words(const Numbers& triangles) {
  return fmt::format("{}", fmt::join(triangles, " "));
}

/// Both sides of a set that SOMS divides, empty where it does not.
struct Sides {
  Numbers left = {};
  Numbers right = {};

  [[nodiscard]] bool divided() const { return !left.empty() && !right.empty(); }
};

Sides divide(const Mesh& mesh, const Numbers& triangles) {
  const ToySplit split = split_toy(some_of(mesh, triangles), Rule::soms);
  Sides sides;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    (split.left[k] ? sides.left : sides.right).push_back(triangles[k]);
  }
  return sides;
}

/// The listing of figure 4.17 at work.
class Splitter {
 public:
  Splitter(const Mesh& mesh, int level, Table& calls)
      : mesh_(mesh),
        tree_(build(mesh, thesis_options(Rule::soms, level))),
        level_(level),
        calls_(calls) {}

  void run() {
    split(0, all_of(mesh_), 0);
    require(made_ == tree_.nodes.size(), "nodes of figure 4.17");
  }

 private:
  void split(TreeId id, const Numbers& triangles, int depth) {
    const std::size_t call = calls_.rows.size();
    calls_.rows.push_back({count_cell(call + 1), count_cell(id), static_cast<std::int64_t>(depth),
                           number_words(triangles), Cell{}});
    const auto outcome = [&](std::string words) { calls_.rows[call][4] = std::move(words); };
    check(id, triangles, depth);
    if (triangles.size() == 1) {
      return outcome("leaf: one triangle");
    }
    if (depth == level_ - 1) {
      return outcome("leaf: the last level");
    }
    const Sides sides = divide(mesh_, triangles);
    if (!sides.divided()) {
      return outcome("leaf: one side is empty");
    }
    outcome(fmt::format("{} left, {} right", sides.left.size(), sides.right.size()));
    split(2 * id + 1, sides.left, depth + 1);
    split(2 * id + 2, sides.right, depth + 1);
  }

  /// Calls come in the order in which the tree stores its nodes.
  void check(TreeId id, const Numbers& triangles, int depth) {
    const Node& node = tree_.nodes.at(made_++);
    const auto stored = tree_.triangles_of(node);
    require(
        node.id == id && static_cast<int>(node.depth) == depth &&
            std::is_permutation(stored.begin(), stored.end(), triangles.begin(), triangles.end()),
        "calls of figure 4.17 and the tree");
  }

  const Mesh& mesh_;
  Tree tree_;
  int level_;
  Table& calls_;
  std::size_t made_ = 0;
};

/// A node as figure 4.20 makes it.
struct MadeNode {
  Numbers triangles = {};  ///< none where the node does not exist
  Box box = {};
};

MadeNode make_node(const Mesh& mesh, Numbers triangles) {
  MadeNode node{std::move(triangles)};
  for (const TriangleId id : node.triangles) {
    const Triangle t = mesh.triangle(id);
    node.box.grow(t.a);
    node.box.grow(t.b);
    node.box.grow(t.c);
  }
  return node;
}

/// The nodes by TreeID as figure 4.19 makes them, and its steps.
std::vector<MadeNode> make_nodes(const Mesh& mesh, Table& steps) {
  std::vector<MadeNode> slots((std::size_t{1} << kWholeLevel) - 1);
  slots[0] = make_node(mesh, all_of(mesh));
  for (std::size_t id = 0; 2 * id + 2 < slots.size(); ++id) {
    if (slots[id].triangles.size() < 2) {
      continue;
    }
    Sides sides = divide(mesh, slots[id].triangles);
    if (!sides.divided()) {
      continue;
    }
    steps.rows.push_back({count_cell(id), number_words(slots[id].triangles), count_cell(2 * id + 1),
                          number_words(sides.left), count_cell(2 * id + 2),
                          number_words(sides.right)});
    slots[2 * id + 1] = make_node(mesh, std::move(sides.left));
    slots[2 * id + 2] = make_node(mesh, std::move(sides.right));
  }
  return slots;
}

void check_nodes(const Mesh& mesh, const std::vector<MadeNode>& made) {
  const ImplicitTree tree =
      to_implicit(build(mesh, thesis_options(Rule::soms, kWholeLevel)), kWholeLevel);
  require(made.size() == tree.slots.size(), "slots of figures 4.19 and 4.20");
  for (std::size_t id = 0; id < made.size(); ++id) {
    const ImplicitTree::Slot& slot = tree.slots[id];
    const auto stored = tree.triangles_of(slot);
    require(slot.used == !made[id].triangles.empty() && slot.bounds == made[id].box &&
                std::is_permutation(stored.begin(), stored.end(), made[id].triangles.begin(),
                                    made[id].triangles.end()),
            "nodes of figures 4.19 and 4.20");
  }
}

Table child_table() {
  return {.id = "figure_4_19_children",
          .caption =
              "The nodes that are divided, in the order of their TreeIDs, and the two nodes "
              "that each makes, with the numbers of their triangles.",
          .columns = {{"tree_id"},
                      {"triangles"},
                      {"left_child"},
                      {"left_triangles"},
                      {"right_child"},
                      {"right_triangles"}}};
}

}  // namespace

Result figure_4_17(const Context&) {
  const ToySet set = flat_toy_sets().front();
  Table steps{.id = "figure_4_17_calls",
              .caption = fmt::format("Calls of split on \"{}\" with {} levels, in their order.",
                                     set.title, kLastLevel),
              .columns = {{"call"}, {"tree_id"}, {"depth"}, {"triangles"}, {"outcome"}}};
  Splitter(set.mesh, kLastLevel, steps).run();
  return listing_result(
      "figure_4_17",
      fmt::format("Split calls itself for both children, depth first. At the right all calls for "
                  "eight triangles and {} levels, whose nodes are those of the library's tree.",
                  kLastLevel),
      {.title = "How a tree is split",
       .lines = {{0, "split (TreeID, triangles, depth):"},
                 {1, "make the node TreeID (figure 4.20)"},
                 {1, "if there is one triangle: leaf; done"},
                 {1, "if depth = level - 1: leaf; done"},
                 {1, "left, right = by the plane of SOMS (figure 4.5)"},
                 {1, "if left or right is empty: leaf; done"},
                 {1, "split (2 TreeID + 1, left, depth + 1)"},
                 {1, "split (2 TreeID + 2, right, depth + 1)"},
                 {0, "begin:"},
                 {1, "split (0, all triangles, 0)"}},
       .heading = fmt::format("the set \"{}\", level {}", set.title, kLastLevel)},
      std::move(steps));
}

Result figure_4_19(const Context&) {
  const ToySet set = eight_toy_set();
  Table steps = child_table();
  check_nodes(set.mesh, make_nodes(set.mesh, steps));
  return listing_result(
      "figure_4_19",
      "Making nodes one after the other, by TreeID, without recursion: a node that is divided "
      "makes two, whose slots are known from its own. The nodes are those of the library's tree.",
      {.title = "How the nodes of a tree are made",
       .lines = {{0, "make nodes (triangles, level):"},
                 {1, "make node (0, all triangles)"},
                 {1, "for TreeID = 0 to 2^(level - 1) - 2:"},
                 {2, "if the node exists and has two triangles or more:"},
                 {3, "left, right = by the plane of SOMS"},
                 {3, "if neither is empty:"},
                 {4, "make node (2 TreeID + 1, left)"},
                 {4, "make node (2 TreeID + 2, right)"}},
       .heading = fmt::format("the set \"{}\", level {}", set.title, kWholeLevel)},
      std::move(steps));
}

Result figure_4_20(const Context&) {
  const ToySet set = eight_toy_set();
  Table ignored = child_table();
  const std::vector<MadeNode> made = make_nodes(set.mesh, ignored);
  check_nodes(set.mesh, made);
  Table steps{.id = "figure_4_20_nodes",
              .caption = fmt::format("What each node of \"{}\" stores: its triangles and its box.",
                                     set.title),
              .columns = {{"tree_id"},
                          {"count"},
                          {"triangles"},
                          {"least_x"},
                          {"least_y"},
                          {"greatest_x"},
                          {"greatest_y"}}};
  for (std::size_t id = 0; id < made.size(); ++id) {
    const auto& [triangles, box] = made[id];
    if (!triangles.empty()) {
      steps.rows.push_back({count_cell(id), count_cell(triangles.size()), number_words(triangles),
                            box.lower.x, box.lower.y, box.upper.x, box.upper.y});
    }
  }
  return listing_result(
      "figure_4_20",
      "Making one node of a tree of boxes: its box is that of its triangles' corners. At the right "
      "all nodes of the set; they are those of the library's tree.",
      {.title = "How a node is made",
       .lines = {{0, "make node (TreeID, triangles):"},
                 {1, "bounds = empty"},
                 {1, "for each triangle A, B, C:"},
                 {2, "grow bounds by A, by B and by C"},
                 {1, "count = number of triangles"},
                 {1, "store bounds, count and the triangles at TreeID"}},
       .heading = fmt::format("the set \"{}\", which lies in the plane z = 0", set.title)},
      std::move(steps));
}

}  // namespace soms::reproduce
