#include "soms/query/detail/winding/winding_tree.h"

#include "soms/base/double_limits.h"
#include "soms/geometry/detail/exact/double_double.h"
#include "soms/geometry/detail/parts/joined.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/query/detail/parity/triangle_crossing.h"
#include "soms/tree/build.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace soms::detail {

namespace {

/// Fewer edges cost no more than moments.
constexpr std::size_t kFewEdges = 8;

/// Nodes are split while their boundary is longer than that of a sheet cut out of a surface.
bool is_short(std::size_t edges, std::size_t triangles) {
  return static_cast<double>(edges) <= 64 + 4 * std::sqrt(static_cast<double>(triangles));
}

std::array<std::uint32_t, 3> joined_corners(const MeshView& mesh,
                                            const std::vector<std::uint32_t>& joined,
                                            TriangleId id) {
  const auto& t = mesh.triangles[id];
  return {joined[t[0]], joined[t[1]], joined[t[2]]};
}

Mesh moved_mesh(const Body& body) {
  Mesh mesh;
  const auto& triangles = body.shape.mesh().triangles;
  mesh.triangles.assign(triangles.begin(), triangles.end());
  for (const Vec3& v : body.shape.mesh().vertices) {
    mesh.vertices.push_back(body.pose.apply(v));
  }
  return mesh;
}

std::uint64_t uses(const std::vector<BoundaryEdge>& edges) {
  std::uint64_t sum = 0;
  for (const BoundaryEdge& edge : edges) {
    sum += static_cast<std::uint64_t>(edge.times);
  }
  return sum;
}

}  // namespace

/// Makes nodes from the top down.
class WindingTree::Builder {
 public:
  Builder(const Body& body, const Limits& limits, WindingTree& made)
      : body_(body), mesh_(body.shape.mesh()), limits_(limits), made_(made) {}

  void build() {
    std::vector<TriangleId> all(mesh_.triangles.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = static_cast<TriangleId>(i);
    }
    std::vector<BoundaryEdge> edges = boundary_of(all);
    made_.boundary_edges_ = uses(edges);
    if (is_short(edges.size(), all.size())) {
      add_node(0, all, std::move(edges), true);
      return;
    }
    tree_ = soms::build(moved_mesh(body_), {}, limits_);
    made_.place_.resize(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      made_.place_[tree_.primitives[k]] = static_cast<std::uint32_t>(k);
    }
    add_subtree(0);
  }

 private:
  [[nodiscard]] std::vector<BoundaryEdge> boundary_of(std::span<const TriangleId> triangles) const {
    std::vector<BoundaryEdge> edges;
    for (const TriangleId id : triangles) {
      add_edges(joined_corners(mesh_, made_.joined_, id), 1, edges);
    }
    cancel(edges);
    return edges;
  }

  void add_subtree(std::uint32_t root) {
    check(limits_);
    const soms::Node& from = tree_.nodes[root];
    const std::span<const TriangleId> triangles = tree_.triangles_of(from);
    std::vector<BoundaryEdge> edges = boundary_of(triangles);
    const bool last = from.is_leaf() || is_short(edges.size(), triangles.size());
    const std::size_t index = add_node(from.first, triangles, std::move(edges), last);
    if (!last) {
      add_subtree(from.left);
      add_subtree(from.right);
    }
    made_.nodes_[index].next = static_cast<std::uint32_t>(made_.nodes_.size());
  }

  std::size_t add_node(std::uint32_t first, std::span<const TriangleId> triangles,
                       std::vector<BoundaryEdge> edges, bool last) {
    Node node{.first = first, .count = static_cast<std::uint32_t>(triangles.size())};
    if (!last || edges.size() > kFewEdges) {
      std::vector<Triangle> moved;
      for (const TriangleId id : triangles) {
        moved.push_back(moved_triangle(body_, id));
      }
      node.far = static_cast<std::uint32_t>(made_.far_.size());
      made_.far_.emplace_back(moved);
    }
    if (last) {
      node.border = static_cast<std::uint32_t>(made_.borders_.size());
      made_.borders_.push_back(made_.border_of(body_, std::move(edges)));
    }
    made_.nodes_.push_back(node);
    made_.nodes_.back().next = static_cast<std::uint32_t>(made_.nodes_.size());
    return made_.nodes_.size() - 1;
  }

