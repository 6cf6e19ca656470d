#include "tests/thesis/cases.h"

#include "soms/thesis/traversals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace soms::test {

namespace {

constexpr std::array kBaselines{Traversal::a_first, Traversal::b_first, Traversal::alternate,
                                Traversal::larger, Traversal::simultaneous};

std::vector<TraversalOptions> baseline_options() {
  std::vector<TraversalOptions> out;
  for (const bool recursive : {false, true}) {
    for (const bool prune : {true, false}) {
      for (const Traversal rule : kBaselines) {
        out.push_back({.traversal = rule, .recursive = recursive, .prune = prune});
        out.push_back({.traversal = Traversal::ericson,
                       .ericson_rule = rule,
                       .recursive = recursive,
                       .prune = prune});
      }
      out.push_back({.traversal = Traversal::larsson, .recursive = recursive, .prune = prune});
    }
  }
  return out;
}

double small_integer(Rng& rng, std::uint64_t n) {
  return static_cast<double>(rng.below(n));
}

Vec3 random_point(Rng& rng) {
  return {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
}

Vec3 lattice_point(Rng& rng) {
  return {small_integer(rng, 4) - 2, small_integer(rng, 4) - 2, small_integer(rng, 4) - 2};
}

Triangle random_triangle(Rng& rng) {
  const Vec3 at = random_point(rng);
  return {at, at + 0.5 * random_point(rng), at + 0.5 * random_point(rng)};
}

Triangle triangle(Rng& rng, Kind kind, std::size_t i) {
  Triangle t = random_triangle(rng);
  switch (kind) {
    case Kind::random:
      break;
    case Kind::lattice:
      t = {lattice_point(rng), lattice_point(rng), lattice_point(rng)};
      break;
    case Kind::degenerate:
      t = {lattice_point(rng), lattice_point(rng), lattice_point(rng)};
      t.b = rng.below(2) == 0 ? t.a : t.b;
      t.c = rng.below(3) == 0 ? t.a : t.a + (t.b - t.a) * small_integer(rng, 3);
      break;
    case Kind::nested: {
      const double scale = std::ldexp(1.0, -static_cast<int>(i % 40));
      t = {t.a * scale, t.b * scale, t.c * scale};
      break;
    }
    case Kind::coincident:
      t = {{0, 0, 0}, {1, 0, 0}, {0, 1, small_integer(rng, 2)}};
      break;
  }
  return t;
}

class TreeGrower {
 public:
  TreeGrower(Rng& rng, const Mesh& mesh, std::size_t per_leaf)
      : rng_(rng), mesh_(mesh), per_leaf_(per_leaf) {
    tree_.primitives.resize(mesh.triangles.size());
    std::iota(tree_.primitives.begin(), tree_.primitives.end(), TriangleId{0});
  }

  Tree grow() {
    if (!tree_.primitives.empty()) {
      add(0, tree_.primitives.size(), 0, 0);
    }
    return std::move(tree_);
  }

 private:
  // Depth grows with the logarithm of the count but for unlucky cuts: tests keep counts small.
  std::uint32_t add(std::size_t first, std::size_t count, TreeId id, std::uint32_t depth) {
    const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
    Node node;
    node.id = id;
    node.first = static_cast<std::uint32_t>(first);
    node.count = static_cast<std::uint32_t>(count);
    node.depth = depth;
    for (std::size_t k = first; k < first + count; ++k) {
      node.bounds.grow(bounds(mesh_.triangle(tree_.primitives[k])));
    }
    tree_.nodes.push_back(node);
    if (count > per_leaf_ && depth < 50) {
      const std::size_t cut = split(first, count);
      const std::uint32_t left = add(first, cut, 2 * id + 1, depth + 1);
      const std::uint32_t right = add(first + cut, count - cut, 2 * id + 2, depth + 1);
      tree_.nodes[index].left = left;
      tree_.nodes[index].right = right;
    }
    return index;
  }

  std::size_t split(std::size_t first, std::size_t count) {
    const std::size_t axis = rng_.below(3);
    const auto begin = tree_.primitives.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, begin + static_cast<std::ptrdiff_t>(count), [&](TriangleId i, TriangleId j) {
      return std::pair(mesh_.triangle(i).a[axis], i) < std::pair(mesh_.triangle(j).a[axis], j);
    });
    if (rng_.below(16) == 0) {
      return rng_.below(2) == 0 ? 0 : count;  // one child without triangles
    }
    return rng_.below(2) == 0 ? count / 2 : 1 + rng_.below(count - 1);
  }

  Rng& rng_;
  const Mesh& mesh_;
  std::size_t per_leaf_;
  Tree tree_;
};

}  // namespace

