/// \file
/// Tree files that were changed, with hashes that go with the change.
#pragma once

#include "soms/tree/file/detail/head.h"
#include "soms/tree/shape.h"

#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace soms::test {

/// The bytes of a shape's tree file.
[[nodiscard]] std::vector<std::byte> tree_file_of(const Shape& shape);

/// A tree file whose parts may be changed, as one who means harm would.
class ForgedFile {
 public:
  explicit ForgedFile(const Shape& shape);

  [[nodiscard]] detail::TreeFileHead& head() { return head_; }

  /// Record `i` of a section.
  template <class T>
  [[nodiscard]] T record(detail::Section section, std::size_t i) const {
    T value;
    std::memcpy(&value, at(section, i, sizeof(T)), sizeof(T));
    return value;
  }

  template <class T>
  void set_record(detail::Section section, std::size_t i, const T& value) {
    std::memcpy(at(section, i, sizeof(T)), &value, sizeof(T));
  }

  [[nodiscard]] std::size_t count(detail::Section section) const {
    return static_cast<std::size_t>(original_.of(section).count);
  }

  /// The file, each hash that of what it holds now.
  [[nodiscard]] std::vector<std::byte> bytes();

 private:
  [[nodiscard]] std::byte* at(detail::Section section, std::size_t i, std::size_t size) {
    return bytes_.data() + original_.of(section).offset + i * size;
  }

  [[nodiscard]] const std::byte* at(detail::Section section, std::size_t i,
                                    std::size_t size) const {
    return bytes_.data() + original_.of(section).offset + i * size;
  }

  detail::TreeFileHead original_;
  detail::TreeFileHead head_;
  std::vector<std::byte> bytes_;
};

}  // namespace soms::test
