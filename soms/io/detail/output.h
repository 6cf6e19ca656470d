/// \file
/// Output that is gathered and passed on in large pieces, and files that appear whole or not at
/// all.
#pragma once

#include "soms/base/decimal.h"
#include "soms/io/new_file.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace soms::detail {

/// Gathers text and bytes. `flush` must be called at the end: a destructor could not report errors.
class Output {
 public:
  /// `write` takes each piece and throws when it cannot be written.
  explicit Output(std::function<void(std::string_view)> write);

  void put(std::string_view text);

  void put(char c) { put(std::string_view(&c, 1)); }

  /// Shortest text from which the same double is read.
  void put_number(double value) { put_chars(value); }

  void put_number(std::uint64_t value) { put_chars(value); }

  /// Bytes of a value, least significant first.
  void put_bits(std::uint64_t bits, std::size_t bytes);

  void flush();

 private:
  static constexpr std::size_t kCapacity = std::size_t{1} << 18;
  static constexpr std::size_t kLongestNumber = 32;

  template <class T>
  void put_chars(T value) {
    make_room(kLongestNumber);
    char* const begin = buffer_.data() + size_;
    char* const end = buffer_.data() + buffer_.size();
    if constexpr (std::is_floating_point_v<T>) {
      size_ += static_cast<std::size_t>(write_shortest(begin, end, value) - begin);
    } else {
      size_ += static_cast<std::size_t>(std::to_chars(begin, end, value).ptr - begin);
    }
  }

  void make_room(std::size_t bytes) {
    if (buffer_.size() - size_ < bytes) {
      flush();
    }
  }

  std::function<void(std::string_view)> write_;
  std::vector<char> buffer_;
  std::size_t size_ = 0;
};

/// A NewFile that throws.
class OutputFile {
 public:
  /// \errors ErrorKind::cannot_write.
  explicit OutputFile(const std::filesystem::path& path);

  /// \errors ErrorKind::cannot_write.
  void write(std::string_view bytes);
  /// \errors ErrorKind::cannot_write.
  void commit();

 private:
  void check(int code) const;

  std::filesystem::path path_;
  NewFile file_;
};

}  // namespace soms::detail
