#include "soms/query/detail/near/keyed_pairs.h"

#include "tests/support/support.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace soms::detail {
namespace {

constexpr float kUnlimited = std::numeric_limits<float>::infinity();

/// Keys from 0 to 2, some of them equal, numbered by their nodes.
std::vector<KeyedPair> some_pairs(Rng& rng) {
  std::vector<KeyedPair> pairs;
  for (std::uint32_t i = 0; i < 1 + rng.below(600); ++i) {
    const double key =
        rng.below(3) == 0 ? 0x1p-4 * static_cast<double>(rng.below(32)) : rng.uniform(-0.1, 2);
    pairs.push_back({static_cast<float>(key), {i, i}});
  }
  return pairs;
}

/// Numbers of the pairs that `pop` gives within the limit.
std::vector<std::uint32_t> popped(KeyedPairs& pairs, float limit) {
  std::vector<std::uint32_t> numbers;
  for (KeyedPair pair; pairs.pop(limit, pair);) {
    numbers.push_back(pair.nodes.x);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

// Before and after it is sorted, whatever was taken and pushed in between.
TEST(KeyedPairs, GivesAllWithinTheLimit) {
  test::for_each_case("keyed-pairs/all", 500, [](Rng& rng) {
    const std::vector<KeyedPair> all = some_pairs(rng);
    const float limit = all[rng.below(all.size())].key;
    KeyedPairs pairs;
    pairs.clear();
    const std::size_t sorted_at = rng.below(all.size() + 1);
    std::vector<std::uint32_t> expected;
    std::vector<std::uint32_t> taken;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i == sorted_at) {
        pairs.sort(0, rng.below(2) == 0 ? limit : 2);
      }
      pairs.push(all[i]);
      if (all[i].key <= limit) {
        expected.push_back(all[i].nodes.x);
      }
      KeyedPair pair;
      if (rng.below(4) == 0 && pairs.pop(kUnlimited, pair) && pair.key <= limit) {
        taken.push_back(pair.nodes.x);
      }
    }
    const std::vector<std::uint32_t> rest = popped(pairs, limit);
    taken.insert(taken.end(), rest.begin(), rest.end());
    std::sort(taken.begin(), taken.end());
    ASSERT_EQ(taken, expected);
  });
}

TEST(KeyedPairs, GivesAllWhereTheLimitIsNotANumber) {
  KeyedPairs pairs;
  pairs.clear();
  pairs.push({1, {1, 1}});
  pairs.push({-kUnlimited, {0, 0}});
  EXPECT_EQ(popped(pairs, std::numeric_limits<float>::quiet_NaN()).size(), 2U);
}

TEST(KeyedPairs, KnowsTheLeastKeyThatIsLeft) {
  test::for_each_case("keyed-pairs/least", 300, [](Rng& rng) {
    KeyedPairs pairs;
    pairs.clear();
    EXPECT_EQ(pairs.least_left(), kUnlimited);
    if (rng.below(2) == 0) {
      pairs.sort(0, 1);
    }
    float least = kUnlimited;
    for (const KeyedPair& pair : some_pairs(rng)) {
      pairs.push(pair);
      least = std::min(least, pair.key);
      ASSERT_EQ(pairs.least_left(), least);
    }
  });
}

}  // namespace
}  // namespace soms::detail