  const Body& body_;
  const MeshView& mesh_;
  const Limits& limits_;
  WindingTree& made_;
  Tree tree_;
};

WindingTree::WindingTree(const Body& body, const Limits& limits) {
  const MeshView& mesh = body.shape.mesh();
  Work work(limits, joining_work(mesh) + 1);
  joined_ = joined_by_position(mesh, work);
  Builder(body, {.threads = limits.threads, .stop = limits.stop}, *this).build();
}

WindingTree::Border WindingTree::border_of(const Body& body,
                                           std::vector<BoundaryEdge> edges) const {
  Border border;
  for (const BoundaryEdge& edge : edges) {
    border.place.push_back(edge.from);
    border.place.push_back(edge.to);
  }
  std::sort(border.place.begin(), border.place.end());
  border.place.erase(std::unique(border.place.begin(), border.place.end()), border.place.end());
  const auto index_of = [&](std::uint32_t vertex) {
    return static_cast<std::uint32_t>(
        std::lower_bound(border.place.begin(), border.place.end(), vertex) - border.place.begin());
  };
  for (BoundaryEdge& edge : edges) {
    edge = {index_of(edge.from), index_of(edge.to), edge.times};
  }
  border.edges = std::move(edges);
  for (const std::uint32_t vertex : border.place) {
    border.corners.push_back(body.pose.apply(body.shape.mesh().vertices[vertex]));
  }
  return border;
}

std::size_t WindingTree::memory() const {
  std::size_t bytes = sizeof *this + nodes_.size() * sizeof(Node) + far_.size() * sizeof(FarField) +
                      (place_.size() + joined_.size()) * sizeof(std::uint32_t);
  for (const Border& border : borders_) {
    bytes += sizeof border + border.edges.size() * sizeof(BoundaryEdge) +
             border.corners.size() * (sizeof(Vec3) + sizeof(std::uint32_t));
  }
  return bytes;
}

/// The sum for one point.
class WindingTree::Sum {
 public:
  Sum(const WindingTree& tree, const Body& body, const Vec3& point, const StripDirection& direction,
      Memory& memory)
      : tree_(tree), body_(body), point_(point), direction_(direction), memory_(memory) {}

  /// Takes a node by its moments, if they are good enough. A tolerance that underflows takes
  /// what is exact.
  bool take_far(const Node& node, double width) {
    const double share =
        static_cast<double>(passed_ + node.count) / static_cast<double>(tree_.nodes_[0].count);
    const std::optional<Estimate> far =
        tree_.far_[node.far].at(point_, 0.5 * width * share - far_error_);
    if (!far) {
      return false;
    }
    sum_ += far->value;
    sizes_ += std::abs(far->value);
    far_error_ += far->error;
    ++terms_;
    pass(node);
    return true;
  }

  /// Takes a node by crossings and its boundary.
  void take_near(const Node& node) {
    const Crossings met = crossings_of(node);
    bool on = false;
    for (const Memory::Crossing& c : met) {
      crossings_ += c.sign;
      on = on || c.sign == 0;
    }
    const Border& border = tree_.borders_[node.border];
    if (on) {
      add_border(without_touched(border, met));
    } else {
      add_border(border);
    }
    pass(node);
  }

  /// Terms that underflow are below the step that the bounds are moved by.
  [[nodiscard]] Bracket bracket() const {
    const double rest = angles_.rest();
    const double whole = static_cast<double>(crossings_) + angles_.turns();
    double error = far_error_ + error_;
    if (edges_ != 0) {
      error += kArgumentError;
    }
    if (edges_ == 0 && terms_ == 0 && touched_ == 0) {
      return {whole, whole};
    }
    const double number = whole + (rest + sum_);
    error += kRoundingUnit * (2 * std::abs(number) + 2 * std::abs(rest) + (terms_ + 2) * sizes_);
    error = error * (1 + 0x1p-20) + 0.5 * static_cast<double>(touched_);
    return {next_below(number - error), next_above(number + error)};
  }

  [[nodiscard]] std::uint64_t edges() const { return edges_; }

