#include "soms/thesis/thesis_frames.h"

#include "soms/base/arithmetic.h"

#include <algorithm>

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
  std::vector<Vec3> out(kApproachFrames);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k][axis] = side * ((64 - static_cast<double>(k)) / 32) * still.extent()[axis];
  }
  return out;
}

std::vector<Vec3> orientation_test(const Box& still, const Box& moving, Approach from,
                                   std::size_t up) {
  const PlainArithmetic plain;
  const Vec3 to_middle = still.center() - moving.center();
  std::vector<Vec3> out = orientation_test(still, from, up);
  for (Vec3& offset : out) {
    offset = to_middle + offset;
  }
  return out;
}

std::vector<Vec3> drive_through(const Box& still, const Box& moving, std::size_t up) {
  constexpr double kMargin = 0.05;  // of the scene's length
  constexpr double kSunk = 0.01;    // of its height
  const PlainArithmetic plain;
  const Vec3 extent = still.extent();
  const std::size_t side = 3 - up;
  const double margin = std::max(kMargin * extent.x, moving.extent().x);
  std::vector<Vec3> out(kDriveFrames);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(out.size() - 1);
    out[k][0] = still.lower.x - margin + share * (extent.x + 2 * margin) - moving.center().x;
    out[k][side] = still.center()[side] - moving.center()[side];
    out[k][up] = still.lower[up] - kSunk * extent[up] - moving.lower[up];
  }
  return out;
}

std::vector<Vec3> city_drive() {
  std::vector<Vec3> out(kDriveFrames);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = {-200 + 20 * static_cast<double>(k), 2000, -16};
  }
  return out;
}

}  // namespace soms
