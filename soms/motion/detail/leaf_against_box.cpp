#include "soms/motion/detail/leaf_against_box.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

/// Middle and half length of what a direction sees of a box or a triangle.
struct Seen {
  double middle = 0;
  double radius = 0;

  Seen(const Vec3& n, const SweptBoxes& box, std::size_t lane) : middle(dot(n, box.center[lane])) {
    for (std::size_t k = 0; k < 3; ++k) {
      radius += std::abs(dot(n, box.axis[k])) * box.half[lane][k];
    }
  }

  Seen(const Vec3& n, const Corners& c) {
    const auto [least, most] = std::minmax({dot(n, c[0]), dot(n, c[1]), dot(n, c[2])});
    middle = (least + most) / 2;
    radius = (most - least) / 2;
  }
};

void narrow_along(const Seen& x, const Seen& y, double change, double reach, TimeWindow& window) {
  window.narrow(y.middle - x.middle, change, x.radius + y.radius + reach);
}

}  // namespace

TimeWindow window_of(const SweptBoxes& x, std::size_t lane, const Corners& y, double margin) {
  TimeWindow window;
  const auto look_along = [&](const Vec3& n) {
    narrow_along(Seen(n, x, lane), Seen(n, y), dot(n, x.change[lane]), x.give[lane] + margin,
                 window);
    return !window.empty();
  };
  if (look_along(sides_of(y).normal)) {
    static_cast<void>(look_along(x.direction[0]) && look_along(x.direction[1]) &&
                      look_along(x.direction[2]));
  }
  return window;
}

TimeWindow window_of(const SweptTriangle& x, const SweptBoxes& y, std::size_t lane, double margin) {
  TimeWindow window;
  const auto look_along = [&](const Vec3& n) {
    narrow_along(Seen(n, x.corners), Seen(n, y, lane), dot(n, x.change), x.give + margin, window);
    return !window.empty();
  };
  if (look_along(x.sides.normal)) {
    static_cast<void>(look_along(y.direction[0]) && look_along(y.direction[1]) &&
                      look_along(y.direction[2]));
  }
  return window;
}

}  // namespace soms::detail
