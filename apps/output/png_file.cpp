#include "apps/output/png_file.h"

#include "soms/base/crc32.h"

#include "apps/output/deflate.h"

#include <string_view>
#include <utility>

namespace soms::command {

namespace {

using namespace std::string_literals;
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

std::string png_bytes(std::size_t width, std::size_t height, std::span<const std::uint8_t> rgba,
                      const std::function<void(std::size_t)>& after_row) {
  std::size_t channels = 3;
  for (std::size_t k = 3; k < rgba.size(); k += 4) {
    channels = rgba[k] == 255 ? channels : 4;
  }
  Deflater deflater(DeflateForm::zlib);
  std::string above(channels * width, '\0');
  std::string filtered(1 + above.size(), kUp);
  std::string row;
  for (std::size_t y = 0; y < height; ++y) {
    row.clear();
    for (std::size_t x = 0; x < width; ++x) {
      const auto pixel = rgba.subspan(4 * (y * width + x), channels);
      row.append(pixel.begin(), pixel.end());
    }
    for (std::size_t k = 0; k < row.size(); ++k) {
      filtered[k + 1] = static_cast<char>(row[k] - above[k]);
    }
    deflater.add(filtered);
    std::swap(above, row);
    if (after_row) {
      after_row(y + 1);
    }
  }
  // 8 bits each of red, green and blue, and of opacity; deflate, the five filters, not interlaced.
  return "\x89PNG\r\n\x1a\n" +
         png_chunk("IHDR",
                   big_endian(width) + big_endian(height) +
                       (channels == 3 ? "\x08\x02\x00\x00\x00"s : "\x08\x06\x00\x00\x00"s)) +
         png_chunk("sRGB", "\x00"sv) + png_chunk("IDAT", deflater.finish()) + png_chunk("IEND", "");
}

}  // namespace soms::command
