#include "soms/tree/build/detail/divide.h"

#include "soms/tree/tree.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace soms::detail {

namespace {

/// Stable: both sides keep their order. Returns the number of primitives on the left.
std::uint32_t partition(std::span<Primitive> run, std::span<Primitive> scratch,
                        const Split& split) {
  std::size_t left = 0;
  std::size_t right = 0;
  for (const Primitive& p : run) {
    if (split.is_left(p)) {
      run[left++] = p;
    } else {
      scratch[right++] = p;
    }
  }
  std::copy_n(scratch.begin(), right, run.begin() + static_cast<std::ptrdiff_t>(left));
  return static_cast<std::uint32_t>(left);
}

}  // namespace

Divider::Divider(const BuildOptions& options)
    : options_(options),
      rule_(entry(options.rule).split),
      axis_from_(options.axis_from.value_or(entry(options.rule).axis_from)),
      last_depth_(options.level == 0
                      ? std::numeric_limits<std::uint32_t>::max()
                      : static_cast<std::uint32_t>(options.level - options.root_level)) {
}

Primitive Divider::primitive(const Mesh& mesh, TriangleId i) const {
  const Triangle t = mesh.triangle(i);
  return {bounds(t), midpoint(t, options_.midpoint, options_.c_vertex), i};
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
  const Vec3 extent = (axis_from_ == AxisFrom::inner ? node.inner : node.outer).extent();
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return extent[a] > extent[b]; });
  return order;
}

Division Divider::divide(std::span<Primitive> run, std::span<Primitive> scratch,
                         std::uint32_t depth) const {
  if (is_leaf(run.size(), depth)) {
    return {};
  }
  SplitNode node{run, {}, {}};
  for (const Primitive& p : run) {
    node.outer.grow(p.bounds);
    node.inner.grow(p.midpoint);
  }
  const auto order = axes(node);
  const auto halve = [&] { return partition(run, scratch, rule::object_median(node, order[0])); };
  if (too_deep(run.size(), depth)) {
    return {true, false, halve()};
  }
  const auto count = static_cast<std::uint32_t>(run.size());
  const std::size_t tries = options_.empty_side == EmptySide::next_axis ? order.size() : 1;
  std::uint32_t left = 0;
  for (std::size_t k = 0; k < tries; ++k) {
    left = partition(run, scratch, rule_(node, order[k]));
    if (left > 0 && left < count) {
      return {true, false, left};
    }
  }
  switch (options_.empty_side) {
    case EmptySide::object_median:
      return {true, true, halve()};
    case EmptySide::chain:
      return {true, true, left};
    default:
      return {false, true, 0};
  }
}

}  // namespace soms::detail
