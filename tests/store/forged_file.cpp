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
  original_ = detail::read_head(bytes_, "forged");
  head_ = original_;
}

std::vector<std::byte> ForgedFile::bytes() {
  for (std::size_t k = 0; k < detail::kSections; ++k) {
    const auto section = static_cast<detail::Section>(k);
    detail::SectionPlace& place = head_.of(section);
    const std::size_t size = place.count * detail::record_size(section);
    if (place.count <= bytes_.size() && place.offset <= bytes_.size() &&
        size <= bytes_.size() - place.offset) {
      place.hash = lanes_hash(std::span(bytes_).subspan(place.offset, size));
    }
  }
  const std::string head = bytes_of(head_);
  const auto from = std::as_bytes(std::span(head));
  std::copy(from.begin(), from.end(), bytes_.begin());
  return bytes_;
}

}  // namespace soms::test
