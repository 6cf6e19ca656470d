#include "soms/geometry/point_distance.h"

#include "soms/geometry/detail/point_to_triangle.h"

namespace soms {

PointDistance point_distance(const Vec3& point, const Triangle& triangle) {
  detail::PointToTriangle pair(point, triangle);
  return {pair.distance(), pair.nearest(), pair.feature()};
}

}  // namespace soms
