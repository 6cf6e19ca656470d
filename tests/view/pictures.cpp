#include "tests/view/pictures.h"

#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace soms::view {

namespace {

bool is_near(std::uint8_t a, std::uint8_t b, int tolerance) {
  return std::abs(int{a} - int{b}) <= tolerance;
}

}  // namespace

Picture from_png(std::string_view bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Picture picture;
  bool good = png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) != 0;
  if (good) {
    image.format = PNG_FORMAT_RGBA;
    picture.size = {static_cast<int>(image.width), static_cast<int>(image.height)};
    picture.bytes.resize(PNG_IMAGE_SIZE(image));
    good = png_image_finish_read(&image, nullptr, picture.bytes.data(), 0, nullptr) != 0;
  }
  const std::string trouble = image.message;
  png_image_free(&image);
  if (!good) {
    throw std::runtime_error(trouble);
  }
  return picture;
}

Picture read_png(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return from_png(
      std::string{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
}

std::size_t count_near(const Picture& picture, Color color, int tolerance) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 3 < picture.bytes.size(); i += 4) {
    const auto* p = &picture.bytes[i];
    count += is_near(p[0], color.r, tolerance) && is_near(p[1], color.g, tolerance) &&
                     is_near(p[2], color.b, tolerance)
                 ? 1U
                 : 0U;
  }
  return count;
}

PictureDifference difference(const Picture& a, const Picture& b, int tolerance) {
  if (!(a.size == b.size)) {
    throw std::runtime_error("pictures of different sizes");
  }
  PictureDifference result;
  double sum = 0;
  for (std::size_t i = 0; i + 3 < a.bytes.size(); i += 4) {
    int worst = 0;
    for (std::size_t k = i; k < i + 4; ++k) {
      const int off = std::abs(int{a.bytes[k]} - int{b.bytes[k]});
      worst = std::max(worst, off);
      sum += off;
    }
    result.beyond += worst > tolerance ? 1U : 0U;
  }
  result.mean = a.bytes.empty() ? 0 : sum / static_cast<double>(a.bytes.size());
  return result;
}

}  // namespace soms::view
