/// \file
/// What tests ask of pictures and of their PNG files, which libpng reads: not what wrote them.
#pragma once

#include "apps/view/drawing/picture_file.h"

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace soms::view {

/// Throws where the bytes are no PNG file.
[[nodiscard]] Picture from_png(std::string_view bytes);

[[nodiscard]] Picture read_png(const std::filesystem::path& path);

/// Number of pixels whose red, green and blue are each within `tolerance` of a color's.
[[nodiscard]] std::size_t count_near(const Picture& picture, Color color, int tolerance);

/// How far two pictures of one size are apart.
struct PictureDifference {
  double mean = 0;         ///< mean difference of a byte
  std::size_t beyond = 0;  ///< pixels with a byte beyond the tolerance
};

[[nodiscard]] PictureDifference difference(const Picture& a, const Picture& b, int tolerance);

}  // namespace soms::view
