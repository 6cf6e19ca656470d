#include "soms/scene/detail/pair_order.h"

#include "soms/base/random.h"

#include "tests/support/support.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

namespace soms {

namespace {

TEST(PairOrder, IsThatOfTheFirstBoxAndThenOfTheSecond) {
  constexpr std::uint64_t kOpen = std::uint64_t{1} << 63;
  std::vector<std::uint64_t> sorted;  // reused: what an earlier call left must not show
  test::for_each_case("scene/pair-order", 60, [&](Rng& rng) {
    const std::uint64_t boxes = 2 + rng.below(std::uint64_t{1} << (1 + rng.below(29)));
    const std::uint64_t count = rng.below(4) == 0 ? rng.below(300) : rng.below(3000);
    std::set<std::uint64_t> expected;
    std::vector<std::uint64_t> pairs;
    for (std::uint64_t k = 0; k < count; ++k) {
      // Of the last boxes, too, so that the highest digits are in use.
      const std::uint64_t a = rng.below(2) == 0 ? rng.below(boxes) : boxes - 1 - rng.below(2);
      const std::uint64_t b = rng.below(boxes);
      if (expected.insert(a << 32 | b).second) {
        pairs.push_back(a << 32 | b | (b % 3 == 0 ? kOpen : 0));
      }
    }
    detail::sort_box_pairs(pairs, boxes, sorted);
    ASSERT_EQ(sorted.size(), expected.size());
    auto next = expected.begin();
    for (const std::uint64_t pair : sorted) {
      ASSERT_EQ(pair & ~kOpen, *next);
      ASSERT_EQ((pair & kOpen) != 0, static_cast<std::uint32_t>(*next++) % 3 == 0);
    }
  });
}

}  // namespace

}  // namespace soms
