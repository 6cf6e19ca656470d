#include "soms/scene/detail/box_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

// Relative errors are in units of u = 2^-53. Underflow adds less than 2^-1074 to a product or
// quotient; sums and differences have none.

/// A gap is off by 1, its square by 2 + 1, a sum of three by 2 more. What is taken off rounds by 1
/// twice, so 8 is enough where the exact square is at least 5 less.
constexpr double kSquareShrink = 1 - 0x1p-50;
static_assert(5 + 1 + 1 < 8);
/// More than the squares and the product with the shrinking factor lose to underflow: 4 * 2^-1074.
constexpr double kSquareUnderflow = 0x1p-1070;
/// The root and this product round by 1 each.
constexpr double kRootShrink = 1 - 0x1p-51;
static_assert(1 + 1 < 4);

/// A difference of coordinates is off by 1, that of a segment's ends, too, their quotient by 1, so
/// a quotient by 3; the margin rounds by 1. It stands for the errors of both quotients: where a ray
/// enters gives way to where it leaves.
constexpr double kQuotientMargin = 0x1p-50;
constexpr double kQuotientUnderflow = 0x1p-1070;
static_assert(3 + 3 + 1 < 8);

constexpr double kLargest = std::numeric_limits<double>::max();

}  // namespace

double distance_at_least(const Vec3& point, const Box& box) {
  return distance_at_least(Box{point, point}, box);
}

double distance_at_least(const Box& a, const Box& b) {
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double gap =
        std::max({0.0, b.lower[axis] - a.upper[axis], a.lower[axis] - b.upper[axis]});
    square += gap * gap;
  }
  return std::sqrt(std::max(square * kSquareShrink - kSquareUnderflow, 0.0)) * kRootShrink;
}

double entry_at_least(const Vec3& origin, const Vec3& direction, const Box& box) {
  double enter = 0;
  double leave = kNoEntry;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double to_lower = box.lower[axis] - origin[axis];
    const double to_upper = box.upper[axis] - origin[axis];
    if (direction[axis] == 0) {
      if (to_lower > 0 || to_upper < 0) {
        return kNoEntry;
      }
      continue;
    }
    const bool ascends = direction[axis] > 0;
    // A quotient may overflow where t itself does not.
    const double near =
        std::clamp((ascends ? to_lower : to_upper) / direction[axis], -kLargest, kLargest);
    enter = std::max(enter, near - (std::abs(near) * kQuotientMargin + kQuotientUnderflow));
    leave = std::min(leave, (ascends ? to_upper : to_lower) / direction[axis]);
  }
  return enter <= leave ? enter : kNoEntry;
}

}  // namespace soms::detail
