/// \file
/// Pictures of pixels as PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace soms::command {

/// Pixels in sRGB, row by row from the upper left corner.
struct RgbPicture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> rgb = {};  ///< height x width x 3
};

/// The bytes of a PNG file of 8 bits a color. The same picture gives the same bytes.
/// \pre `picture.rgb` has 3 * width * height bytes, and there is at least one pixel.
/// \source W3C, Portable Network Graphics (PNG) Specification, second edition.
[[nodiscard]] std::string png_bytes(const RgbPicture& picture);

/// The same of red, green, blue and opacity, which the file has only where a pixel is not opaque.
/// `after_row` is called with the number of rows that are packed; it may throw.
[[nodiscard]] std::string png_bytes(std::size_t width, std::size_t height,
                                    std::span<const std::uint8_t> rgba,
                                    const std::function<void(std::size_t)>& after_row);

}  // namespace soms::command
