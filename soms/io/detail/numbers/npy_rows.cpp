#include "soms/io/detail/numbers/npy_rows.h"

#include "soms/base/error.h"
#include "soms/base/portable.h"
#include "soms/io/detail/numbers/little_endian.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soms::detail {

namespace {

constexpr std::size_t kMatrix = 12;         // numbers of the first three lines of one
constexpr std::size_t kWholeMatrix = 16;    // of all four
constexpr std::size_t kMostHeader = 65535;  // bytes: far more than any shape takes

double number_at(std::string_view bytes, std::size_t width, std::size_t i) {
  if (width == 4) {
    return static_cast<double>(little_endian<float>(bytes, 4 * i));
  }
  const std::uint64_t low = little_endian<std::uint32_t>(bytes, 8 * i);
  const std::uint64_t high = little_endian<std::uint32_t>(bytes, 8 * i + 4);
  return bit_cast<double>(high << 32 | low);
}

/// What a row is, by the sizes behind the first: how many numbers it has in the file.
std::optional<std::size_t> stored_numbers(const std::vector<std::uint64_t>& shape,
                                          std::size_t columns) {
  const bool is_row = shape.size() == 2 && shape[1] == columns;
  const bool is_matrix = columns == kMatrix && shape.size() == 3 && shape[2] == 4;
  if (is_row || (is_matrix && shape[1] == 3)) {
    return columns;
  }
  return is_matrix && shape[1] == 4 ? std::optional(kWholeMatrix) : std::nullopt;
}

/// "(N, 3), (N, 7)"
std::string known_shapes(std::span<const std::vector<Column>> headers) {
  std::string text;
  for (const std::vector<Column>& header : headers) {
    text += (text.empty() ? "(N, " : ", (N, ") + std::to_string(header.size()) + ")";
    text += header.size() == kMatrix ? ", (N, 3, 4), (N, 4, 4)" : "";
  }
  return text;
}

}  // namespace

NpyRows::NpyRows(LineReader& file, std::string_view what,
                 std::span<const std::vector<Column>> headers)
    : file_(file) {
  read_header();
  choose_columns(what, headers);
}

void NpyRows::read_header() {
  const auto fail = [this](const std::string& fault) {
    throw Error(ErrorKind::bad_file, file_.name() + ": " + fault,
                "save the array again with numpy.save");
  };
  const std::size_t to_version = kNpyMagic.size() + 2;
  const std::string start(file_.bytes(to_version));
  const int version = start.size() < to_version ? 0 : start[to_version - 2];
  if (version != 1 && version != 2) {
    fail(version == 0 ? "ends in the header of a NumPy array"
                      : "NumPy's format version " + std::to_string(version) + " is not known");
  }
  const std::size_t size_bytes = version == 1 ? 2 : 4;
  const std::string_view size_text = file_.bytes(size_bytes);
  if (size_text.size() < size_bytes) {
    fail("ends in the header of a NumPy array");
  }
  const std::size_t size = version == 1 ? little_endian<std::uint16_t>(size_text, 0)
                                        : little_endian<std::uint32_t>(size_text, 0);
  if (size > kMostHeader) {
    fail("a header of " + std::to_string(size) + " bytes");
  }
  const std::string_view text = file_.bytes(size);
  if (text.size() < size) {
    fail("ends in the header of a NumPy array");
  }
  header_ = parse_npy_header(text, file_.name());
}

void NpyRows::choose_columns(std::string_view what, std::span<const std::vector<Column>> headers) {
  for (const std::vector<Column>& header : headers) {
    if (const auto stored = stored_numbers(header_.shape, header.size())) {
      stored_ = *stored;
      columns_ = header;
    }
  }
  if (stored_ == 0) {
    throw Error(ErrorKind::bad_file,
                file_.name() + ": the array has the shape " + npy_shape(header_.shape),
                "give " + std::string(what) + " as " + known_shapes(headers));
  }
  rows_ = header_.shape[0];
  left_ = rows_;
  numbers_.resize(columns_.size());
}

std::string NpyRows::here(const std::string& fault) const {
  return file_.name() + ", row " + std::to_string(rows_ - left_ - 1) + ": " + fault;
}

void NpyRows::read_numbers(std::string_view bytes) {
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    numbers_[i] = number_at(bytes, header_.width, i);
    const bool allowed =
        std::isfinite(numbers_[i]) || (columns_[i].may_be_infinite && std::isinf(numbers_[i]));
    if (!allowed) {
      throw Error(ErrorKind::not_finite,
                  here(std::string(columns_[i].name) + " is " +
                       (std::isnan(numbers_[i]) ? "nan" : "infinite") + ", not a finite number"),
                  "give a finite number");
    }
  }
  constexpr std::array<double, 4> kLastLine{0, 0, 0, 1};
  for (std::size_t i = numbers_.size(); i < stored_; ++i) {
    if (number_at(bytes, header_.width, i) != kLastLine[i - numbers_.size()]) {
      throw Error(ErrorKind::bad_file, here("the last line of the matrix is not 0, 0, 0, 1"),
                  "give rigid motions");
    }
  }
}

std::optional<std::span<const double>> NpyRows::next() {
  const std::string_view bytes = file_.bytes(left_ == 0 ? 1 : row_bytes());
  if (left_ == 0) {
    if (!bytes.empty()) {
      throw Error(ErrorKind::bad_file,
                  file_.name() + ": more bytes follow the " + std::to_string(rows_) + " rows",
                  "give one array per file");
    }
    return std::nullopt;
  }
  if (bytes.size() < row_bytes()) {
    throw Error(ErrorKind::bad_file,
                file_.name() + ": ends after " + std::to_string(rows_ - left_) + " of " +
                    std::to_string(rows_) + " rows",
                "save the array again with numpy.save");
  }
  --left_;
  read_numbers(bytes);
  return numbers_;
}

}  // namespace soms::detail
