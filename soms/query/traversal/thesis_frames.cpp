#include "soms/query/traversal/thesis_frames.h"

namespace soms {

std::vector<Vec3> orientation_test(const Box& still, Approach from, std::size_t up) {
  const std::size_t axis = from == Approach::right || from == Approach::left ? 0 : up;
  const double sign = from == Approach::right || from == Approach::top ? 1 : -1;
  std::vector<Vec3> out(49);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k][axis] = sign * ((64 - static_cast<double>(k)) / 32) * still.extent()[axis];
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
