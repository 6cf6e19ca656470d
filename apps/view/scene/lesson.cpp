#include "apps/view/scene/lesson.h"

#include "soms/geometry/triangle_overlap.h"
#include "soms/thesis/traversals.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

namespace soms::view {

namespace {

std::string node_in_words(const Tree& tree, std::uint32_t index, const std::string& body) {
  const Node& node = tree.nodes[index];
  return fmt::format("node {} of {} ({}level {}, {} {})", index, body,
                     node.is_leaf() ? "a leaf, " : "", node.depth + 1, node.count,
                     node.count == 1 ? "triangle" : "triangles");
}

/// The axis along which two boxes are farthest apart, and how far; below 0 where they overlap.
std::pair<std::size_t, double> widest_gap(const Box& a, const Box& b) {
  std::pair<std::size_t, double> widest{0, -1};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double gap = std::max(a.lower[axis] - b.upper[axis], b.lower[axis] - a.upper[axis]);
    if (axis == 0 || gap > widest.second) {
      widest = {axis, gap};
    }
  }
  return widest;
}

std::string apart_in_words(const Box& a, const Box& b) {
  const auto [axis, gap] = widest_gap(a, b);
  return fmt::format("Their boxes are apart along {} by {:.6g}.", "xyz"[axis], gap);
}

/// What comes after two boxes that overlap.
std::string descent_in_words(const TraversalOptions& options) {
  const Traversal way =
      options.traversal == Traversal::ericson ? options.ericson_rule : options.traversal;
  switch (way) {
    case Traversal::a_first:
      return "The first tree is descended to its leaves, then the second.";
    case Traversal::b_first:
      return "The second tree is descended to its leaves, then the first.";
    case Traversal::alternate:
      return "The trees are descended in turn.";
    case Traversal::larger:
      return "The node of greater volume is replaced by its children.";
    case Traversal::simultaneous:
    case Traversal::larsson:
      return "Both nodes are replaced by their children: up to four pairs.";
    case Traversal::e_node:
    case Traversal::e_node_front:
      return fmt::format("E-Node tests all pairs that follow ({}) before it enters any of them.",
                         entry(options.descent).description);
    case Traversal::ericson:
    case Traversal::fast:
      break;
  }
  return "";
}

/// Which triangles of two leaves touch, and why or why not the first pair does.
std::string leaves_in_words(const ViewScene& scene, std::pair<BodyRef, BodyRef> pair,
                            std::span<const TriangleId> a, std::span<const TriangleId> b) {
  if (a.empty() || b.empty()) {
    return "One of the leaves has no triangles, so there is nothing to compare.";
  }
  std::size_t touching = 0;
  Touch shown{pair.first, pair.second, a.front(), b.front()};
  for (const TriangleId i : a) {
    for (const TriangleId j : b) {
      if (triangles_overlap(scene.triangle(pair.first, i), scene.triangle(pair.second, j))) {
        if (++touching == 1) {
          shown = {pair.first, pair.second, i, j};
        }
      }
    }
  }
  const std::size_t pairs = a.size() * b.size();
  return fmt::format(
      "Both are leaves, so their triangles are compared, {} {}: {} touch. Triangles {} and {}: {}",
      pairs, pairs == 1 ? "pair" : "pairs", touching == 0 ? "none" : std::to_string(touching),
      shown.i, shown.j, scene.explain(shown).text);
}

}  // namespace

std::vector<LessonTest> lesson_tests(const PosedTree& a, const PosedTree& b,
                                     const TraversalOptions& options, std::size_t most) {
  std::vector<LessonTest> tests;
  TraversalVisitor visitor;
  visitor.keep_going = [&] { return tests.size() < most; };
  visitor.tested = [&](NodePair nodes, bool overlap) {
    if (tests.size() == most) {
      return;
    }
    const bool leaves = a.tree->nodes[nodes.a].is_leaf() && b.tree->nodes[nodes.b].is_leaf();
    const LessonStep step = overlap && leaves           ? LessonStep::leaves
                            : overlap                   ? LessonStep::enters
                            : !options.prune && !leaves ? LessonStep::passes
                                                        : LessonStep::ends;
    tests.push_back({nodes, step});
  };
  (void)traverse(a, b, options, visitor);
  return tests;
}

std::string in_a_sentence(const TraversalOptions& options) {
  const TraversalEntry& row = entry(options.traversal);
  std::string text = fmt::format("{}: {}.", row.kebab, row.description);
  if (options.traversal == Traversal::fast) {
    text +=
        " It is the one that answers queries. Its nodes have up to four boxes, which are tested "
        "together.";
  }
  return text;
}

void Lesson::update(ViewScene& scene) {
  const auto pair = scene.pair();
  const TraversalOptions& options = scene.trees().traversal;
  if (!pair || options.traversal == Traversal::fast) {
    key_.reset();
    tests_.clear();
    return;
  }
  const Key key{*pair, scene.body(pair->first).pose, scene.body(pair->second).pose,
                scene.trees_version(), options};
  if (key_ == key) {
    return;
  }
  // Requested once before, since the second body's boxes may push out the first one's.
  (void)scene.world_boxes(pair->first);
  const std::span<const Box> boxes_b = scene.world_boxes(pair->second);
  const std::span<const Box> boxes_a = scene.world_boxes(pair->first);
  tests_ = lesson_tests({&scene.tree(pair->first), boxes_a}, {&scene.tree(pair->second), boxes_b},
                        options);
  key_ = key;
}

std::vector<std::string> Lesson::sentences(ViewScene& scene, std::size_t test) const {
  const auto pair = *scene.pair();
  const auto [nodes, step] = tests_[test];
  const Tree& tree_a = scene.tree(pair.first);
  const Tree& tree_b = scene.tree(pair.second);
  (void)scene.world_boxes(pair.first);
  const Box box_b = scene.world_boxes(pair.second)[nodes.b];
  const Box box_a = scene.world_boxes(pair.first)[nodes.a];
  std::vector<std::string> sentences{
      fmt::format("Test {} of {}: {} against {}.", test + 1, tests_.size(),
                  node_in_words(tree_a, nodes.a, scene.body(pair.first).name),
                  node_in_words(tree_b, nodes.b, scene.body(pair.second).name))};
  switch (step) {
    case LessonStep::ends:
      sentences.push_back(apart_in_words(box_a, box_b) +
                          " No triangle below one can touch a triangle below the other: this "
                          "branch ends here.");
      break;
    case LessonStep::passes:
      sentences.push_back(apart_in_words(box_a, box_b) +
                          " Pruning is off, so what is below is tested all the same.");
      break;
    case LessonStep::enters:
      sentences.push_back(
          fmt::format("Their boxes overlap along x, y and z, so triangles below them may touch: "
                      "the pair is entered. {}",
                      descent_in_words(scene.trees().traversal)));
      break;
    case LessonStep::leaves:
      sentences.push_back("Their boxes overlap. " +
                          leaves_in_words(scene, pair, tree_a.triangles_of(tree_a.nodes[nodes.a]),
                                          tree_b.triangles_of(tree_b.nodes[nodes.b])));
      break;
  }
  return sentences;
}

}  // namespace soms::view
