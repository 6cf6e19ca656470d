#include "soms/geometry/detail/exact/newell.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

/// Newell normal of the corners relative to the first, scaled by a power of two so that products
/// neither overflow nor vanish.
Vec3 newell_normal(std::span<const Vec3> corners) {
  double reach = 0;
  for (const Vec3& p : corners) {
    const Vec3 d = p - corners[0];
    reach = std::max({reach, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  if (reach == 0) {
    return {};
  }
  const int exponent = -std::ilogb(reach);
  const auto relative = [&](const Vec3& p) {
    const Vec3 d = p - corners[0];
    return Vec3{std::ldexp(d.x, exponent), std::ldexp(d.y, exponent), std::ldexp(d.z, exponent)};
  };
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += cross(relative(corners[i]), relative(corners[i + 1]));
  }
  return sum;
}

}  // namespace

PolygonPlane polygon_plane(std::span<const Vec3> corners) {
  const Vec3 normal = newell_normal(corners);
  std::size_t axis = 2;
  for (const std::size_t other : {std::size_t{0}, std::size_t{1}}) {
    if (std::abs(normal[other]) > std::abs(normal[axis])) {
      axis = other;
    }
  }
  return {.projection = axis == 2   ? Projection::xy
                        : axis == 0 ? Projection::yz
                                    : Projection::zx,
          .first_axis = (axis + 1) % 3,
          .second_axis = (axis + 2) % 3,
          .reversed = normal[axis] < 0};
}

}  // namespace soms::detail
