#include "soms/tree/build/detail/divide.h"

#include "soms/tree/tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace soms::detail {

namespace {

/// Bounds that grow by arrays, which compilers turn into vector instructions.
struct Range {
  std::array<double, 3> lower = filled(std::numeric_limits<double>::infinity());
  std::array<double, 3> upper = filled(-std::numeric_limits<double>::infinity());

  static constexpr std::array<double, 3> filled(double x) { return {x, x, x}; }

  void grow(const std::array<double, 3>& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      lower[k] = p[k] < lower[k] ? p[k] : lower[k];
      upper[k] = p[k] > upper[k] ? p[k] : upper[k];
    }
  }

  [[nodiscard]] Box box() const {
    return {{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}};
  }
};

Division division_of(std::size_t left, std::size_t count, const std::array<Range, 2>& inner) {
  return {left > 0 && left < count, false, static_cast<std::uint32_t>(left), inner[0].box(),
          inner[1].box()};
}

/// Swaps what lies on the wrong side; the order on each side is lost.
Division partition_in_place(std::span<Primitive> run, const Split& split) {
  std::array<Range, 2> inner;
  std::size_t left = 0;
  std::size_t right = run.size();
  while (true) {
    for (; left < right && split.is_left(run[left]); ++left) {
      inner[0].grow(run[left].midpoint);
    }
    for (; left < right && !split.is_left(run[right - 1]); --right) {
      inner[1].grow(run[right - 1].midpoint);
    }
    if (left == right) {
      return division_of(left, run.size(), inner);
    }
    std::swap(run[left], run[right - 1]);
  }
}

/// Both sides keep their order.
Division partition_in_order(std::span<Primitive> run, const Split& split) {
  std::array<Range, 2> inner;
  std::vector<Primitive> right_side;
  std::size_t left = 0;
  for (const Primitive& p : run) {
    if (split.is_left(p)) {
      inner[0].grow(p.midpoint);
      run[left++] = p;
    } else {
      inner[1].grow(p.midpoint);
      right_side.push_back(p);
    }
  }
  std::copy(right_side.begin(), right_side.end(), run.begin() + static_cast<std::ptrdiff_t>(left));
  return division_of(left, run.size(), inner);
}

double largest(const Vec3& v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace

Divider::Divider(const MeshView& mesh, const RuleEntry& rule, const BuildOptions& options)
    : mesh_(mesh),
      options_(options),
      rule_(rule),
      axis_from_(options.axis_from.value_or(rule.axis_from)),
      last_depth_(options.level == 0
                      ? std::numeric_limits<std::uint32_t>::max()
                      : static_cast<std::uint32_t>(options.level - options.root_level)) {
  const double size = largest(bounds(mesh).extent());
  unit_ = size > 0 ? std::ldexp(1.0, std::ilogb(size)) : 1;
  if (axis_from_ == AxisFrom::outer || rule.needs_outer) {
    bounds_.resize(mesh.triangles.size());
  }
}

Box Divider::prepare(std::size_t begin, std::size_t end, std::span<Primitive> primitives) {
  Range inner;
  for (std::size_t i = begin; i < end; ++i) {
    const Triangle t = mesh_.triangle(static_cast<TriangleId>(i));
    const Box box = bounds(t);
    const Vec3 m = midpoint(t, options_.midpoint, options_.c_vertex);
    Primitive p;
    p.midpoint = {m.x, m.y, m.z};
    p.id = static_cast<TriangleId>(i);
    for (std::size_t k = 0; k < 3; ++k) {
      p.below[k] = static_cast<float>((m[k] - box.lower[k]) / unit_);
      p.above[k] = static_cast<float>((box.upper[k] - m[k]) / unit_);
    }
    primitives[i] = p;
    inner.grow(p.midpoint);
    if (!bounds_.empty()) {
      bounds_[i] = box;
    }
  }
  return inner.box();
}

bool Divider::is_leaf(std::size_t count, std::uint32_t depth) const {
  return count <= static_cast<std::size_t>(options_.per_leaf) || depth >= last_depth_;
}

// A rule may split off one primitive at each level, for as many levels as there are powers of two
// among doubles: time and depth would grow to n * 1000. Halving the count from here on ends at
// kMaxTreeIdDepth. With a level limit the depth is bounded already, and the counts of the thesis
// must not change.
bool Divider::too_deep(std::size_t count, std::uint32_t depth) const {
  return options_.level == 0 && options_.empty_side == EmptySide::object_median &&
         depth + static_cast<std::uint32_t>(std::bit_width(count - 1)) >= kMaxTreeIdDepth;
}

/// By decreasing extent; of equal ones x before y before z.
std::array<std::size_t, 3> Divider::axes(const SplitNode& node) const {
  const Vec3 v = (axis_from_ == AxisFrom::inner ? node.inner : node.outer).extent();
  const std::array<double, 3> extent{v.x, v.y, v.z};
  std::array<std::size_t, 3> order{0, 1, 2};
  const auto swap_if_less = [&](std::size_t i, std::size_t j) {
    if (extent[order[i]] < extent[order[j]]) {
      std::swap(order[i], order[j]);
    }
  };
  swap_if_less(0, 1);
  swap_if_less(1, 2);
  swap_if_less(0, 1);
  return order;
}

Division Divider::partition(std::span<Primitive> run, const Split& split) const {
  return rule_.needs_order ? partition_in_order(run, split) : partition_in_place(run, split);
}

Division Divider::divide(std::span<Primitive> run, const Box& inner, std::uint32_t depth) const {
  if (is_leaf(run.size(), depth)) {
    return {};
  }
  SplitNode node{run, inner, {}, unit_};
  if (!bounds_.empty()) {
    for (const Primitive& p : run) {
      node.outer.grow(bounds_[p.id]);
    }
  }
  const auto order = axes(node);
  if (too_deep(run.size(), depth)) {
    return partition(run, rule::object_median(node, order[0]));
  }
  const std::size_t tries = options_.empty_side == EmptySide::next_axis ? order.size() : 1;
  Division division;
  for (std::size_t k = 0; k < tries && !division.divided; ++k) {
    division = partition(run, rule_.split(node, order[k]));
  }
  if (division.divided) {
    return division;
  }
  if (options_.empty_side == EmptySide::object_median) {
    division = partition(run, rule::object_median(node, order[0]));
  }
  division.divided =
      options_.empty_side == EmptySide::object_median || options_.empty_side == EmptySide::chain;
  division.undividable = true;
  return division;
}

}  // namespace soms::detail
