#include "soms/scene/detail/pair_rows.h"

#include "soms/base/random.h"

#include "tests/support/support.h"

#include <cstdint>
#include <set>
#include <vector>

namespace soms {

namespace {

TEST(PairRows, HoldTheirPairsSorted) {
  detail::PairRows rows;  // reused: what an earlier call left must not show
  test::for_each_case("scene/pair-rows", 50, [&](Rng& rng) {
    const std::uint64_t count = 1 + rng.below(40);
    std::set<std::uint64_t> expected;
    std::vector<std::uint64_t> pairs;
    for (std::uint64_t k = 0; count > 1 && k < rng.below(300); ++k) {
      const std::uint64_t a = rng.below(count - 1);
      const std::uint64_t b = a + 1 + rng.below(count - 1 - a);
      if (expected.insert(a << 32 | b).second) {
        pairs.push_back(a << 32 | b);
      }
    }
    rows.assign(count, pairs);
    ASSERT_EQ(rows.rows(), count);
    ASSERT_EQ(rows.size(), expected.size());
    auto next = expected.begin();
    for (std::uint64_t a = 0; a < count; ++a) {
      for (const std::uint32_t b : rows.row(a)) {
        ASSERT_EQ(*next++, a << 32 | b);
      }
    }
  });
}

}  // namespace

}  // namespace soms
