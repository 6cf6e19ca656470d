#include "soms/query/reference/contains.h"

#include "soms/base/arithmetic.h"
#include "soms/base/random.h"
#include "soms/geometry/orientation.h"
#include "soms/query/reference/detail/moved_triangles.h"
#include "soms/query/reference/detail/point_on_triangle.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace soms::reference {

namespace {

/// What a segment in general position does with a triangle.
enum class Meeting { miss, cross, special };

bool has_area(const Triangle& t) {
  return orientation2d(t.a, t.b, t.c, Projection::xy) != Sign::zero ||
         orientation2d(t.a, t.b, t.c, Projection::yz) != Sign::zero ||
         orientation2d(t.a, t.b, t.c, Projection::zx) != Sign::zero;
}

/// \pre `p` is not a point of the triangle.
Meeting meet(const Triangle& t, const Vec3& p, const Vec3& q) {
  const Sign from = orientation(t.a, t.b, t.c, p);
  const Sign to = orientation(t.a, t.b, t.c, q);
  if (from == to && from != Sign::zero) {
    return Meeting::miss;
  }
  if (to == Sign::zero) {
    return has_area(t) ? Meeting::special : Meeting::miss;
  }
  if (from == Sign::zero) {
    return Meeting::miss;  // the segment leaves the plane off the triangle
  }
  const Sign ab = orientation(p, q, t.a, t.b);
  const Sign bc = orientation(p, q, t.b, t.c);
  const Sign ca = orientation(p, q, t.c, t.a);
  if (ab != Sign::zero && ab == bc && bc == ca) {
    return Meeting::cross;
  }
  const auto any = [&](Sign s) { return ab == s || bc == s || ca == s; };
  return any(Sign::negative) && any(Sign::positive) ? Meeting::miss : Meeting::special;
}

/// A body's triangles, and where they end.
class PointScan {
 public:
  explicit PointScan(const Body& body)
      : triangles_(detail::moved_triangles(body.shape.mesh(), body.pose)) {
    for (const Triangle& t : triangles_) {
      box_.grow(bounds(t));
    }
  }

  [[nodiscard]] Side side(const Vec3& p) const {
    if (!overlaps(box_, Box{p, p})) {
      return Side::outside;
    }
    if (std::any_of(triangles_.begin(), triangles_.end(),
                    [&](const Triangle& t) { return detail::is_on(t, p); })) {
      return Side::on;
    }
    Rng rng(1);
    for (;;) {
      if (const std::optional<bool> odd = odd_crossings(p, beyond(rng))) {
        return *odd ? Side::inside : Side::outside;
      }
    }
  }

 private:
  /// A point off the box, somewhere beyond its upper corner.
  [[nodiscard]] Vec3 beyond(Rng& rng) const {
    const Vec3 extent = box_.extent();
    Vec3 q;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double far = std::max({std::abs(box_.lower[axis]), std::abs(box_.upper[axis])});
      const double step = std::max({extent.x, extent.y, extent.z, far * 0x1p-40, 0x1p-1000});
      q[axis] = box_.upper[axis] + step * rng.uniform(1, 3);
    }
    return q;
  }

  /// Nothing where the segment is not in general position.
  [[nodiscard]] std::optional<bool> odd_crossings(const Vec3& p, const Vec3& q) const {
    bool odd = false;
    for (const Triangle& t : triangles_) {
      const Meeting meeting = meet(t, p, q);
      if (meeting == Meeting::special) {
        return std::nullopt;
      }
      odd = odd != (meeting == Meeting::cross);
    }
    return odd;
  }

  std::vector<Triangle> triangles_;
  Box box_;
};

}  // namespace

Side contains_by_brute_force(const Body& body, const Vec3& point) {
  return contains_by_brute_force(body, std::span(&point, 1))[0];
}

std::vector<Side> contains_by_brute_force(const Body& body, std::span<const Vec3> points) {
  const PlainArithmetic plain;
  const PointScan scan(body);
  std::vector<Side> sides;
  for (const Vec3& point : points) {
    sides.push_back(scan.side(point));
  }
  return sides;
}

}  // namespace soms::reference
