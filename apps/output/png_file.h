/// \file
/// Pictures of pixels as PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
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

}  // namespace soms::command
