/// \file
/// Hidden surfaces by a depth buffer: which of numbered triangles each sample shows.
#pragma once

#include "soms/base/vector.h"

#include "apps/draw/raster.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::look {

/// The nearest triangle at each sample of a raster.
class DepthGrid {
 public:
  static constexpr std::uint32_t kNothing = 0xffffffffU;

  explicit DepthGrid(const command::Raster& raster);

  /// Draws a triangle whose corners are on the raster, with depths as third coordinates: less is
  /// nearer. Of equally near triangles the later is shown. One without area, or with corners that
  /// are no numbers, is not.
  void draw(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t number);

  /// The triangle that each sample shows, or `kNothing`, row by row.
  [[nodiscard]] std::span<const std::uint32_t> shown() const { return shown_; }

  /// The depth of each sample; infinity where it shows nothing.
  [[nodiscard]] std::span<const double> depths() const { return depths_; }

 private:
  command::Raster raster_;
  std::vector<std::uint32_t> shown_;
  std::vector<double> depths_;
};

}  // namespace soms::look
