#include "apps/view/control/detail.h"

#include <algorithm>

namespace soms::view {

namespace {

constexpr double kNewest = 0.3;            ///< weight of the newest frame
constexpr std::uint64_t kTooFew = 10'000;  ///< below, a frame's time says nothing of triangles

}  // namespace

void Detail::add(double ms, std::uint64_t triangles) {
  if (triangles < kTooFew) {
    return;
  }
  const double now = ms / static_cast<double>(triangles);
  ms_a_triangle_ = ms_a_triangle_ > 0 ? (1 - kNewest) * ms_a_triangle_ + kNewest * now : now;
}

DrawOptions Detail::options(bool moving, std::uint64_t triangles) const {
  const double whole = ms_a_triangle_ * static_cast<double>(triangles);
  if (!moving || whole <= kGoalMs) {
    return {};
  }
  const double fits = kGoalMs / ms_a_triangle_;
  return {.most_triangles = std::max(static_cast<std::uint64_t>(fits), kLeast), .samples = 1};
}

}  // namespace soms::view
