/// \file
/// Columns of a ground plan that a triangle reaches into.
///
/// Proof. Corners are known to `give` on each axis, and so is every point of a triangle, by its
/// barycentric coordinates. A triangle of many columns is cut into rows of them. A point of a row
/// lies between the row's ends, but for what finding its column and the ends themselves is rounded
/// by: four roundings of at most the mesh's size S. What is left of the triangle between the ends,
/// moved outward by `give` and 2^-45 S, has its least and greatest coordinates at corners and at
/// points on edges; these are p + t (q - p) with t in [0, 1] to three roundings, off by 2^-50 S at
/// most, so intervals are widened by `give` and 2^-45 S, too.
#pragma once

#include "soms/tree/layout/detail/ground_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace soms::layout {

/// A rectangle of columns, first and last along either axis, and the heights of what is in it.
struct ColumnBand {
  std::array<std::uint32_t, 2> from;
  std::array<std::uint32_t, 2> to;
  float lower;
  float upper;

  /// The same of columns of 2^`level`.
  [[nodiscard]] ColumnBand joined(std::uint32_t level) const {
    return {{from[0] >> level, from[1] >> level}, {to[0] >> level, to[1] >> level}, lower, upper};
  }

  /// So few columns that rows of them would be no better.
  [[nodiscard]] bool few() const {
    constexpr std::uint32_t kFew = 64;
    const std::uint32_t columns = to[0] - from[0] + 1;
    const std::uint32_t rows = to[1] - from[1] + 1;
    return columns <= 2 || rows <= 2 || columns * rows <= kFew;
  }
};

/// A float below `x`, for |x| < 2^126.
[[nodiscard]] inline float float_below(double x) {
  return static_cast<float>(x - (0x1p-23 * std::abs(x) + 0x1p-140));
}

[[nodiscard]] inline float float_above(double x) {
  return static_cast<float>(x + (0x1p-23 * std::abs(x) + 0x1p-140));
}

/// Corners along the two axes of the ground plan and the height, each known to `give`.
struct PlanTriangle {
  std::array<std::array<double, 3>, 3> corner;
  double give;
};

/// What lies of a triangle between two places along the second axis.
class TriangleStrip {
 public:
  TriangleStrip(const PlanTriangle& triangle, double begin, double end) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& p = triangle.corner[i];
      const auto& q = triangle.corner[(i + 1) % 3];
      if (begin <= p[1] && p[1] <= end) {
        grow(p[0], p[2]);
      }
      cut(p, q, begin);
      cut(p, q, end);
    }
  }

  [[nodiscard]] bool empty() const { return lower_[0] > upper_[0]; }

  [[nodiscard]] double lower(std::size_t k) const { return lower_[k]; }

  [[nodiscard]] double upper(std::size_t k) const { return upper_[k]; }

 private:
  void grow(double across, double height) {
    lower_ = {std::min(lower_[0], across), std::min(lower_[1], height)};
    upper_ = {std::max(upper_[0], across), std::max(upper_[1], height)};
  }

  void cut(const std::array<double, 3>& p, const std::array<double, 3>& q, double at) {
    if ((p[1] < at) != (q[1] < at)) {
      const double t = (at - p[1]) / (q[1] - p[1]);
      grow(p[0] + t * (q[0] - p[0]), p[2] + t * (q[2] - p[2]));
    }
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  std::array<double, 2> lower_ = {kInfinity, kInfinity};
  std::array<double, 2> upper_ = {-kInfinity, -kInfinity};
};

/// A triangle takes up a quarter of its bounds in the ground plan, or more: it does not stand
/// across it, such as a wall.
[[nodiscard]] inline bool fills_bounds(const PlanTriangle& triangle) {
  const auto& p = triangle.corner;
  const double twice =
      (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
  const auto side = [&](std::size_t k) {
    return std::max({p[0][k], p[1][k], p[2][k]}) - std::min({p[0][k], p[1][k], p[2][k]});
  };
  return 2 * std::abs(twice) >= side(0) * side(1);
}

/// Visits rectangles of columns of 2^`level` that hold the triangle, which `band` holds: each row
/// of it, or `band` alone where the triangle fills it.
template <class Visit>
void for_each_band(const PlanTriangle& triangle, const ColumnBand& band, const GroundPlan& plan,
                   std::uint32_t level, const Visit& visit) {
  if (fills_bounds(triangle)) {
    visit(band);
    return;
  }
  const double outward = triangle.give + plan.rounding;
  const auto begin_of = [&](std::uint32_t row) {
    return plan.begin_of(1, std::uint64_t{row} << level);
  };
  const std::array<std::uint32_t, 2> ends = {band.from[1], band.to[1]};
  for (std::uint32_t row = ends[0]; row <= ends[1]; ++row) {
    // The first and the last column take up what is outside of the plan.
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const TriangleStrip strip(triangle, row == ends[0] ? -kInfinity : begin_of(row) - outward,
                              row == ends[1] ? kInfinity : begin_of(row + 1) + outward);
    if (!strip.empty()) {
      visit(ColumnBand{{plan.column(0, strip.lower(0) - outward) >> level, row},
                       {plan.column(0, strip.upper(0) + outward) >> level, row},
                       float_below(strip.lower(1) - outward),
                       float_above(strip.upper(1) + outward)});
    }
  }
}

}  // namespace soms::layout
