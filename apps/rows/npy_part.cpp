#include "apps/rows/npy_part.h"

#include "soms/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

namespace soms::command {

namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kBeforeText = 10;    // bytes of the magic, the version and the text's size
constexpr std::size_t kAligned = 64;       // where the numbers begin
constexpr std::size_t kMostText = 0xffff;  // as the size of version 1 has two bytes

/// The text of the header, of format version 1; nothing for another file.
std::optional<std::string> header_text(std::istream& in) {
  std::string start(kBeforeText, '\0');
  if (!in.read(start.data(), static_cast<std::streamsize>(start.size())) ||
      !start.starts_with(kMagic) || start[kMagic.size()] != 1) {
    return std::nullopt;
  }
  std::string text(
      static_cast<unsigned char>(start[8]) + 256U * static_cast<unsigned char>(start[9]), '\0');
  return in.read(text.data(), static_cast<std::streamsize>(text.size())) ? std::optional(text)
                                                                         : std::nullopt;
}

std::string header_of(const NpyLayout& layout, std::uint64_t rows) {
  std::string text = layout.before_rows + std::to_string(rows) + layout.after_rows;
  text.erase(text.find_last_not_of(" \n") + 1);
  const std::size_t size = (kBeforeText + text.size() + kAligned) / kAligned * kAligned;
  text.resize(std::min(size - kBeforeText, kMostText), ' ');
  text.back() = '\n';
  std::string header(kMagic);
  header += '\x01';
  header += '\0';
  header += static_cast<char>(text.size() & 0xffU);
  header += static_cast<char>(text.size() >> 8U);
  return header + text;
}

}  // namespace

std::optional<NpyLayout> npy_layout(const std::filesystem::path& path) {
  std::error_code unknown;
  const std::uint64_t size = std::filesystem::is_regular_file(path, unknown)
                                 ? std::filesystem::file_size(path, unknown)
                                 : 0;
  std::ifstream in(path, std::ios::binary);
  const std::optional<std::string> text = in && size > 0 ? header_text(in) : std::nullopt;
  if (!text) {
    return std::nullopt;
  }
  constexpr std::string_view kShape = "'shape': (";
  const std::size_t at = text->find(kShape);
  if (at == std::string::npos || text->find("'fortran_order': False") == std::string::npos) {
    return std::nullopt;
  }
  NpyLayout layout;
  layout.before_rows = text->substr(0, at + kShape.size());
  const char* const digits = text->data() + layout.before_rows.size();
  const auto [end, error] = std::from_chars(digits, text->data() + text->size(), layout.rows);
  layout.begin = kBeforeText + text->size();
  if (error != std::errc() || (layout.rows > 0 && (size - layout.begin) % layout.rows != 0)) {
    return std::nullopt;
  }
  layout.after_rows = text->substr(static_cast<std::size_t>(end - text->data()));
  layout.row_bytes = layout.rows == 0 ? 0 : (size - layout.begin) / layout.rows;
  return layout;
}

TemporaryFile npy_part(const std::filesystem::path& path, const NpyLayout& layout,
                       const RowRange& rows) {
  TemporaryFile part("poses");
  part.add(header_of(layout, rows.size()));
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(layout.begin + rows.begin * layout.row_bytes));
  std::vector<char> piece(std::size_t{1} << 20U);
  for (std::uint64_t left = rows.size() * layout.row_bytes; left > 0;) {
    const auto wanted = static_cast<std::streamsize>(std::min<std::uint64_t>(left, piece.size()));
    if (!in.read(piece.data(), wanted)) {
      throw Error(ErrorKind::cannot_open, path.string() + ": cannot be read", "give another file");
    }
    part.add({piece.data(), static_cast<std::size_t>(wanted)});
    left -= static_cast<std::uint64_t>(wanted);
  }
  return part;
}

}  // namespace soms::command
