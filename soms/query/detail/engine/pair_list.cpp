#include "soms/query/detail/engine/pair_list.h"

#include <algorithm>

namespace soms::detail {

void PairList::grow(std::size_t least) {
  const std::size_t capacity = std::max(least, 2 * capacity_);
  std::vector<std::uint32_t> larger(2 * capacity);
  std::copy_n(x_, size_, larger.begin());
  std::copy_n(y_, size_, larger.begin() + static_cast<std::ptrdiff_t>(capacity));
  far_.swap(larger);
  x_ = far_.data();
  y_ = far_.data() + capacity;
  capacity_ = capacity;
}

}  // namespace soms::detail
