#include "soms/query/reference/winding.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/orientation.h"
#include "soms/query/reference/detail/moved_triangles.h"
#include "soms/query/reference/detail/point_on_triangle.h"

#include <array>
#include <cmath>
#include <limits>

namespace soms::reference {

namespace {

using Long = long double;

constexpr Long kLongUnit = std::numeric_limits<Long>::epsilon() / 2;
constexpr Long kLongPi = 3.14159265358979323846264338327950288L;

/// A vector from the point to a corner: each coordinate is rounded once.
struct Arm {
  Arm(const Vec3& corner, const Vec3& point)
      : x(Long(corner.x) - point.x), y(Long(corner.y) - point.y), z(Long(corner.z) - point.z) {
    length = std::sqrt((x * x + y * y) + z * z);
  }

  Long x, y, z;
  Long length;
};

Long dot(const Arm& a, const Arm& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/// A sum of solid angles over 4 pi, and how far it may be off.
struct WindingSum {
  Long value = 0;
  Long error = 0;
  Long halves = 0;  // triangles of which nothing is known but that they add -1/2 to 1/2

  void add(const Triangle& t, const Vec3& p);
};

void WindingSum::add(const Triangle& t, const Vec3& p) {
  if (detail::is_on(t, p)) {
    ++halves;
    return;
  }
  const Arm a(t.a, p);
  const Arm b(t.b, p);
  const Arm c(t.c, p);
  Long volume = (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z)) +
                a.z * (b.x * c.y - b.y * c.x);
  const Long product = a.length * b.length * c.length;
  const Long rest =
      (product + dot(a, b) * c.length) + (dot(b, c) * a.length + dot(c, a) * b.length);
  // Of four terms each is off by at most 12 units; the absolute values of the volume's add up to
  // `product` at most, by Cauchy and Binet, and each is off by 8.
  const Long off = 64 * kLongUnit * product;
  const Long size = std::hypot(volume, rest);
  // Where a product of lengths underflows, or is not a number, nothing is known either.
  if (!(size > 16 * off && off >= std::numeric_limits<Long>::min())) {
    ++halves;
    return;
  }
  if (rest < 0 && std::abs(volume) <= off) {
    const Sign side = orientation(t.a, t.b, t.c, p);
    volume = std::copysign(0.0L, side == Sign::negative ? 1.0L : -1.0L);
  }
  value += std::atan2(volume, rest) / (2 * kLongPi);
  error += (1.01L * off / size) / (2 * kLongPi) + 16 * kLongUnit;
}

Bracket bracket_of(const WindingSum& sum, std::size_t terms) {
  const Long rounding = 2 * static_cast<Long>(terms) * kLongUnit * static_cast<Long>(terms);
  const Long error = (sum.error * (1 + 0x1p-20L) + rounding) + sum.halves / 2;
  return {std::nextafter(static_cast<double>(sum.value - error),
                         -std::numeric_limits<double>::infinity()),
          std::nextafter(static_cast<double>(sum.value + error),
                         std::numeric_limits<double>::infinity())};
}

}  // namespace

Bracket winding_by_brute_force(const Body& body, const Vec3& point) {
  return winding_by_brute_force(body, std::span(&point, 1))[0];
}

std::vector<Bracket> winding_by_brute_force(const Body& body, std::span<const Vec3> points) {
  const PlainArithmetic plain;
  const std::vector<Triangle> triangles = detail::moved_triangles(body.shape.mesh(), body.pose);
  std::vector<Bracket> brackets;
  for (const Vec3& point : points) {
    WindingSum sum;
    for (const Triangle& t : triangles) {
      sum.add(t, point);
    }
    brackets.push_back(bracket_of(sum, triangles.size()));
  }
  return brackets;
}

}  // namespace soms::reference
