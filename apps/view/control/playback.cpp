#include "apps/view/control/playback.h"

#include <cmath>

namespace soms::view {

namespace {

constexpr double kRate = 60;  ///< frames of a second of simulated time

}  // namespace

int Playback::due(double seconds, double speed) {
  fraction_ += seconds * speed * kRate;
  // Nearly whole counts as whole: sixty ticks of a sixtieth are sixty frames.
  const double whole = std::floor(fraction_ + 1e-6);
  if (whole > kMost) {
    fraction_ = 0;
    return kMost;
  }
  fraction_ -= whole;
  return static_cast<int>(whole);
}

}  // namespace soms::view
