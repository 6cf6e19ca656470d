#include "soms/geometry/detail/crossing.h"

#include "soms/geometry/detail/exact/double_double3.h"
#include "soms/geometry/detail/feature_proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

/// |p| + |q| below this share of the lengths makes an end hard to find.
/// Lengths are within [2^-150, 2^150] (safe_length) and determinants sure, above 2^-44 of three of
/// them: nothing under- or overflows that counts beside 2^-102 of one.
constexpr double kLeastSpan = 0x1p-30;
static_assert(2 * (97 + 48 + 8) * 0x1p-102 / kLeastSpan < 0x1p-60);

/// A triangle against the plane of another.
struct Straddling {
  bool sure = false;
  std::size_t alone = 0;  // the corner on a side of its own
  bool steady = false;    // the ends of both its edges can be found

  Straddling(const Triangle& t, const Triangle& plane) {
    const Vec3 e = plane.b - plane.a;
    const Vec3 f = plane.c - plane.a;
    const Vec3 n = soms::cross(e, f);
    std::array<double, 3> side = {};
    double longest = 0;
    std::size_t above = 0;
    std::size_t last_above = 0;
    std::size_t last_below = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 w = corner(t, i) - plane.a;
      const double lengths = safe_length(e) * safe_length(f) * safe_length(w);
      side[i] = soms::dot(n, w);
      if (!(std::abs(side[i]) > kSureShare * lengths)) {
        return;
      }
      longest = std::max(longest, lengths);
      above += side[i] > 0 ? 1U : 0U;
      (side[i] > 0 ? last_above : last_below) = i;
    }
    if (above == 0 || above == 3) {
      return;
    }
    sure = true;
    alone = above == 1 ? last_above : last_below;
    const double least = std::min(std::abs(side[(alone + 1) % 3]), std::abs(side[(alone + 2) % 3]));
    steady = std::abs(side[alone]) + least > kLeastSpan * longest;
  }
};

/// Where the edge from corner i to corner j of a triangle crosses the plane of another.
DoubleDouble3 crossing_point(const Triangle& t, std::size_t i, std::size_t j,
                             const Triangle& plane) {
  const Vec3& begin = corner(t, i);
  const Vec3& end = corner(t, j);
  const DoubleDouble3 n = cross(difference(plane.b, plane.a), difference(plane.c, plane.a));
  const DoubleDouble p = dot(n, difference(begin, plane.a));
  const DoubleDouble q = dot(n, difference(end, plane.a));
  const DoubleDouble share = p / (p - q);
  const DoubleDouble3 edge = difference(end, begin);
  return {begin.x + share * edge[0], begin.y + share * edge[1], begin.z + share * edge[2]};
}

}  // namespace

std::optional<Vec3> crossing_middle(const Triangle& a, const Triangle& b) {
  const Straddling of_a(a, b);
  if (!of_a.sure || !of_a.steady) {
    return std::nullopt;
  }
  const Straddling of_b(b, a);
  if (!of_b.sure || !of_b.steady) {
    return std::nullopt;
  }
  // Edge k of a, from the corner alone on, passes edge m of b, likewise, on the positive side.
  std::array<std::array<bool, 2>, 2> passes = {};
  const Vec3& tip_a = corner(a, of_a.alone);
  const Vec3& tip_b = corner(b, of_b.alone);
  const Vec3 r = tip_b - tip_a;
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3 e = corner(a, (of_a.alone + 1 + k) % 3) - tip_a;
    for (std::size_t m = 0; m < 2; ++m) {
      const Vec3 f = corner(b, (of_b.alone + 1 + m) % 3) - tip_b;
      const double volume = soms::dot(soms::cross(e, f), r);
      if (!(std::abs(volume) > kSureShare * (safe_length(e) * safe_length(f) * safe_length(r)))) {
        return std::nullopt;
      }
      passes[k][m] = volume > 0;
    }
  }
  DoubleDouble3 sum = {};
  std::size_t ends = 0;
  const auto add = [&](const DoubleDouble3& p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sum[axis] = sum[axis] + p[axis];
    }
    ++ends;
  };
  for (std::size_t k = 0; k < 2; ++k) {
    if (passes[k][0] != passes[k][1]) {
      add(crossing_point(a, of_a.alone, (of_a.alone + 1 + k) % 3, b));
    }
    if (passes[0][k] != passes[1][k]) {
      add(crossing_point(b, of_b.alone, (of_b.alone + 1 + k) % 3, a));
    }
  }
  if (ends != 2) {
    return std::nullopt;
  }
  const auto half = [](const DoubleDouble& x) { return (x * 0.5).high; };
  return Vec3{half(sum[0]), half(sum[1]), half(sum[2])};
}

}  // namespace soms::detail
