/// \file
/// How many frames of a simulation are due, by the clock and the speed chosen.
#pragma once

namespace soms::view {

/// Keeps the fraction of a frame that is left over, so that slow motion is even.
class Playback {
 public:
  /// Frames due after some seconds of real time at a speed. Bounded, so that a slow simulation
  /// does not fall ever further behind: what is beyond is dropped.
  [[nodiscard]] int due(double seconds, double speed);

  /// Forgets the fraction: after a pause or a leap.
  void reset() { fraction_ = 0; }

  static constexpr int kMost = 16;

 private:
  double fraction_ = 0;
};

}  // namespace soms::view
