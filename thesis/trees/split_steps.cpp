#include "thesis/trees/split_steps.h"

#include "thesis/pictures/toy_pictures.h"
#include "thesis/run/traversal_tables.h"

#include <algorithm>

namespace soms::reproduce {

namespace {

SplitStep step_of(const Mesh& mesh, const Tree& tree, const Node& node, int level) {
  SplitStep step{.node = &node, .divided = !node.is_leaf(), .outcome = "divided"};
  const std::span<const TriangleId> stored = tree.triangles_of(node);
  std::vector<TriangleId> ids(stored.begin(), stored.end());
  std::sort(ids.begin(), ids.end());  // rules see triangles in ascending order
  if (node.count <= 1) {
    step.outcome = "leaf: one triangle";
  } else if (static_cast<int>(node.depth) == level - 1) {
    step.outcome = "leaf: last level";
  } else {
    step.split = split_toy(some_of(mesh, ids), Rule::soms);
    require(step.split.divides() == step.divided, "a node of the tree and the rule");
    step.outcome = step.divided ? "divided" : "leaf: cannot be divided";
  }
  if (step.divided) {
    require(tree.nodes[node.left].count == step.split.left_count,
            "triangles left of the plane in the tree and by the rule");
  }
  return step;
}

}  // namespace

std::vector<SplitStep> split_steps(const Mesh& mesh, const Tree& tree, int level) {
  std::vector<SplitStep> steps;
  for (const Node& node : tree.nodes) {
    steps.push_back(step_of(mesh, tree, node, level));
  }
  return steps;
}

Table split_table(std::string id, std::string caption, std::span<const SplitStep> steps) {
  Table table{.id = std::move(id),
              .caption = std::move(caption),
              .columns = {{"tree_id"},
                          {"depth"},
                          {"triangles"},
                          {"axis"},
                          {"plane"},
                          {"left"},
                          {"right"},
                          {"outcome"}}};
  for (const SplitStep& step : steps) {
    const Node& node = *step.node;
    std::vector<Cell> row{count_cell(node.id), count_cell(node.depth), count_cell(node.count)};
    if (step.split.left.empty()) {
      row.resize(7);
    } else {
      row.emplace_back(std::string(1, kAxisNames[step.split.axis]));
      row.emplace_back(step.split.plane);
      row.push_back(count_cell(step.split.left_count));
      row.push_back(count_cell(step.split.left.size() - step.split.left_count));
    }
    row.push_back(step.outcome);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace soms::reproduce
