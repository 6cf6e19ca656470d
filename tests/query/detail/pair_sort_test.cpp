#include "soms/query/detail/pair_sort.h"

#include "tests/support/support.h"

#include <algorithm>
#include <vector>

namespace soms::detail {
namespace {

TEST(PairSort, SortsAsComparingDoes) {
  test::for_each_case("pair-sort", 400, [](Rng& rng) {
    const std::uint64_t most = std::uint64_t{1} << rng.below(32);
    std::vector<TrianglePair> pairs(rng.below(rng.below(4) == 0 ? 3000 : 90));
    for (auto& [i, j] : pairs) {
      i = static_cast<TriangleId>(rng.below(most));
      j = static_cast<TriangleId>(rng.below(rng.below(2) == 0 ? most : 4));
    }
    std::vector<TrianglePair> expected = pairs;
    std::sort(expected.begin(), expected.end());
    sort_pairs(pairs);
    ASSERT_EQ(pairs, expected);
  });
}

}  // namespace
}  // namespace soms::detail
