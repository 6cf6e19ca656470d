/// \file
/// How much care a frame gets, so that slow devices stay fluent while things move, and answer while
/// a picture becomes finer.
#pragma once

#include "apps/view/drawing/renderer.h"

#include <cstdint>

namespace soms::view {

/// Steps in which a picture becomes finer once things rest.
enum class Care : std::uint8_t {
  moving,  ///< as much as fits the time
  whole,   ///< all triangles, a sample a pixel, no relief and shadows
  full,
};

/// Learns from the frames drawn, and lets a moving picture have as many triangles as fit the time.
/// Smooth edges, relief and shadows go first, triangles second, pixels last. A time is not in
/// proportion to triangles (filling costs too), so the count is steered, not computed.
class Detail {
 public:
  static constexpr double kGoalMs = 35;  ///< of drawing a frame while moving
  static constexpr std::uint64_t kLeast = 20'000;
  static constexpr double kLeastScale = 0.49;

  /// Before any frame: so many triangles may be too many for this device, so the first picture of
  /// more than a few is coarse.
  void begin(std::uint64_t triangles);

  /// A frame with these options drew so many triangles in so long.
  void add(double ms, std::uint64_t triangles, const DrawOptions& options);

  /// A whole frame took so long, and brought meshes to the device meanwhile: how long it takes
  /// alone is not known. If it was too long, motion begins coarse, and becomes finer where that
  /// fits.
  void add_with_uploads(double ms);

  /// Everything when still, and when moving where that fits; else one sample a pixel, no relief and
  /// shadows, and the triangles and pixels granted. `triangles` is how many there are.
  [[nodiscard]] DrawOptions options(Care care, std::uint64_t triangles) const;

  /// The care that comes after a picture with `last`, while nothing moves.
  [[nodiscard]] Care next(Care last) const;

 private:
  bool slow_ = false;  ///< a whole frame with smooth edges is too much
  std::uint64_t granted_ = DrawOptions::kAll;
  double scale_ = 1;
};

}  // namespace soms::view
