#include "thesis/trees/neutral_builders.h"

#include "soms/base/arithmetic.h"
#include "soms/base/box.h"
#include "soms/geometry/midpoint.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

namespace soms::reproduce {

namespace {

using Item = NeutralBuilder::Item;
using ListItem = NeutralBuilder::ListItem;
using Lists = std::vector<std::vector<ListItem>>;
using Point = std::array<double, 3>;

/// A box that grows by arrays, which compilers turn into vector instructions for both rules alike.
struct Range {
  Point lower = filled(std::numeric_limits<double>::infinity());
  Point upper = filled(-std::numeric_limits<double>::infinity());

  static constexpr Point filled(double x) { return {x, x, x}; }

  void grow(const Point& least, const Point& greatest) {
    for (std::size_t k = 0; k < 3; ++k) {
      lower[k] = least[k] < lower[k] ? least[k] : lower[k];
      upper[k] = greatest[k] > upper[k] ? greatest[k] : upper[k];
    }
  }

  [[nodiscard]] Box box() const {
    return {{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}};
  }
};

/// What tells the rules apart. A value and not a type, so that one machine code serves both: a
/// compiler that made two of them would give one rule the better registers.
struct RuleParts {
  Point Item::*least = &Item::lower;  ///< what the box that is divided grows by
  Point Item::*greatest = &Item::upper;
  bool soms = false;

  [[nodiscard]] double plane(double lower, double upper) const {
    const double middle = 0.5 * (lower + upper);
    return soms && !(middle > lower) ? upper : middle;
  }