std::vector<TraversalOptions> every_traversal_options() {
  std::vector<TraversalOptions> out = baseline_options();
  for (const EntryOrder order : {EntryOrder::tree, EntryOrder::volume}) {
    for (const DescentEntry& descent : descents()) {
      for (const bool prune : {true, false}) {
        for (const bool recursive : {false, true}) {
          out.push_back({.traversal = Traversal::e_node,
                         .descent = descent.descent,
                         .order = order,
                         .recursive = recursive,
                         .prune = prune});
        }
      }
    }
    for (const Descent descent : {Descent::both, Descent::larger}) {
      out.push_back({.traversal = Traversal::e_node_front, .descent = descent, .order = order});
    }
  }
  return out;
}

std::string describe(const TraversalOptions& options) {
  std::ostringstream out;
  out << entry(options.traversal).name;
  if (options.traversal == Traversal::ericson) {
    out << ' ' << entry(options.ericson_rule).name;
  }
  if (options.traversal == Traversal::e_node || options.traversal == Traversal::e_node_front) {
    out << ' ' << entry(options.descent).name;
    out << (options.order == EntryOrder::volume ? " volume" : "");
  }
  out << (options.recursive ? " recursive" : "") << (options.prune ? "" : " prune=off")
      << (options.update == BoxUpdate::rebox ? " rebox" : "");
  return out.str();
}

Mesh body(Rng& rng, Kind kind, std::size_t count) {
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle t = triangle(rng, kind, i);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

Pose pose(Rng& rng, Kind kind, double reach) {
  if (kind != Kind::random && kind != Kind::nested) {
    constexpr std::array<std::array<double, 2>, 4> kTurns{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const auto& [c, s] = kTurns[rng.below(4)];
    const auto whole = [&] { return std::floor(rng.uniform(-reach, reach + 1)); };
    Pose out;
    out.m = {c, -s, 0, whole(), s, c, 0, whole(), 0, 0, 1, whole()};
    return out;
  }
  const double angle = rng.uniform(0, 3);
  const Vec3 raw = random_point(rng) + Vec3{0, 0, 1.5};
  const Vec3 axis = raw * (1 / std::sqrt(dot(raw, raw)));
  const Vec3 half = std::sin(angle / 2) * axis;
  return Pose::from_quaternion(std::cos(angle / 2), half.x, half.y, half.z,
                               reach * random_point(rng));
}

Tree random_tree(Rng& rng, const Mesh& mesh, std::size_t per_leaf) {
  return TreeGrower(rng, mesh, per_leaf).grow();
}

std::vector<NodePair> overlapping_leaves(const PosedTree& a, const PosedTree& b) {
  std::vector<NodePair> out;
  for (std::uint32_t i = 0; i < a.tree->nodes.size(); ++i) {
    for (std::uint32_t j = 0; j < b.tree->nodes.size(); ++j) {
      if (a.tree->nodes[i].is_leaf() && b.tree->nodes[j].is_leaf() &&
          overlaps(a.boxes[i], b.boxes[j])) {
        out.push_back({i, j});
      }
    }
  }
  return out;
}

std::vector<NodePair> sorted(std::vector<NodePair> pairs) {
  std::sort(pairs.begin(), pairs.end(), [](NodePair left, NodePair right) {
    return std::pair(left.a, left.b) < std::pair(right.a, right.b);
  });
  return pairs;
}

}  // namespace soms::test
