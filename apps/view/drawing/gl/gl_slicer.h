/// \file
/// How a frame is drawn in parts, between which stop requests are checked. Private to the renderer.
#pragma once

#include "soms/base/parallel.h"

#include "apps/view/drawing/camera.h"

#include <cstdint>
#include <functional>

namespace soms::view {

/// Draws at one go until it is given something to watch; then each part is waited for, so that a
/// software driver holds nobody for long.
class GlSlicer {
 public:
  /// From here on frames are drawn in parts. No stop and no progress mean at one go.
  void watch(const Limits& limits);

  [[nodiscard]] const Limits& limits() const { return limits_; }

  /// A frame of so many triangles begins.
  void begin(std::uint64_t triangles, Size size);

  /// Copies of a mesh of so many triangles that one part takes; at least 1.
  [[nodiscard]] std::size_t copies(std::size_t all, std::uint64_t triangles) const;

  /// A part of so many triangles was sent. \errors ErrorKind::cancelled.
  void drawn(std::uint64_t triangles);

  /// Calls `draw(low, high)` for bands of rows that together are a picture, one after the other.
  /// \errors ErrorKind::cancelled.
  void in_bands(Size size, const std::function<void(int low, int high)>& draw);

 private:
  void wait();

  Limits limits_;
  bool watched_ = false;
  double all_ = 1;  ///< work of the frame: triangles, and pixels of each pass over the picture
  double done_ = 0;
};

/// Keeps what is drawn to a band of rows while it lives.
class Band {
 public:
  Band(Size size, int low, int high);
  ~Band();
  Band(const Band&) = delete;
  Band& operator=(const Band&) = delete;
};

}  // namespace soms::view
