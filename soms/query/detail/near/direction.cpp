#include "soms/query/detail/near/direction.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

Vec3 scaled(const Vec3& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

/// The exponent of a power of two by which `v` is to be divided before its entries are squared: 0
/// where neither the squares nor their rounding underflow as it is, and none overflows.
int exponent_of(const Vec3& v) {
  const double most = largest(v);
  return most == 0 || (most > 0x1p-450 && most < 0x1p450) ? 0 : std::ilogb(most);
}

}  // namespace

double largest(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double length(const Vec3& v) {
  const int exponent = exponent_of(v);
  const Vec3 usual = exponent == 0 ? v : scaled(v, -exponent);
  const double root = std::sqrt(dot(usual, usual));
  return exponent == 0 ? root : std::ldexp(root, exponent);
}

Vec3 direction(const Vec3& v) {
  if (largest(v) == 0) {
    return {1, 0, 0};
  }
  const int exponent = exponent_of(v);
  const Vec3 usual = exponent == 0 ? v : scaled(v, -exponent);
  return usual * (1 / length(usual));
}

}  // namespace soms::detail
