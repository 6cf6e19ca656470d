/// \file
/// Pictures in memory, and their PNG files.
#pragma once

#include "soms/base/parallel.h"

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
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
[[nodiscard]] std::string to_png(const Picture& picture, const Limits& limits = {});

/// Writes a file that appears whole or not at all.
/// \errors As `to_png`; ErrorKind::cannot_write.
void write_png(const Picture& picture, const std::filesystem::path& path);

}  // namespace soms::view
