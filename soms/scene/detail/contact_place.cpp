#include "soms/scene/detail/contact_place.h"

#include "soms/base/common_box.h"
#include "soms/geometry/common_points.h"

#include <limits>

namespace soms::detail {

namespace {

Box common_box_of(const std::pair<Triangle, Triangle>& pair) {
  return common_box(bounds(pair.first), bounds(pair.second));
}

double square_of_distance(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return d.x * d.x + d.y * d.y + d.z * d.z;
}

/// Their set is convex, so it holds the mean of its corners.
Vec3 middle_of(const CommonPoints& crossing) {
  Vec3 sum;
  for (const Vec3& corner : crossing.points()) {
    sum = sum + corner;
  }
  return sum * (1 / static_cast<double>(crossing.count));
}

}  // namespace

ContactPlace contact_place(std::span<const std::pair<Triangle, Triangle>> pairs) {
  ContactPlace place;
  for (const auto& pair : pairs) {
    place.box.grow(common_box_of(pair));
  }
  const Vec3 middle = place.box.center();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double here = square_of_distance(common_box_of(pairs[k]).center(), middle);
    if (here < least) {
      least = here;
      place.pair = k;
    }
  }
  const auto& [first, second] = pairs[place.pair];
  const CommonPoints common = common_points(first, second);
  // Only where triangles were given that do not touch.
  place.point = common.empty() ? common_box_of(pairs[place.pair]).center() : middle_of(common);
  return place;
}

}  // namespace soms::detail
