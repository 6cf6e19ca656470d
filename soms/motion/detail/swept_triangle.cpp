#include "soms/motion/detail/swept_triangle.h"

#include <algorithm>
#include <cstddef>

namespace soms::detail {

namespace {

constexpr std::array<Vec3, 3> kAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// Least and greatest product of a direction with corners.
struct Span {
  double lower;
  double upper;

  Span(const Vec3& n, const Corners& c) {
    const auto [least, most] = std::minmax({dot(n, c[0]), dot(n, c[1]), dot(n, c[2])});
    lower = least;
    upper = most;
  }
};

void narrow_along(const Vec3& n, const SweptTriangle& x, const Corners& y, double reach,
                  TimeWindow& window) {
  const Span moving(n, x.corners);
  const Span resting(n, y);
  const double apart = (resting.lower + resting.upper) / 2 - (moving.lower + moving.upper) / 2;
  const double radius = (resting.upper - resting.lower) / 2 + (moving.upper - moving.lower) / 2;
  window.narrow(apart, dot(n, x.change), radius + reach);
}

}  // namespace

SweptTriangle swept_triangle(const Triangle& body, const MotionBounds& bounds,
                             const MotionInterval& interval) {
  SweptTriangle swept;
  swept.body = body;
  std::array<Vec3, 3> changes;
  double arm = 0;
  const Corners corners = corners_of(body);
  for (std::size_t k = 0; k < 3; ++k) {
    swept.corners[k] = mapped(interval.mean, corners[k]);
    changes[k] = mapped(interval.change, corners[k]);
    arm = std::max(arm, bounds.law().arm(corners[k]));
  }
  swept.sides = sides_of(swept.corners);
  swept.change = (changes[0] + changes[1] + changes[2]) * (1.0 / 3);
  for (const Vec3& change : changes) {
    swept.give = std::max(swept.give, length_of(change - swept.change));
  }
  swept.give = (swept.give + interval.bow.of(arm)) * kMotionUp;
  return swept;
}

TimeWindow window_of(const SweptTriangle& x, const Corners& y, const TriangleSides& sides,
                     double margin) {
  TimeWindow window;
  const double reach = x.give + margin;
  for (const Vec3& n : kAxes) {
    narrow_along(n, x, y, reach, window);
  }
  if (window.empty()) {
    return window;
  }
  for_separating_directions(x.sides, sides, [&](const Vec3& n) {
    narrow_along(n, x, y, reach, window);
    return !window.empty();
  });
  return window;
}

}  // namespace soms::detail
