// The twin in whole numbers that fuzzers and properties believe.
#include "tests/support/truth/triangle_truth.h"

#include "tests/support/support.h"
#include "tests/support/truth/truth.h"

#include <gtest/gtest.h>

namespace soms::test {
namespace {

TEST(TriangleTruth, IsWhatTheTruthSetSaysOfEvery29thPair) {
  std::size_t overlapping = 0;
  const auto& pairs = truth_triangles();
  for (std::size_t i = 0; i < pairs.size(); i += 29) {
    const auto& [kind, s, t, expected] = pairs[i];
    ASSERT_EQ(share_a_point(s, t), expected) << kind << ", pair " << i;
    ASSERT_EQ(share_a_point(t, s), expected) << kind << ", pair " << i;
    overlapping += expected ? 1U : 0U;
  }
  EXPECT_GT(overlapping, 200U);
}

TEST(TriangleTruth, TellsPointsThatDifferByTheLeastNumberThereIs) {
  const double least = 0x1p-1074;
  const Vec3 p{0x1p300, -1, least};
  const Vec3 q{0x1p300, -1, 2 * least};
  EXPECT_TRUE(share_a_point({p, p, p}, {p, p, p}));
  EXPECT_FALSE(share_a_point({p, p, p}, {q, q, q}));
  EXPECT_TRUE(share_a_point({p, p, p}, {{0x1p300, -1, 0}, q, q}));
}

}  // namespace
}  // namespace soms::test
