#include "tests/store/forged_file.h"

#include "soms/base/lanes_hash.h"
#include "soms/tree/file/shape_bytes.h"

#include <algorithm>

namespace soms::test {

std::vector<std::byte> tree_file_of(const Shape& shape) {
  std::vector<std::byte> bytes;
  write_tree_file(shape, [&](std::span<const std::byte> piece) {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
  });
  return bytes;
}

ForgedFile::ForgedFile(const Shape& shape) : bytes_(tree_file_of(shape)) {
  head_ = detail::read_head(bytes_, "forged");
}

std::vector<std::byte> ForgedFile::bytes() {
  for (std::size_t k = 0; k < detail::kSections; ++k) {
    const auto section = static_cast<detail::Section>(k);
    detail::SectionPlace& place = head_.of(section);
    const std::size_t size = place.count * detail::record_size(section);
    if (place.offset + size <= bytes_.size()) {
      place.hash = lanes_hash(std::span(bytes_).subspan(place.offset, size));
    }
  }
  const std::string head = bytes_of(head_);
  const auto from = std::as_bytes(std::span(head));
  std::copy(from.begin(), from.end(), bytes_.begin());
  return bytes_;
}

}  // namespace soms::test
