#include "soms/thesis/thesis_frames.h"

#include "soms/base/arithmetic.h"

namespace soms {

ApproachLine approach_line(Approach from, std::size_t up) {
  const double front = up == 1 ? 1 : -1;
  switch (from) {
    case Approach::right:
      return {0, 1};
    case Approach::left:
      return {0, -1};
    case Approach::top:
      return {up, 1};
    case Approach::bottom:
      return {up, -1};
    case Approach::front:
      return {3 - up, front};
    default:
      return {3 - up, -front};
  }
}

std::vector<Vec3> orientation_test(const Box& still, Approach from, std::size_t up) {
  const PlainArithmetic plain;
  const auto [axis, side] = approach_line(from, up);
  std::vector<Vec3> out(49);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k][axis] = side * ((64 - static_cast<double>(k)) / 32) * still.extent()[axis];
  }
  return out;
}

std::vector<Vec3> city_drive() {
  std::vector<Vec3> out(221);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = {-200 + 20 * static_cast<double>(k), 2000, -16};
  }
  return out;
}

}  // namespace soms