  /// Where boxes grown are counted.
  [[nodiscard]] std::uint64_t& grown(BuildWork& work) const {
    return soms ? work.inner : work.outer;
  }
};

constexpr RuleParts kSpatialMedianParts{};
constexpr RuleParts kSomsParts{&Item::midpoint, &Item::midpoint, true};

// Passes over triangles are never inlined: what surrounds them must not decide how well they are
// compiled, for it differs from rule to rule.

/// The box that `rule` divides, of a run in place.
[[gnu::noinline]] Range box_of(std::span<const Item> items, const RuleParts& rule,
                               BuildWork& work) {
  const auto least = rule.least;
  const auto greatest = rule.greatest;
  Range box;
  for (const Item& item : items) {
    box.grow(item.*least, item.*greatest);
  }
  rule.grown(work) += items.size();
  return box;
}

/// The boxes of a list: of all corners, and of all midpoints.
[[gnu::noinline]] Range outer_box_of(std::span<const ListItem> list, BuildWork& work) {
  Range box;
  for (const ListItem& item : list) {
    for (const Point& corner : item.corners) {
      box.grow(corner, corner);
    }
  }
  work.outer += list.size();
  return box;
}

[[gnu::noinline]] Range inner_box_of(std::span<const ListItem> list, BuildWork& work) {
  Range box;
  for (const ListItem& item : list) {
    box.grow(item.midpoint, item.midpoint);
  }
  work.inner += list.size();
  return box;
}

/// Axes by decreasing extent; of equal ones x before y before z.
std::array<std::size_t, 3> axes_of(const Range& box) {
  std::array<std::size_t, 3> order{0, 1, 2};
  const auto extent = [&](std::size_t k) { return box.upper[k] - box.lower[k]; };
  const auto swap_if_less = [&](std::size_t i, std::size_t j) {
    if (extent(order[i]) < extent(order[j])) {
      std::swap(order[i], order[j]);
    }
  };
  swap_if_less(0, 1);
  swap_if_less(1, 2);
  swap_if_less(0, 1);
  return order;
}

/// The first triangle of the right half by midpoint on the axis, ties by number.
template <typename Any>
std::pair<double, TriangleId> middle_item(std::span<const Any> items, std::size_t axis) {
  std::vector<std::pair<double, TriangleId>> keys(items.size());
  std::transform(items.begin(), items.end(), keys.begin(),
                 [axis](const Any& item) { return std::pair(item.midpoint[axis], item.id); });
  const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(keys.size() / 2);
  std::nth_element(keys.begin(), middle, keys.end());
  return *middle;
}

/// What a node is divided into; none where it stays whole.
struct Division {
  bool divided = false;             ///< it has two children, one of which may be empty
  std::size_t left = 0;             ///< triangles of the left child
  std::array<Range, 2> boxes = {};  ///< of each side, where the builder grows them by now
};

/// Divides a node as the options say. `partition(is_left)` brings the triangles apart.
template <typename Any, typename Partition>
Division divide(Node& node, std::span<const Any> items, const Range& box, const RuleParts& rule,
                EmptySide empty_side, BuildWork& work, const Partition& partition) {
  const std::array<std::size_t, 3> order = axes_of(box);
  const std::size_t tries = empty_side == EmptySide::next_axis ? order.size() : 1;
  Division division;
  for (std::size_t k = 0; k < tries && !division.divided; ++k) {
    const std::size_t axis = order[k];
    const double plane = rule.plane(box.lower[axis], box.upper[axis]);
    division = partition([axis, plane](const Any& item) { return item.midpoint[axis] < plane; });
    division.divided = division.left > 0 && division.left < items.size();
    work.compared += items.size();
  }
  if (division.divided) {
    return division;
  }
  node.undividable = true;
  if (empty_side == EmptySide::object_median) {
    const auto [value, id] = middle_item(items, order[0]);
    work.compared += items.size();
    division = partition([axis = order[0], value = value, id = id](const Any& item) {
      const double m = item.midpoint[axis];
      return m < value || (m == value && item.id < id);
    });
  }
  division.divided = empty_side == EmptySide::object_median || empty_side == EmptySide::chain;
  return division;
}

Node child_of(const Node& parent, bool right, std::size_t left_count) {
  const auto left = static_cast<std::uint32_t>(left_count);
  Node node;
  node.id = right ? right_child_of(parent.id) : left_child_of(parent.id);
  node.first = right ? parent.first + left : parent.first;
  node.count = right ? parent.count - left : left;
  node.depth = parent.depth + 1;
  return node;
}

/// Makes nodes in depth-first order. `visit(node, box)` divides a node and may set its bounds.
template <typename Visit>
std::vector<Node> nodes_of(std::size_t triangles, const Range& root_box, const Visit& visit) {
  struct Pending {
    Node node;
    Range box;
    std::uint32_t right_of;  ///< parent, for right children
  };

  Node root;
  root.id = 0;
  root.count = static_cast<std::uint32_t>(triangles);
  std::vector<Node> nodes;
  std::vector<Pending> pending{{root, root_box, Node::kNone}};
  while (!pending.empty()) {
    const auto [start, box, right_of] = pending.back();
    pending.pop_back();
    const auto i = static_cast<std::uint32_t>(nodes.size());
    Node& node = nodes.emplace_back(start);
    const Division division = visit(node, box);
    if (division.divided) {
      pending.push_back({child_of(node, true, division.left), division.boxes[1], i});
      pending.push_back({child_of(node, false, division.left), division.boxes[0], Node::kNone});
      node.left = i + 1;
    }
    if (right_of != Node::kNone) {
      nodes[right_of].right = i;
    }
  }
  return nodes;
}

/// Copies what lies left of the plane to the front of the children's place, the rest to its end.
template <typename IsLeft>
[[gnu::noinline]] std::size_t partition_lists(std::span<const ListItem> list,
                                              std::span<ListItem> children, const IsLeft& is_left) {
  std::size_t left = 0;
  std::size_t right = children.size();
  for (const ListItem& item : list) {
    children[is_left(item) ? left++ : --right] = item;
  }
  return left;
}

Tree build_by_lists(Lists& lists, const RuleParts& rule, const BuildOptions& options,
                    BuildWork& work) {
  const std::size_t triangles = lists.front().size();
  lists.resize(static_cast<std::size_t>(options.level));
  const auto visit = [&](Node& node, const Range& /*box*/) -> Division {
    const auto list = std::span<const ListItem>(lists[node.depth]).subspan(node.first, node.count);
    const Range outer = outer_box_of(list, work);
    node.bounds = outer.box();
    if (node.count <= 1 || static_cast<int>(node.depth) >= options.level - 1) {
      return {};
    }
    const Range needed = rule.soms ? inner_box_of(list, work) : outer;
    std::vector<ListItem>& next = lists[node.depth + std::size_t{1}];
    if (next.size() < triangles) {
      next.resize(triangles);
    }
    const auto children = std::span(next).subspan(node.first, node.count);
    return divide(node, list, needed, rule, options.empty_side, work, [&](const auto& is_left) {
      return Division{.left = partition_lists(list, children, is_left)};
    });
  };
  Tree tree{nodes_of(triangles, {}, visit), std::vector<TriangleId>(triangles)};
  for (const Node& node : tree.nodes) {
    if (node.is_leaf()) {
      const auto list =
          std::span<const ListItem>(lists[node.depth]).subspan(node.first, node.count);
      std::transform(list.begin(), list.end(), tree.primitives.begin() + node.first,
                     [](const ListItem& item) { return item.id; });
    }
  }
  return tree;
}

/// Swaps what lies on the wrong side, and grows the box of each side.
template <typename IsLeft>
[[gnu::noinline]] Division partition_in_place(std::span<Item> run, const RuleParts& rule,
                                              const IsLeft& is_left) {
  const auto least = rule.least;
  const auto greatest = rule.greatest;
  Division division;
  std::size_t left = 0;
  std::size_t right = run.size();
  while (true) {
    for (; left < right && is_left(run[left]); ++left) {
      division.boxes[0].grow(run[left].*least, run[left].*greatest);
    }
    for (; left < right && !is_left(run[right - 1]); --right) {
      division.boxes[1].grow(run[right - 1].*least, run[right - 1].*greatest);
    }
    if (left == right) {
      division.left = left;
      return division;
    }
    std::swap(run[left], run[right - 1]);
  }
}

/// Outer boxes of inner nodes from those of their children.
void merge_up(std::vector<Node>& nodes, BuildWork& work) {
  // Children follow their parents, so the last node comes first.
  for (std::size_t i = nodes.size(); i-- > 0;) {
    Node& node = nodes[i];
    if (!node.is_leaf()) {
      node.bounds = nodes[node.left].bounds;
      node.bounds.grow(nodes[node.right].bounds);
      ++work.merged;
    }
  }
}

Tree build_in_place(std::vector<Item>& items, const RuleParts& rule, const BuildOptions& options,
                    BuildWork& work) {
  const Range root = box_of(items, rule, work);
  const auto visit = [&](Node& node, const Range& box) {
    const auto run = std::span(items).subspan(node.first, node.count);
    Division division;
    if (node.count > 1 && static_cast<int>(node.depth) < options.level - 1) {
      division = divide(node, std::span<const Item>(run), box, rule, options.empty_side, work,
                        [&](const auto& is_left) {
                          rule.grown(work) += run.size();
                          return partition_in_place(run, rule, is_left);
                        });
    }
    if (!rule.soms) {
      node.bounds = box.box();
    } else if (!division.divided) {
      node.bounds = box_of(run, kSpatialMedianParts, work).box();
    }
    return division;
  };
  Tree tree{nodes_of(items.size(), root, visit), std::vector<TriangleId>(items.size())};
  if (rule.soms) {
    merge_up(tree.nodes, work);
  }
  std::transform(items.begin(), items.end(), tree.primitives.begin(),
                 [](const Item& item) { return item.id; });
  return tree;
}

Point point_of(const Vec3& v) {
  return {v.x, v.y, v.z};
}

void prepare(const Mesh& mesh, std::vector<Item>& items) {
  items.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto id = static_cast<TriangleId>(i);
    const Triangle t = mesh.triangle(id);
    const Box box = bounds(t);
    items[i] = {.lower = point_of(box.lower),
                .upper = point_of(box.upper),
                .midpoint = point_of(midpoint(t, Midpoint::thesis)),
                .id = id};
  }
}

void prepare(const Mesh& mesh, std::vector<ListItem>& list) {
  list.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto id = static_cast<TriangleId>(i);
    const Triangle t = mesh.triangle(id);
    list[i] = {.corners = {point_of(t.a), point_of(t.b), point_of(t.c)},
               .midpoint = point_of(midpoint(t, Midpoint::thesis)),
               .id = id};
  }
}

bool is_usable(const BuildOptions& options) {
  BuildOptions usual = thesis_options(options.rule, options.level);
  usual.empty_side = options.empty_side;
  return options == usual && options.level > 0 &&
         (options.rule == Rule::soms || options.rule == Rule::spatial_median);
}

}  // namespace

NeutralBuilder::NeutralBuilder(NeutralWay way, const BuildOptions& options)
    : way_(way), options_(options), lists_(1) {
  if (!is_usable(options)) {
    throw std::logic_error("NeutralBuilder: options that it does not know");
  }
}

Tree NeutralBuilder::build(const Mesh& mesh) {
  const PlainArithmetic plain;
  work_ = {};
  if (mesh.triangles.empty()) {
    return {};
  }
  const RuleParts& rule = options_.rule == Rule::soms ? kSomsParts : kSpatialMedianParts;
  if (way_ == NeutralWay::in_place) {
    prepare(mesh, items_);
    return build_in_place(items_, rule, options_, work_);
  }
  prepare(mesh, lists_.front());
  return build_by_lists(lists_, rule, options_, work_);
}

}  // namespace soms::reproduce