 private:
  using Crossings = std::span<const Memory::Crossing>;

  /// Those of the node's triangles. Nodes come in order.
  [[nodiscard]] Crossings crossings_of(const Node& node) {
    const std::vector<Memory::Crossing>& all = memory_.crossings;
    while (next_crossing_ < all.size() && all[next_crossing_].place < node.first) {
      ++next_crossing_;
    }
    const std::size_t begin = next_crossing_;
    while (next_crossing_ < all.size() && all[next_crossing_].place - node.first < node.count) {
      ++next_crossing_;
    }
    return Crossings(all).subspan(begin, next_crossing_ - begin);
  }

  /// The boundary of what is left when triangles that the point is on are gone: no edge of it
  /// holds the point.
  [[nodiscard]] Border without_touched(const Border& border, Crossings crossings) {
    std::vector<BoundaryEdge> edges;
    for (const BoundaryEdge& edge : border.edges) {
      edges.push_back({border.place[edge.from], border.place[edge.to], edge.times});
    }
    for (const Memory::Crossing& c : crossings) {
      if (c.sign == 0) {
        add_edges(joined_corners(body_.shape.mesh(), tree_.joined_, c.triangle), -1, edges);
        ++touched_;
      }
    }
    cancel(edges);
    return tree_.border_of(body_, std::move(edges));
  }

  void add_border(const Border& border) {
    std::vector<SeenCorner>& seen = memory_.seen;
    seen.clear();
    for (const Vec3& corner : border.corners) {
      seen.push_back(seen_corner(corner, point_, direction_));
    }
    for (const BoundaryEdge& edge : border.edges) {
      const StripAngle z = strip_angle(border.corners[edge.from], seen[edge.from],
                                       border.corners[edge.to], seen[edge.to], point_, direction_);
      for (std::int32_t k = 0; k < edge.times; ++k) {
        angles_.add(z.re, z.im);
        error_ += z.error;
      }
    }
    edges_ += border.edges.size();
  }

  void pass(const Node& node) { passed_ += node.count; }

  const WindingTree& tree_;
  const Body& body_;
  const Vec3& point_;
  const StripDirection& direction_;
  Memory& memory_;
  std::size_t next_crossing_ = 0;
  AngleSum angles_;
  std::int64_t crossings_ = 0;
  std::uint64_t touched_ = 0;
  std::uint64_t edges_ = 0;
  std::uint64_t passed_ = 0;  // triangles
  double terms_ = 0;          // of `sum_`
  double sum_ = 0;            // by moments
  double sizes_ = 0;          // the same with absolute values
  double far_error_ = 0;
  double error_ = 0;
};

void WindingTree::prepare(const Body& body, std::size_t axis, bool forward,
                          const PointCrossings& met, Memory& memory) const {
  memory.crossings.clear();
  const auto place_of = [&](TriangleId id) { return place_.empty() ? id : place_[id]; };
  for (const TriangleId id : met.crossed) {
    const int sign = crosses_to_front(moved_triangle(body, id), axis, forward) ? 1 : -1;
    memory.crossings.push_back({place_of(id), sign, id});
  }
  for (const TriangleId id : met.on) {
    memory.crossings.push_back({place_of(id), 0, id});
  }
  std::sort(memory.crossings.begin(), memory.crossings.end(),
            [](const auto& a, const auto& b) { return a.place < b.place; });
}

Bracket WindingTree::number(const Body& body, const Vec3& point, std::size_t axis, bool forward,
                            const PointCrossings& met, double width, Memory& memory,
                            Cost& cost) const {
  prepare(body, axis, forward, met, memory);
  const StripDirection against{axis, forward ? -1.0 : 1.0};
  Sum sum(*this, body, point, against, memory);
  for (std::size_t i = 0; i < nodes_.size();) {
    const Node& node = nodes_[i];
    if (node.far != kNone) {
      ++cost.node_tests;
      if (sum.take_far(node, width)) {
        i = node.next;
        continue;
      }
    }
    if (node.border == kNone) {
      ++i;
      continue;
    }
    sum.take_near(node);
    i = node.next;
  }
  cost.triangle_tests += sum.edges();
  return sum.bracket();
}

}  // namespace soms::detail
