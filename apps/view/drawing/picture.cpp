#include "apps/view/drawing/picture.h"

#include "soms/base/error.h"

#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

namespace soms::view {

namespace {

constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;

// The library's image structure, freed on every way out.
struct Image {
  png_image value{};

  Image() { value.version = PNG_IMAGE_VERSION; }

  ~Image() { png_image_free(&value); }

  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
};

bool opaque(const Picture& picture) {
  for (std::size_t i = 3; i < picture.bytes.size(); i += 4) {
    if (picture.bytes[i] != 255) {
      return false;
    }
  }
  return true;
}

std::vector<std::uint8_t> without_opacity(const Picture& picture) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(picture.bytes.size() / 4 * 3);
  for (std::size_t i = 0; i < picture.bytes.size(); i += 4) {
    bytes.insert(bytes.end(), {picture.bytes[i], picture.bytes[i + 1], picture.bytes[i + 2]});
  }
  return bytes;
}

int apart(std::uint8_t a, std::uint8_t b) {
  return std::abs(static_cast<int>(a) - static_cast<int>(b));
}

[[noreturn]] void refuse_write(const std::filesystem::path& path, const std::string& why) {
  throw Error(ErrorKind::cannot_write, path.string() + ": " + why,
              "choose a folder that exists and may be written");
}

}  // namespace

Color Picture::at(int x, int y) const {
  const auto i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                      static_cast<std::size_t>(x));
  return {bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]};
}

Picture filled(Size size, Color color) {
  Picture picture{size, {}};
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  picture.bytes.reserve(4 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    picture.bytes.insert(picture.bytes.end(), {color.r, color.g, color.b, color.a});
  }
  return picture;
}

std::string to_png(const Picture& picture) {
  if (picture.size.width < 1 || picture.size.height < 1) {
    throw Error(ErrorKind::usage, "picture: it has no pixels", "draw a frame before writing it");
  }
  const bool plain = opaque(picture);
  const std::vector<std::uint8_t> bytes = plain ? without_opacity(picture) : picture.bytes;
  Image image;
  image.value.width = static_cast<png_uint_32>(picture.size.width);
  image.value.height = static_cast<png_uint_32>(picture.size.height);
  image.value.format = plain ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  std::string file(PNG_IMAGE_PNG_SIZE_MAX(image.value), '\0');
  png_alloc_size_t size = file.size();
  if (png_image_write_to_memory(&image.value, file.data(), &size, 0, bytes.data(), 0, nullptr) ==
      0) {
    throw Error(ErrorKind::out_of_memory, std::string("picture: ") + image.value.message,
                "choose a smaller size");
  }
  file.resize(size);
  return file;
}

Picture from_png(std::string_view bytes, const std::string& name) {
  Image image;
  if (png_image_begin_read_from_memory(&image.value, bytes.data(), bytes.size()) == 0) {
    throw Error(ErrorKind::bad_file, name + ": " + image.value.message, "give a PNG file");
  }
  if (std::uint64_t{image.value.width} * image.value.height > kMostPixels) {
    throw Error(ErrorKind::out_of_range, name + ": more than 2^28 pixels", "give a smaller file");
  }
  image.value.format = PNG_FORMAT_RGBA;
  Picture picture;
  picture.size = {static_cast<int>(image.value.width), static_cast<int>(image.value.height)};
  picture.bytes.resize(PNG_IMAGE_SIZE(image.value));
  if (png_image_finish_read(&image.value, nullptr, picture.bytes.data(), 0, nullptr) == 0) {
    throw Error(ErrorKind::bad_file, name + ": " + image.value.message, "give a whole PNG file");
  }
  return picture;
}

void write_png(const Picture& picture, const std::filesystem::path& path) {
  const std::string bytes = to_png(picture);
  const std::filesystem::path beside = path.string() + ".part" + std::to_string(::getpid());
  std::error_code trouble;
  if (std::filesystem::exists(path, trouble) && !std::filesystem::is_regular_file(path, trouble)) {
    refuse_write(path, "it is no regular file");
  }
  std::ofstream file(beside, std::ios::binary);
  if (!file) {
    refuse_write(path, "cannot be created");
  }
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) {
    std::filesystem::remove(beside, trouble);
    refuse_write(path, "the disk is full or the file cannot be written");
  }
  std::filesystem::rename(beside, path, trouble);
  if (trouble) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    refuse_write(path, trouble.message());
  }
}

Picture read_png(const std::filesystem::path& path) {
  std::error_code trouble;
  std::ifstream file(path, std::ios::binary);
  if (!file || !std::filesystem::is_regular_file(path, trouble)) {
    throw Error(ErrorKind::cannot_open, path.string() + ": cannot be opened",
                "check the path and its permissions");
  }
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return from_png(bytes, path.string());
}

std::size_t count_near(const Picture& picture, Color color, int tolerance) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 3 < picture.bytes.size(); i += 4) {
    const auto* p = &picture.bytes[i];
    if (apart(p[0], color.r) <= tolerance && apart(p[1], color.g) <= tolerance &&
        apart(p[2], color.b) <= tolerance) {
      ++count;
    }
  }
  return count;
}

PictureDifference difference(const Picture& a, const Picture& b, int tolerance) {
  if (!(a.size == b.size)) {
    throw Error(ErrorKind::usage, "pictures: their sizes differ", "draw both at one size");
  }
  PictureDifference result;
  double sum = 0;
  for (std::size_t i = 0; i + 3 < a.bytes.size(); i += 4) {
    int worst = 0;
    for (std::size_t k = i; k < i + 4; ++k) {
      const int d = apart(a.bytes[k], b.bytes[k]);
      worst = std::max(worst, d);
      sum += d;
    }
    result.largest = std::max(result.largest, worst);
    result.beyond += worst > tolerance ? 1U : 0U;
  }
  result.mean = a.bytes.empty() ? 0 : sum / static_cast<double>(a.bytes.size());
  return result;
}

}  // namespace soms::view
