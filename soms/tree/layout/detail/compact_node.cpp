#include "soms/tree/layout/detail/compact_node.h"

#include "soms/tree/layout/detail/frame.h"

#include <cmath>

namespace soms {

namespace {

constexpr int kMost = 127;

/// Least step of 15 bits with at most kMost of them to `far`. Below 2^-100 it stays at that, so
/// that half a step is no subnormal number; boxes may grow by so little.
float step_for(double far) {
  const double least = std::max(far / kMost, 0x1p-100);
  const int exponent = std::ilogb(least) - 14;
  const auto step =
      static_cast<float>(std::ldexp(std::ceil(std::ldexp(least, -exponent)), exponent));
  // The quotient was rounded, perhaps down.
  return kMost * static_cast<double>(step) >= far
             ? step
             : static_cast<float>(static_cast<double>(step) + std::ldexp(1.0, exponent));
}

/// Greatest number of steps not above `x`. Products with a step are exact, quotients are not.
std::int8_t steps_below(double x, double step) {
  double n = std::floor(x / step);
  n -= n * step > x ? 1 : 0;
  return static_cast<std::int8_t>(n);
}

}  // namespace

CompactNode::CompactNode(const WideNode& from)
    : child(from.child),
      origin(from.origin),
      axes(from.axes()),
      count(from.count),
      leaves(from.leaves),
      oriented(from.oriented) {
  std::array<double, kWidth> distance = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto side = [&](std::size_t k, double sign) {
      return static_cast<double>(from.center[axis][k]) +
             sign * static_cast<double>(from.half[axis][k]);
    };
    double far = 0;
    for (std::size_t k = 0; k < count; ++k) {
      far = std::max({far, -side(k, -1), side(k, 1)});
    }
    step[axis] = step_for(far);
    for (std::size_t k = 0; k < count; ++k) {
      const double unit = step[axis];
      lower[axis][k] = steps_below(side(k, -1), unit);
      upper[axis][k] = static_cast<std::int8_t>(-steps_below(-side(k, 1), unit));
      distance[k] += unit * std::max(-lower[axis][k], +upper[axis][k]);
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    l1_radius = std::max(l1_radius, layout::rounded_up(distance[k] * (1 + 0x1p-50)));  // two sums
  }
}

void CompactNode::read(WideNode& node) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float half_step = 0.5F * step[axis];
    int far = 0;
    for (std::size_t k = 0; k < kWidth; ++k) {
      const int low = lower[axis][k];   // NOLINT(bugprone-signed-char-misuse): numbers
      const int high = upper[axis][k];  // NOLINT(bugprone-signed-char-misuse)
      node.center[axis][k] = static_cast<float>(low + high) * half_step;
      node.half[axis][k] = static_cast<float>(high - low) * half_step;
      far = std::max({far, -low, high});
    }
    node.row[axis] = {axes[3 * axis], axes[3 * axis + 1], axes[3 * axis + 2],
                      static_cast<float>(far) * step[axis]};
  }
  node.child = child;
  node.origin = origin;
  node.l1_radius = l1_radius;
  node.count = count;
  node.leaves = leaves;
  node.oriented = oriented;
}

}  // namespace soms
