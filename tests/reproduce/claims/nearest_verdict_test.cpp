// The verdict of the reading nearest to the text: its rule, and the rows that it is computed from.
#include "thesis/claims/nearest_verdict.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace soms::reproduce {
namespace {

NearestStand of_comparison(std::size_t hold, std::size_t open, std::size_t fail,
                           std::size_t subjects = kLeastSubjects) {
  return stand_of({hold, open, fail, subjects}, Scope::comparison);
}

TEST(NearestVerdict, SeparatesTheClaimsOfTheThesis) {
  EXPECT_EQ(of_comparison(11, 0, 0), NearestStand::holds);
  EXPECT_EQ(of_comparison(7, 0, 0), NearestStand::holds);
  EXPECT_EQ(of_comparison(5, 0, 5), NearestStand::mixed);
  EXPECT_EQ(of_comparison(6, 0, 18), NearestStand::mostly_fails);
  EXPECT_EQ(of_comparison(2, 0, 28), NearestStand::mostly_fails);
  EXPECT_EQ(of_comparison(1, 0, 8), NearestStand::mostly_fails);
  EXPECT_EQ(stand_of({0, 0, 2, 1}, Scope::figure), NearestStand::fails);
}

TEST(NearestVerdict, UndecidedRowsCountForTheHighEndAlone) {
  EXPECT_EQ(of_comparison(6, 10, 8), NearestStand::mixed);
  EXPECT_EQ(of_comparison(9, 1, 0), NearestStand::mostly_holds);
  EXPECT_EQ(of_comparison(2, 5, 0), NearestStand::undecided);
  EXPECT_EQ(of_comparison(0, 5, 2), NearestStand::undecided);
  EXPECT_EQ(of_comparison(0, 5, 0), NearestStand::undecided);
  EXPECT_EQ(of_comparison(0, 1, 9), NearestStand::mostly_fails);
}

TEST(NearestVerdict, ComparisonNeedsThreeSubjectsAndRowsAndAFigureOne) {
  EXPECT_EQ(of_comparison(2, 0, 0, 2), NearestStand::too_few_rows);
  EXPECT_EQ(of_comparison(20, 0, 0, 2), NearestStand::too_few_rows);
  EXPECT_EQ(of_comparison(0, 0, 2, 2), NearestStand::too_few_rows);
  EXPECT_EQ(of_comparison(3, 0, 0, 3), NearestStand::holds);
  EXPECT_EQ(stand_of({1, 0, 0, 1}, Scope::figure), NearestStand::holds);
  EXPECT_EQ(stand_of({}, Scope::figure), NearestStand::cannot_be_checked);
  EXPECT_EQ(of_comparison(0, 0, 0, 0), NearestStand::cannot_be_checked);
}

TEST(NearestVerdict, SharesHaveWilsonIntervals) {
  // Brown, Cai and DasGupta, Interval estimation for a binomial proportion, 2001, have the formula.
  const Interval half = wilson_interval(5, 10);
  EXPECT_NEAR(half.low, 0.2366, 5e-5);
  EXPECT_NEAR(half.high, 0.7634, 5e-5);
  const Interval few = wilson_interval(1, 9);
  EXPECT_NEAR(few.low, 0.0199, 5e-5);
  EXPECT_NEAR(few.high, 0.4350, 5e-5);
  EXPECT_EQ(wilson_interval(0, 7).low, 0);
  EXPECT_EQ(wilson_interval(7, 7).high, 1);
  const Interval open = share_of({1, 8, 0, 3});
  EXPECT_DOUBLE_EQ(open.low, few.low);
  EXPECT_EQ(open.high, 1);
}

ClaimRow row(double value, std::string reading, std::string subject = "bunny") {
  return counted_row(std::move(reading), "leaves", std::move(subject), "", {.above = 0}, value);
}

TEST(NearestVerdict, IsComputedFromTheJudgedRowsOfTheNearestReading) {
  ClaimRow aside = row(1, "stop", "statue");
  aside.unjudged = "a stand-in";
  ClaimRow flagged = row(-1, "another");
  flagged.is_nearest = true;
  const Claim claim{.id = "c",
                    .statement = "More",
                    .source = "abstract",
                    .rows = {row(1, "stop"), row(1, "stop, outer axis", "venus"), row(1, "stopped"),
                             row(-1, "chain"), aside, flagged},
                    .nearest = "stop",
                    .why_nearest = "It is said."};
  const NearestVerdict nearest = nearest_of(claim);
  EXPECT_EQ(nearest.options, "stop");
  EXPECT_EQ(nearest.why, "It is said.");
  EXPECT_EQ(nearest.rows.hold, 2U);
  EXPECT_EQ(nearest.rows.fail, 1U);
  EXPECT_EQ(nearest.rows.open, 0U);
  EXPECT_EQ(nearest.rows.subjects, 2U);
  EXPECT_EQ(nearest.stand, NearestStand::too_few_rows);
  EXPECT_EQ(words_of(nearest),
            "Nearest to the text (stop): 2 of 3 rows hold, on 2 subjects; the share is 21 to 94 %. "
            "It is said.");
  EXPECT_EQ(share_words(nearest), "2 of 3 rows");
  EXPECT_EQ(words_of(nearest_of({.id = "d", .statement = "", .source = "", .nearest = "stop"})),
            "Nearest to the text (stop): no row can be judged.");
}

ClaimRow timed_row(Interval interval, std::string subject) {
  return measured_row("stop", "time", std::move(subject), "", {.above = 0},
                      {interval.low, interval, 10, kLeastProcesses});
}

TEST(NearestVerdict, CountsAndTimesHaveVerdictsOfTheirOwn) {
  Claim claim{.id = "c", .statement = "Cheaper", .source = "abstract", .nearest = "stop"};
  for (const char* const subject : {"bunny", "venus", "teapot", "city"}) {
    for (int i = 0; i < 5; ++i) {
      claim.rows.push_back(row(1, "stop", subject));
    }
    claim.rows.push_back(timed_row({-2, -1}, subject));
  }
  const NearestVerdict nearest = nearest_of(claim);
  EXPECT_EQ(nearest.counted.stand, NearestStand::holds);
  EXPECT_EQ(nearest.measured.stand, NearestStand::fails);
  EXPECT_EQ(stand_of(nearest.rows, claim.scope), NearestStand::mostly_holds);
  EXPECT_EQ(nearest.stand, NearestStand::mixed);
  EXPECT_EQ(shares_words(nearest), "20 of 20 by counts, 0 of 4 by time");
  EXPECT_NE(words_of(nearest).find("By kind: 20 of 20 by counts, 0 of 4 by time (holds, fails)."),
            std::string::npos);
}

TEST(NearestVerdict, AKindOfTooFewRowsLeavesTheVerdictToAllRows) {
  Claim claim{.id = "c", .statement = "Cheaper", .source = "abstract", .nearest = "stop"};
  for (const char* const subject : {"bunny", "venus", "teapot", "city"}) {
    claim.rows.push_back(row(1, "stop", subject));
  }
  claim.rows.push_back(timed_row({-2, -1}, "bunny"));
  const NearestVerdict nearest = nearest_of(claim);
  EXPECT_EQ(nearest.measured.stand, NearestStand::too_few_rows);
  EXPECT_EQ(nearest.stand, stand_of(nearest.rows, claim.scope));
}

TEST(NearestVerdict, AReadingOfALongerNumberIsAnother) {
  const Claim claim{.id = "c",
                    .statement = "",
                    .source = "",
                    .rows = {row(1, "level 1"), row(1, "level 12"), row(1, "level 1; at least")},
                    .nearest = "level 1"};
  EXPECT_TRUE(is_nearest(claim, claim.rows[0]));
  EXPECT_FALSE(is_nearest(claim, claim.rows[1]));
  EXPECT_TRUE(is_nearest(claim, claim.rows[2]));
}

}  // namespace
}  // namespace soms::reproduce
