#include "thesis/trips/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

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
  const Estimate one = estimate(samples, 1);
  const Estimate again = estimate(samples, 1);
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
  const Estimate same = estimate(std::vector<double>(20, 1.5), 1);
  EXPECT_EQ(same.interval.low, 1.5);
  EXPECT_EQ(same.interval.high, 1.5);
}

TEST(Statistics, RatioIsOfPairsNotOfMedians) {
  // The machine slows down from round to round; each pair keeps its ratio.
  const std::vector<double> one{2, 4, 8, 16, 32};
  const std::vector<double> other{1, 2, 4, 8, 16};
  const Estimate ratio = paired_ratio(one, other, 1);
  EXPECT_EQ(ratio.value, 2);
  EXPECT_EQ(ratio.interval.low, 2);
  EXPECT_EQ(ratio.interval.high, 2);
  EXPECT_EQ(ratio.rounds, 5);
}

TEST(Statistics, PairsWithoutASecondHalfAreLeftOut) {
  const std::vector<double> one{3, 5};
  const std::vector<double> other{1, 0};
  EXPECT_EQ(paired_ratio(one, other, 1).rounds, 1);
  EXPECT_THROW((void)paired_ratio(one, std::vector<double>{1}, 1), std::logic_error);
}

/// Rounds of five processes, which differ by 0.02 within each; the last process is `off` the
/// others.
std::vector<double> rounds_of_five(double off) {
  std::vector<double> rounds;
  for (int process = 0; process < 5; ++process) {
    for (const double within : {-0.01, 0.0, 0.0, 0.01}) {
      rounds.push_back(1 + within + (process == 4 ? off : 0));
    }
  }
  return rounds;
}

TEST(Statistics, ProcessesThatAgreeAddNothingToTheInterval) {
  const std::vector<double> rounds = rounds_of_five(0);
  const Estimate five = estimate(rounds, 5);
  EXPECT_EQ(five.processes, 5);
  EXPECT_EQ(five.rounds, 20);
  EXPECT_EQ(five.value, 1);
  EXPECT_GE(five.interval.low, 0.99);
  EXPECT_LE(five.interval.high, 1.01);
  EXPECT_EQ(estimate(rounds, 1).value, five.value);
}

TEST(Statistics, ProcessesThatDifferWidenTheInterval) {
  // Each round of a process is the same: rounds alone have little doubt, two of five processes are
  // all that is known of how processes differ.
  std::vector<double> rounds(20, 1.0);
  std::fill(rounds.begin() + 12, rounds.end(), 1.1);
  const Estimate apart = estimate(rounds, 5);
  EXPECT_EQ(apart.value, 1);
  EXPECT_EQ(apart.interval.low, 1);
  EXPECT_NEAR(apart.interval.high, 1.1, 1e-12);
  // One of five is off: it is drawn three times or more in 6 of 100 samples, above it or below.
  const Estimate one_off = estimate(rounds_of_five(0.1), 5);
  const Estimate none_off = estimate(rounds_of_five(0), 5);
  EXPECT_GT(one_off.interval.high - one_off.interval.low,
            none_off.interval.high - none_off.interval.low);
  EXPECT_GE(one_off.interval.high, 1.09);
}

TEST(Statistics, ProcessesMustHaveMeasuredAsMuchEach) {
  EXPECT_THROW((void)estimate(std::vector<double>(21, 1.0), 5), std::logic_error);
  EXPECT_THROW((void)estimate(std::vector<double>(20, 1.0), 0), std::logic_error);
}

TEST(Statistics, ProcessWithoutAPairIsLeftOut) {
  const std::vector<double> one{3, 5, 7, 9};
  const std::vector<double> other{1, 1, 0, 0};
  EXPECT_EQ(paired_ratio(one, other, 2).rounds, 2);
  EXPECT_EQ(paired_ratio(one, other, 2).processes, 1);
}

}  // namespace
}  // namespace soms::reproduce
