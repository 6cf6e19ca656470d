/// \file
/// Columns of answers as NumPy arrays in one file (.npz), which numpy.load reads.
#pragma once

#include "soms/base/vector.h"

#include "apps/output/output.h"
#include "apps/output/spooled_bytes.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

/// The header of an array file, format version 1.0, which the numbers follow. `shape` is a tuple of
/// Python, `type` one of NumPy, such as "<f8".
[[nodiscard]] std::string npy_header(std::string_view type, const std::string& shape);

/// An array that grows by whole rows.
class NpzColumn {
 public:
  enum class Kind { number, count, flag, code };  ///< <f8, <i8, |b1, |u1

  /// `row_shape` is that of one row: {} for numbers, {3} for points.
  NpzColumn(std::string name, Kind kind, std::vector<std::size_t> row_shape);

  void add(double value);        ///< \pre Kind::number
  void add(std::int64_t value);  ///< \pre Kind::count
  void add(bool value);          ///< \pre Kind::flag
  void add(std::uint8_t value);  ///< \pre Kind::code
  void add(const Vec3& value);   ///< three numbers

  /// Adds the bytes of whole numbers of this kind, little-endian.
  void add_bytes(std::string_view bytes) { bytes_.add(bytes); }

  [[nodiscard]] const std::string& name() const { return name_; }

  [[nodiscard]] std::string header() const;

  [[nodiscard]] SpooledBytes& bytes() { return bytes_; }

 private:
  void put(std::uint64_t bits, std::size_t size);

  std::string name_;
  Kind kind_;
  std::vector<std::size_t> row_shape_;
  SpooledBytes bytes_;
};

/// A file of columns that appears whole or not at all; its columns wait in temporary files, so that
/// answers of any number need no more memory than a few. The same answers give the same bytes.
class NpzFile {
 public:
  /// Opens the file. \errors ErrorKind::cannot_write.
  explicit NpzFile(const std::string& path) : file_(path) {}

  /// Adds an empty column, which stays until the file is finished.
  [[nodiscard]] NpzColumn& column(std::string name, NpzColumn::Kind kind,
                                  std::vector<std::size_t> row_shape = {});

  /// Adds a column of codes, and the array "<name>_names" of what each code means: names[codes] in
  /// NumPy gives the words.
  [[nodiscard]] NpzColumn& names(const std::string& name, std::span<const std::string_view> words);

  /// Adds an array of one text.
  void text(const std::string& name, const std::string& text) { words_.push_back({name, {text}}); }

  /// Adds an array as the bytes of its file, which stands behind all columns.
  void copy(const std::string& name, std::string bytes) {
    copied_.emplace_back(name, std::move(bytes));
  }

  /// Writes all columns and makes the file appear. \errors ErrorKind::cannot_write; ClosedPipe.
  void finish();

 private:
  /// An array of texts.
  struct Words {
    std::string name;
    std::vector<std::string> words;
  };

  OutputFile file_;
  std::vector<std::unique_ptr<NpzColumn>> columns_;
  std::vector<Words> words_;
  std::vector<std::pair<std::string, std::string>> copied_;
};

}  // namespace soms::command
