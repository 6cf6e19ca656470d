#include "thesis/claims/claim.h"

#include "tests/reproduce/trips.h"
#include "thesis/run/result.h"

#include <gtest/gtest.h>

namespace soms::reproduce {
namespace {

constexpr Demand kMore{.above = 0};

ClaimRow measured(double low, double value, double high) {
  return measured_row("", "time", "bunny", "%", {.above = 8},
                      {value, {low, high}, 20, kLeastProcesses});
}

ClaimRow count_row(double value, const std::string& reading = "stop",
                   const std::string& subject = "bunny") {
  return counted_row(reading, "leaves", subject, "", kMore, value);
}

Claim claim(std::vector<ClaimRow> rows) {
  return {.id = "c", .statement = "More", .source = "abstract", .rows = std::move(rows)};
}

TEST(Claim, RowHoldsOnlyIfItsWholeIntervalDoes) {
  EXPECT_EQ(stand_of(measured(8.1, 9, 10)), Verdict::holds);
  EXPECT_EQ(stand_of(measured(7.9, 9, 10)), Verdict::undecided);
  EXPECT_EQ(stand_of(measured(6, 7, 8.1)), Verdict::undecided);
  EXPECT_EQ(stand_of(measured(5, 6, 7.9)), Verdict::does_not_hold);
  EXPECT_EQ(stand_of(measured(5, 6, 8)), Verdict::does_not_hold);
}

TEST(Claim, CountIsOnOneSideOrTheOther) {
  EXPECT_EQ(stand_of(count_row(1)), Verdict::holds);
  EXPECT_EQ(stand_of(count_row(0)), Verdict::does_not_hold);
  EXPECT_EQ(stand_of(count_row(-1)), Verdict::does_not_hold);
  const Demand near{.above = 21, .below = 31};
  EXPECT_EQ(stand_of(counted_row("", "m", "s", "%", near, 26)), Verdict::holds);
  EXPECT_EQ(stand_of(counted_row("", "m", "s", "%", near, 31)), Verdict::does_not_hold);
}

TEST(Claim, VerdictFollowsFromTheRows) {
  EXPECT_EQ(verdict_of(claim({})), Verdict::cannot_be_checked);
  EXPECT_EQ(verdict_of(claim({count_row(1), count_row(2)})), Verdict::holds);
  EXPECT_EQ(verdict_of(claim({count_row(1), count_row(-2, "stop", "venus")})),
            Verdict::holds_on_some);
  EXPECT_EQ(verdict_of(claim({count_row(-1), count_row(-2)})), Verdict::does_not_hold);
  EXPECT_EQ(verdict_of(claim({count_row(-1), measured(7, 8, 9)})), Verdict::undecided);
  EXPECT_EQ(verdict_of(claim({count_row(1), measured(7, 8, 9)})), Verdict::holds_on_some);
}

std::vector<ClaimRow> line_on(std::size_t subjects, double value, const std::string& reading) {
  std::vector<ClaimRow> rows;
  for (std::size_t i = 0; i < subjects; ++i) {
    rows.push_back(count_row(value, reading, "model " + std::to_string(i)));
  }
  return rows;
}

TEST(Claim, AChanceLineDoesNotDecide) {
  const auto verdict = [](Scope scope, std::size_t subjects, int lines) {
    Claim one = claim(line_on(subjects, -1, "next_axis"));
    for (int i = 0; i < lines; ++i) {
      const std::vector<ClaimRow> line = line_on(subjects, 1, "level " + std::to_string(i));
      one.rows.insert(one.rows.end(), line.begin(), line.end());
    }
    one.scope = scope;
    return verdict_of(one);
  };
  EXPECT_EQ(verdict(Scope::comparison, 3, 1), Verdict::holds_under);
  EXPECT_EQ(verdict(Scope::comparison, 2, 1), Verdict::holds_on_some);
  EXPECT_EQ(verdict(Scope::comparison, 2, 50), Verdict::holds_on_some);
  EXPECT_EQ(verdict(Scope::figure, 1, 1), Verdict::holds_on_some);
  EXPECT_EQ(verdict(Scope::figure, 1, 2), Verdict::holds_on_some);
  EXPECT_EQ(verdict(Scope::figure, 1, 3), Verdict::holds_under);
}

TEST(Claim, RowsThatAreNotJudgedMakeNoLineWhole) {
  Claim one = claim(line_on(3, 1, "stop"));
  one.rows[2].unjudged = "a toy set";
  one.rows.push_back(count_row(-1, "chain"));
  EXPECT_EQ(verdict_of(one), Verdict::holds_on_some);
}

TEST(Claim, RowsThatAreNotJudgedDecideNothing) {
  ClaimRow aside = count_row(5);
  aside.unjudged = "a stand-in";
  EXPECT_EQ(verdict_of(claim({aside})), Verdict::cannot_be_checked);
  EXPECT_EQ(verdict_of(claim({aside, count_row(-1)})), Verdict::does_not_hold);
  EXPECT_EQ(where(claim({aside})), "No row of its matrix can be judged.");
}

TEST(Claim, SaysWhereItHolds) {
  EXPECT_EQ(where(claim({count_row(1), count_row(-2, "stop", "venus"), count_row(3, "chain"),
                         count_row(0, "next axis")})),
            "Holds in 2 of 4 rows. On every subject: chain (1). On some: stop (1 of 2). On none: "
            "next axis.");
  EXPECT_EQ(where(claim({count_row(-1), measured(7, 8, 9)})),
            "Holds in 0 of 2 rows, undecided in 1.");
}

TEST(Claim, MarksTheReadingNearestToTheText) {
  Claim one = claim({count_row(1), count_row(-2, "stop", "venus"), count_row(3, "chain")});
  one.nearest = "stop";
  EXPECT_EQ(trips::cell(claim_table(one), 0, "nearest"), "yes");
  EXPECT_EQ(trips::cell(claim_table(one), 2, "nearest"), "");
}

TEST(Claim, MatrixHasALineForEachReadingAndAColumnForEachSubject) {
  ClaimRow aside = count_row(5, "chain");
  aside.unjudged = "a stand-in";
  EXPECT_EQ(to_csv(matrix_table(claim({count_row(1), count_row(-2, "stop", "venus"), aside}))),
            "metric,reading,demanded,bunny,venus\nleaves,stop,> 0,\u2713 1,\u2717 "
            "-2\nleaves,chain,> 0,(5),\n");
}

TEST(Claim, SaysTheShareOfRowsAndReadableDemands) {
  EXPECT_EQ(share_words(claim({count_row(1), count_row(-2)})), "1 of 2 rows");
  EXPECT_EQ(share_words(claim({})), "");
  EXPECT_EQ(words_of(Demand{.above = 6.5, .below = 7.5}), "= 7");
  EXPECT_EQ(words_of(Demand{.above = 21, .below = 31}), "21 to 31");
  EXPECT_EQ(words_of(Demand{.below = 1}), "< 1");
}

TEST(Claim, TableHasAllThatTheVerdictNeeds) {
  const Table table = claim_table(claim({count_row(12), measured(7, 9, 10)}));
  EXPECT_EQ(table.id, "claim_c");
  EXPECT_EQ(trips::cell(table, 0, "stands"), "holds");
  EXPECT_EQ(trips::cell(table, 1, "stands"), "undecided");
  EXPECT_EQ(to_csv(table),
            "metric,reading,nearest,subject,unit,above,below,value,low,high,rounds,processes,"
            "stands,unjudged,on_stand_in\n"
            "leaves,stop,,bunny,,0,,12,,,,,holds,,\n"
            "time,,,bunny,%,8,,9,7,10,20,5,undecided,,\n");
}

TEST(Claim, NumbersAreReadable) {
  EXPECT_EQ(words_of(measured(7, 9.04, 10)), "+9.0 (+7.0 to +10.0) %");
  EXPECT_EQ(words_of(count_row(12)), "12");
}

TEST(ClaimRow, FewerThanFiveProcessesDecideNothing) {
  ClaimRow row = measured(9, 10, 11);
  ASSERT_EQ(stand_of(row), Verdict::holds);
  row.processes = kLeastProcesses - 1;
  EXPECT_EQ(stand_of(row), Verdict::undecided);
  row.interval.reset();
  EXPECT_EQ(stand_of(row), Verdict::holds) << "a count needs no process";
}

}  // namespace
}  // namespace soms::reproduce
