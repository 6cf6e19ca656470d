/// \file
/// Pictures of pixels as PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace soms::command {

/// The bytes of a PNG file of red, green, blue and opacity, which the file has only where a pixel
/// is not opaque. The same picture gives the same bytes. `after_row` is called with the number of
/// rows that are packed; it may throw.
/// \shape  `rgba`: height x width x 4 bytes, row by row from the upper left corner.
/// \pre    There is a pixel.
/// \source W3C, Portable Network Graphics (PNG) Specification, second edition.
[[nodiscard]] std::string png_bytes(std::size_t width, std::size_t height,
                                    std::span<const std::uint8_t> rgba,
                                    const std::function<void(std::size_t)>& after_row = {});

}  // namespace soms::command
