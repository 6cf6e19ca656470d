#include "soms/scene/detail/pair_rows.h"

#include <algorithm>

namespace soms::detail {

void PairRows::assign(std::size_t rows, std::span<const std::uint64_t> pairs) {
  // Counted two places ahead, so that after filling the rows begin where they should.
  begins_.assign(rows + 2, 0);
  for (const std::uint64_t pair : pairs) {
    ++begins_[(pair >> 32) + 2];
  }
  for (std::size_t k = 2; k < begins_.size(); ++k) {
    begins_[k] += begins_[k - 1];
  }
  partners_.resize(pairs.size());
  for (const std::uint64_t pair : pairs) {
    partners_[begins_[(pair >> 32) + 1]++] = static_cast<std::uint32_t>(pair);
  }
  begins_.pop_back();
  for (std::size_t a = 0; a < rows; ++a) {
    std::sort(partners_.begin() + static_cast<std::ptrdiff_t>(begins_[a]),
              partners_.begin() + static_cast<std::ptrdiff_t>(begins_[a + 1]));
  }
}

}  // namespace soms::detail
