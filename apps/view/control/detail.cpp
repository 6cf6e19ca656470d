#include "apps/view/control/detail.h"

#include <algorithm>
#include <cmath>

namespace soms::view {

namespace {

constexpr std::uint64_t kFirstGuess = 150'000;  ///< triangles, before any frame was timed
constexpr double kSlack = 0.2;                  ///< of the goal, within which nothing changes
constexpr double kMostCut = 0.5;                ///< in one frame
constexpr double kMostGrowth = 1.5;             ///< in one frame
constexpr double kClearlyFast = 0.1;            ///< of the goal: smooth edges surely fit too

}  // namespace

void Detail::add(double ms, std::uint64_t triangles, const DrawOptions& options) {
  if (options.samples > 1) {
    slow_ = ms > kGoalMs;
    return;
  }
  if (std::abs(ms / kGoalMs - 1) > kSlack) {
    const double factor = std::clamp(kGoalMs / std::max(ms, 1e-3), kMostCut, kMostGrowth);
    granted_ =
        std::max(static_cast<std::uint64_t>(factor * static_cast<double>(triangles)), kLeast);
  }
  if (options.most_triangles == DrawOptions::kAll && ms < kClearlyFast * kGoalMs) {
    slow_ = false;
  }
}

void Detail::add_with_uploads(double ms) {
  if (ms > kGoalMs) {
    slow_ = true;
    granted_ = kFirstGuess;
  }
}

DrawOptions Detail::options(bool moving, std::uint64_t triangles) const {
  if (!moving || !slow_) {
    return {};
  }
  return {.most_triangles = granted_ < triangles ? granted_ : DrawOptions::kAll,
          .samples = 1,
          .relief = false,
          .shadows = false};
}

}  // namespace soms::view
