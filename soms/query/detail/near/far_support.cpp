#include "soms/query/detail/near/far_support.h"

#include <algorithm>

namespace soms::detail {

namespace {

double largest(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

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

Vec3 place_of(const PosedShape& side, const std::array<double, 3>& origin) {
  return side.pose->apply(side.layout().origin() + Vec3{origin[0], origin[1], origin[2]});
}

std::array<float, 3> seen(const Pose& pose, const Vec3& w, const layout::Axes& axes) {
  const Matrix3 r = rotation(pose);
  std::array<double, 3> v = {};
  for (std::size_t j = 0; j < 3; ++j) {
    v[j] = (r[0][j] * w.x + r[1][j] * w.y) + r[2][j] * w.z;
  }
  std::array<float, 3> turned = {};
  for (std::size_t j = 0; j < 3; ++j) {
    turned[j] = static_cast<float>((axes[j] * v[0] + axes[3 + j] * v[1]) + axes[6 + j] * v[2]);
  }
  return turned;
}

std::array<float, WideNode::kWidth> supports(const WideNode& node, const std::array<float, 3>& w,
                                             float sign) {
  std::array<float, WideNode::kWidth> least = {};
  for (std::size_t k = 0; k < WideNode::kWidth; ++k) {
    const float center =
        (w[0] * node.center[0][k] + w[1] * node.center[1][k]) + w[2] * node.center[2][k];
    const float radius = (std::abs(w[0]) * node.half[0][k] + std::abs(w[1]) * node.half[1][k]) +
                         std::abs(w[2]) * node.half[2][k];
    least[k] = sign * center - radius;
  }
  return least;
}

}  // namespace soms::detail
