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
constexpr double kLessScale = 0.7;              ///< half of the pixels
constexpr double kRoomForPixels = 0.4;          ///< of the goal: twice the pixels surely fit

}  // namespace

void Detail::begin(std::uint64_t triangles) {
  if (triangles > kFirstGuess) {
    slow_ = true;
    granted_ = kFirstGuess;
  }
}

void Detail::add(double ms, std::uint64_t triangles, const DrawOptions& options) {
  if (options.samples > 1) {
    slow_ = ms > kGoalMs;
    return;
  }
  if (options.scale < 1 && ms < kRoomForPixels * kGoalMs) {
    scale_ = options.scale < kLessScale ? kLessScale : 1;
  } else if (ms > (1 + kSlack) * kGoalMs &&
             (triangles <= kLeast || options.most_triangles <= kLeast)) {
    scale_ = std::max(options.scale * kLessScale, kLeastScale);
  } else if (std::abs(ms / kGoalMs - 1) > kSlack && (ms > kGoalMs || options.scale == 1)) {
    const double factor = std::clamp(kGoalMs / std::max(ms, 1e-3), kMostCut, kMostGrowth);
    granted_ =
        std::max(static_cast<std::uint64_t>(factor * static_cast<double>(triangles)), kLeast);
  }
  if (options.most_triangles == DrawOptions::kAll && options.scale == 1 &&
      ms < kClearlyFast * kGoalMs) {
    slow_ = false;
  }
}

void Detail::add_with_uploads(double ms) {
  if (ms > kGoalMs) {
    slow_ = true;
    granted_ = kFirstGuess;
  }
}

DrawOptions Detail::options(Care care, std::uint64_t triangles) const {
  if (care == Care::full || (care == Care::moving && !slow_)) {
    return {};
  }
  DrawOptions quick{.samples = 1, .relief = false, .shadows = false};
  if (care == Care::moving) {
    quick.most_triangles = granted_ < triangles ? granted_ : DrawOptions::kAll;
    quick.scale = scale_;
  }
  return quick;
}

Care Detail::next(Care last) const {
  return last == Care::moving && slow_ ? Care::whole : Care::full;
}

}  // namespace soms::view
