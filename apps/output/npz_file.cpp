#include "apps/output/npz_file.h"

#include "soms/base/text.h"

#include "apps/output/zip_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace soms::command {

std::string npy_header(std::string_view type, const std::string& shape) {
  constexpr std::size_t kAligned = 64;
  constexpr std::size_t kBeforeText = 10;
  std::string text =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type, shape);
  text.resize((kBeforeText + text.size() + kAligned) / kAligned * kAligned - kBeforeText, ' ');
  text.back() = '\n';
  std::string header = "\x93NUMPY\x01";
  header += '\0';
  header += static_cast<char>(text.size() & 0xffU);
  header += static_cast<char>(text.size() >> 8);
  return header + text;
}

namespace {

/// How NumPy names a type, and the bytes of a number.
struct NpyType {
  std::string_view name;
  std::size_t size;
};

NpyType type_of(NpzColumn::Kind kind) {
  constexpr std::array<NpyType, 4> kTypes{{{"<f8", 8}, {"<i8", 8}, {"|b1", 1}, {"|u1", 1}}};
  return kTypes[static_cast<std::size_t>(kind)];
}

/// Texts as NumPy keeps them: as many UTF-32 characters for each as the longest has.
std::string npy_words(const std::vector<std::string>& words) {
  std::vector<std::u32string> texts;
  std::size_t longest = 1;
  for (const std::string& word : words) {
    texts.push_back(code_points(word));
    longest = std::max(longest, texts.back().size());
  }
  std::string bytes = npy_header(fmt::format("<U{}", longest), fmt::format("({},)", words.size()));
  for (std::u32string& text : texts) {
    text.resize(longest);
    for (const char32_t point : text) {
      for (int shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>(point >> shift & 0xffU);
      }
    }
  }
  return bytes;
}

}  // namespace

NpzColumn::NpzColumn(std::string name, Kind kind, std::vector<std::size_t> row_shape)
    : name_(std::move(name)), kind_(kind), row_shape_(std::move(row_shape)) {
}

void NpzColumn::put(std::uint64_t bits, std::size_t size) {
  std::array<char, 8> text{};
  for (std::size_t i = 0; i < size; ++i) {
    text[i] = static_cast<char>(bits >> (8 * i) & 0xffU);
  }
  bytes_.add({text.data(), size});
}

void NpzColumn::add(double value) {
  put(std::bit_cast<std::uint64_t>(value), 8);
}

void NpzColumn::add(std::int64_t value) {
  put(std::bit_cast<std::uint64_t>(value), 8);
}

void NpzColumn::add(bool value) {
  put(value ? 1 : 0, 1);
}

void NpzColumn::add(std::uint8_t value) {
  put(value, 1);
}

void NpzColumn::add(const Vec3& value) {
  add(value.x);
  add(value.y);
  add(value.z);
}

std::string NpzColumn::header() const {
  std::size_t row = 1;
  std::string sizes;
  for (const std::size_t size : row_shape_) {
    row *= size;
    sizes += fmt::format(", {}", size);
  }
  const NpyType type = type_of(kind_);
  return npy_header(type.name, fmt::format("({}{})", bytes_.size() / (row * type.size),
                                           sizes.empty() ? "," : sizes));
}

NpzColumn& NpzFile::column(std::string name, NpzColumn::Kind kind,
                           std::vector<std::size_t> row_shape) {
  columns_.push_back(std::make_unique<NpzColumn>(std::move(name), kind, std::move(row_shape)));
  return *columns_.back();
}

NpzColumn& NpzFile::names(const std::string& name, std::span<const std::string_view> words) {
  words_.push_back({name + "_names", {words.begin(), words.end()}});
  return column(name, NpzColumn::Kind::code);
}

void NpzFile::finish() {
  ZipWriter archive(file_.stream());
  for (const auto& column : columns_) {
    archive.add(column->name() + ".npy", [&](const auto& put) {
      put(column->header());
      column->bytes().read(put);
    });
    file_.check();
  }
  for (const auto& [name, words] : words_) {
    archive.add(name + ".npy", [&](const auto& put) { put(npy_words(words)); });
  }
  for (const auto& [name, bytes] : copied_) {
    archive.add_stored(name + ".npy", bytes);
  }
  archive.finish();
  file_.commit();
}

}  // namespace soms::command
