/// \file
/// Pictures in memory, their PNG files, and what tests ask of them.
#pragma once

#include "soms/base/parallel.h"

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace soms::view {

/// Red, green, blue and opacity of each pixel, a byte each, rows from top to bottom.
struct Picture {
  Size size{0, 0};
  std::vector<std::uint8_t> bytes;  ///< 4 x width x height

  [[nodiscard]] bool operator==(const Picture&) const = default;

  /// \pre 0 <= x < width, 0 <= y < height.
  [[nodiscard]] Color at(int x, int y) const;
};

/// A picture of one color.
[[nodiscard]] Picture filled(Size size, Color color);

/// The bytes of a PNG file.
/// \errors ErrorKind::usage for a picture without pixels; ErrorKind::out_of_memory;
///         ErrorKind::cancelled.
[[nodiscard]] std::string to_png(const Picture& picture, const Parallel& parallel = {});

/// \errors ErrorKind::bad_file names `name`; ErrorKind::out_of_range beyond 2^28 pixels.
[[nodiscard]] Picture from_png(std::string_view bytes, const std::string& name = "picture");

/// Writes a file that appears whole or not at all.
/// \errors As `to_png`; ErrorKind::cannot_write.
void write_png(const Picture& picture, const std::filesystem::path& path);

/// \errors ErrorKind::cannot_open; as `from_png`.
[[nodiscard]] Picture read_png(const std::filesystem::path& path);

/// Number of pixels whose red, green and blue are each within `tolerance` of a color's.
[[nodiscard]] std::size_t count_near(const Picture& picture, Color color, int tolerance);

/// How far two pictures are apart.
struct PictureDifference {
  int largest = 0;         ///< largest difference of a byte
  double mean = 0;         ///< mean difference of a byte
  std::size_t beyond = 0;  ///< pixels with a byte beyond the tolerance
};

/// \errors ErrorKind::usage for pictures of different sizes.
[[nodiscard]] PictureDifference difference(const Picture& a, const Picture& b, int tolerance);

}  // namespace soms::view
