#include "apps/output/png_file.h"

#include "soms/base/crc32.h"

#include "apps/output/deflate.h"

#include <string_view>

namespace soms::command {

namespace {

using namespace std::string_view_literals;

constexpr char kUp = 2;  // each byte less the one above it

std::string big_endian(std::uint64_t value) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes += static_cast<char>(value >> shift & 0xffU);
  }
  return bytes;
}

std::string png_chunk(std::string_view type, std::string_view data) {
  Crc32 checksum;
  checksum.add(type);
  checksum.add(data);
  std::string chunk = big_endian(data.size());
  chunk.append(type).append(data).append(big_endian(checksum.value()));
  return chunk;
}

}  // namespace

std::string png_bytes(const RgbPicture& picture) {
  const std::size_t row = 3 * picture.width;
  std::string filtered;
  filtered.reserve((row + 1) * picture.height);
  for (std::size_t y = 0; y < picture.height; ++y) {
    filtered += kUp;
    for (std::size_t x = 0; x < row; ++x) {
      const std::uint8_t above = y == 0 ? std::uint8_t{0} : picture.rgb[(y - 1) * row + x];
      filtered += static_cast<char>(picture.rgb[y * row + x] - above);
    }
  }
  std::string bytes("\x89PNG\r\n\x1a\n"sv);
  // 8 bits each of red, green and blue; deflate, the five filters, not interlaced.
  bytes += png_chunk("IHDR", big_endian(picture.width) + big_endian(picture.height) +
                                 std::string("\x08\x02\x00\x00\x00"sv));
  bytes += png_chunk("sRGB", "\x00"sv);
  bytes += png_chunk("IDAT", deflated(filtered, DeflateForm::zlib));
  bytes += png_chunk("IEND", "");
  return bytes;
}

}  // namespace soms::command
