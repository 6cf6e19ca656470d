/// \file
/// How many triangles a frame may draw while things move, so that slow devices stay fluent.
#pragma once

#include "apps/view/drawing/renderer.h"

#include <cstdint>

namespace soms::view {

/// Learns from the frames drawn what a triangle costs, and grants as many as fit the time.
class Detail {
 public:
  static constexpr double kGoalMs = 50;  ///< of drawing a frame while moving
  static constexpr std::uint64_t kLeast = 100'000;

  /// A frame that drew so many triangles took so long.
  void add(double ms, std::uint64_t triangles);

  /// Everything when still; when moving what fits the goal, with fewer samples where that is not
  /// everything.
  [[nodiscard]] DrawOptions options(bool moving, std::uint64_t triangles) const;

 private:
  double ms_a_triangle_ = 0;
};

}  // namespace soms::view
