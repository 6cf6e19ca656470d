#include "apps/view/drawing/picture.h"

#include "soms/base/error.h"
#include "soms/io/new_file.h"

#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

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

/// Writes a PNG file row by row. The library leaves by a jump when it fails: what it jumps over has
/// no destructor, so each step is a function of its own that says whether it succeeded.
class PngWriter {
 public:
  PngWriter() {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, keep_words, ignore_words);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
  }

  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }

  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  [[nodiscard]] bool begin(Size size, int colors) {
    if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) {
      return false;
    }
    png_set_write_fn(png_, this, add_bytes, nullptr);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(size.width),
                 static_cast<png_uint_32>(size.height), 8, colors, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png_, info_);
    return true;
  }

  [[nodiscard]] bool write(const std::uint8_t* row) {
    if (setjmp(png_jmpbuf(png_)) != 0) {
      return false;
    }
    png_write_row(png_, row);
    return true;
  }

  [[nodiscard]] bool finish() {
    if (setjmp(png_jmpbuf(png_)) != 0) {
      return false;
    }
    png_write_end(png_, info_);
    return true;
  }

  /// The bytes so far; they are given away.
  [[nodiscard]] std::string& bytes() { return bytes_; }

  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  [[noreturn]] static void keep_words(png_structp png, png_const_charp words) {
    auto& self = *static_cast<PngWriter*>(png_get_error_ptr(png));
    try {
      self.trouble_ = words;
    } catch (...) {  // out of memory: then without words
    }
    png_longjmp(png, 1);
  }

  static void ignore_words(png_structp /*png*/, png_const_charp /*words*/) {}

  static void add_bytes(png_structp png, png_bytep bytes, png_size_t count) {
    auto& self = *static_cast<PngWriter*>(png_get_io_ptr(png));
    bool added = true;
    try {
      self.bytes_.append(reinterpret_cast<const char*>(bytes), count);
    } catch (...) {
      added = false;
    }
    if (!added) {
      png_error(png, "not enough memory");
    }
  }

  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::string bytes_;
  std::string trouble_;
};

int apart(std::uint8_t a, std::uint8_t b) {
  return std::abs(static_cast<int>(a) - static_cast<int>(b));
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

std::string to_png(const Picture& picture, const Parallel& parallel) {
  if (picture.size.width < 1 || picture.size.height < 1) {
    throw Error(ErrorKind::usage, "picture: it has no pixels", "draw a frame before writing it");
  }
  const bool plain = opaque(picture);
  const auto width = static_cast<std::size_t>(picture.size.width);
  const auto height = static_cast<std::size_t>(picture.size.height);
  std::vector<std::uint8_t> plain_row(plain ? 3 * width : 0);
  PngWriter writer;
  bool good = writer.begin(picture.size, plain ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA);
  for (std::size_t y = 0; good && y < height; ++y) {
    const std::uint8_t* const row = &picture.bytes[4 * width * y];
    for (std::size_t x = 0; plain && x < width; ++x) {
      std::copy_n(row + 4 * x, 3, &plain_row[3 * x]);
    }
    good = writer.write(plain ? plain_row.data() : row);
    check_stop(parallel);
    if (parallel.progress) {
      parallel.progress(static_cast<double>(y + 1) / static_cast<double>(height));
    }
  }
  if (!good || !writer.finish()) {
    throw Error(ErrorKind::out_of_memory, "picture: " + writer.trouble(), "choose a smaller size");
  }
  return std::move(writer.bytes());
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
  NewFile file;
  const auto check = [&](int error) {
    if (error != 0) {
      throw Error(ErrorKind::cannot_write,
                  path.string() + ": " + std::generic_category().message(error),
                  "check that the folder exists and is writable, and that the disk has free space");
    }
  };
  check(file.open(path));
  for (std::string_view left = bytes; !left.empty();) {
    const ssize_t done = ::write(file.descriptor(), left.data(), left.size());
    if (done < 0 && errno != EINTR) {
      check(errno);
    }
    left.remove_prefix(done < 0 ? 0 : static_cast<std::size_t>(done));
  }
  check(file.commit());
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
