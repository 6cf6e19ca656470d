#include "reproduce/statistics.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace soms::reproduce {
namespace {

TEST(Statistics, MedianIsTheMiddle) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median({7}), 7);
}

TEST(Statistics, IntervalHoldsTheMedianAndIsTheSameEachTime) {
  std::vector<double> samples(101);
  std::iota(samples.begin(), samples.end(), 0.0);
  const Estimate one = estimate(samples);
  const Estimate again = estimate(samples);
  EXPECT_EQ(one.value, 50);
  EXPECT_EQ(one.rounds, 101);
  EXPECT_LT(one.interval.low, 50);
  EXPECT_GT(one.interval.high, 50);
  EXPECT_EQ(one.interval.low, again.interval.low);
  EXPECT_EQ(one.interval.high, again.interval.high);
  // The exact interval of a median by order statistics is 40 to 60.
  EXPECT_NEAR(one.interval.low, 40, 2);
  EXPECT_NEAR(one.interval.high, 60, 2);
}

TEST(Statistics, SamplesThatAgreeLeaveNoDoubt) {
  const Estimate same = estimate(std::vector<double>(20, 1.5));
  EXPECT_EQ(same.interval.low, 1.5);
  EXPECT_EQ(same.interval.high, 1.5);
}

TEST(Statistics, RatioIsOfPairsNotOfMedians) {
  // The machine slows down from round to round; each pair keeps its ratio.
  const std::vector<double> one{2, 4, 8, 16, 32};
  const std::vector<double> other{1, 2, 4, 8, 16};
  const Estimate ratio = paired_ratio(one, other);
  EXPECT_EQ(ratio.value, 2);
  EXPECT_DOUBLE_EQ(ratio.interval.low, 2 * (1 - kBetweenProcesses));
  EXPECT_DOUBLE_EQ(ratio.interval.high, 2 * (1 + kBetweenProcesses));
  EXPECT_EQ(ratio.rounds, 5);
}

TEST(Statistics, PairsWithoutASecondHalfAreLeftOut) {
  const std::vector<double> one{3, 5};
  const std::vector<double> other{1, 0};
  EXPECT_EQ(paired_ratio(one, other).rounds, 1);
  EXPECT_THROW((void)paired_ratio(one, std::vector<double>{1}), std::logic_error);
}

}  // namespace
}  // namespace soms::reproduce
