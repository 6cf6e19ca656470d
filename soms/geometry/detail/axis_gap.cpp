#include "soms/geometry/detail/axis_gap.h"

#include "soms/geometry/detail/feature_pair.h"
#include "soms/geometry/triangle_overlap.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace soms::detail {

namespace {

using Axis = double Vec3::*;

constexpr std::array<Axis, 3> kAxes = {&Vec3::x, &Vec3::y, &Vec3::z};

double least(const Triangle& t, Axis axis) {
  return std::min({t.a.*axis, t.b.*axis, t.c.*axis});
}

double greatest(const Triangle& t, Axis axis) {
  return std::max({t.a.*axis, t.b.*axis, t.c.*axis});
}

/// The corners of `t` at `level` of the axis, seen along it: a point, a segment or a triangle.
Triangle seen_at(const Triangle& t, Axis axis, double level) {
  std::array<Vec3, 3> corners = {};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (corner(t, i).*axis == level) {
      corners[count] = corner(t, i);
      corners[count++].*axis = 0;
    }
  }
  for (std::size_t i = count; i < 3; ++i) {
    corners[i] = corners[0];
  }
  return {corners[0], corners[1], corners[2]};
}

}  // namespace

std::optional<DoubleDouble> axis_gap(const Triangle& a, const Triangle& b,
                                     const DoubleDouble& lower, const DoubleDouble& upper) {
  for (const Axis axis : kAxes) {
    const bool a_above = least(a, axis) > greatest(b, axis);
    if (!a_above && !(least(b, axis) > greatest(a, axis))) {
      continue;
    }
    const double level_a = a_above ? least(a, axis) : greatest(a, axis);
    const double level_b = a_above ? greatest(b, axis) : least(b, axis);
    const DoubleDouble gap = a_above ? two_sum(level_a, -level_b) : two_sum(level_b, -level_a);
    if (gap < lower || gap > upper) {
      continue;
    }
    if (triangles_overlap(seen_at(a, axis, level_a), seen_at(b, axis, level_b))) {
      return gap;
    }
  }
  return std::nullopt;
}

}  // namespace soms::detail
