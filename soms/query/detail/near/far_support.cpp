#include "soms/query/detail/near/far_support.h"

#include <cmath>

namespace soms::detail {

Vec3 place_of(const PosedShape& side, const std::array<double, 3>& origin) {
  return side.pose->apply(side.layout().origin() + Vec3{origin[0], origin[1], origin[2]});
}

Vec3 seen_in_doubles(const Pose& pose, const Vec3& w, const layout::Axes& axes) {
  const Matrix3 r = rotation(pose);
  Vec3 v;
  for (std::size_t j = 0; j < 3; ++j) {
    v[j] = (r[0][j] * w.x + r[1][j] * w.y) + r[2][j] * w.z;
  }
  Vec3 turned;
  for (std::size_t j = 0; j < 3; ++j) {
    turned[j] = (axes[j] * v.x + axes[3 + j] * v.y) + axes[6 + j] * v.z;
  }
  return turned;
}

std::array<float, 3> seen(const Pose& pose, const Vec3& w, const layout::Axes& axes) {
  const Vec3 v = seen_in_doubles(pose, w, axes);
  const auto x = static_cast<float>(v.x);
  const auto y = static_cast<float>(v.y);
  const auto z = static_cast<float>(v.z);
  return {x, y, z};
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
