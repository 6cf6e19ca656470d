#include "soms/geometry/triangle_distance.h"

#include "soms/geometry/detail/pair_distance.h"

#include <array>

namespace soms {

TriangleDistance triangle_distance(const Triangle& a, const Triangle& b) {
  detail::PairDistance pair(a, b);
  const Bracket bracket = pair.distance();
  const std::array<Vec3, 2> points = pair.points();
  return {bracket, points[0], points[1]};
}

bool triangles_within(const Triangle& a, const Triangle& b, double distance) {
  detail::PairDistance pair(a, b);
  return pair.compare(distance) <= 0;
}

}  // namespace soms
