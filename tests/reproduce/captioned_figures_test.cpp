// Figures 4.8 to 4.22, made from their captions: their counted values.
#include "tests/reproduce/trips.h"
#include "tests/reproduce/well_formed.h"
#include "thesis/trees/toy_sets.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace soms::reproduce {
namespace {

using soms::test::count_of;
using trips::run_quick;

Result result_of(int number) {
  return run_quick(fmt::format("figure-4.{}", number), {});
}

/// The table of a figure that has one.
Table only_table(int number) {
  const Result result = result_of(number);
  EXPECT_EQ(result.tables.size(), 1U) << number;
  return result.tables.at(0);
}

/// A row as in the CSV.
std::string row_of(const Table& table, std::size_t row) {
  const Table one{
      .id = table.id, .caption = "", .columns = table.columns, .rows = {table.rows.at(row)}};
  const std::string csv = to_csv(one);
  const std::size_t begin = csv.find('\n') + 1;
  return csv.substr(begin, csv.find_last_not_of("\r\n") + 1 - begin);
}

TEST(CaptionedFigures, AreWellFormedUntimedAndSayWhereTheyComeFrom) {
  for (int number = 8; number <= 22; ++number) {
    const Result result = result_of(number);
    ASSERT_FALSE(result.figures.empty()) << number;
    EXPECT_EQ(result.figures[0].id, fmt::format("figure_4_{}", number));
    const std::string& caption = result.figures[0].caption;
    const bool names_source = caption.find("caption") != std::string::npos ||
                              caption.find("not available to us") != std::string::npos ||
                              caption.find("not known") != std::string::npos;
    EXPECT_TRUE(names_source) << caption;
    for (const Figure& figure : result.figures) {
      EXPECT_EQ(soms::test::markup_fault(figure.svg), "") << number;
      EXPECT_FALSE(figure.alt.empty()) << number;
      EXPECT_FALSE(figure.timed) << number;
    }
    for (const Table& table : result.tables) {
      for (const Column& column : table.columns) {
        EXPECT_EQ(column.kind, ColumnKind::counted) << column.name;
      }
    }
  }
}

TEST(CaptionedFigures, LoopsFindTheBoxOfTheSet) {
  const Table table = only_table(8);
  ASSERT_EQ(table.rows.size(), 12U);
  EXPECT_EQ(row_of(table, 0),
            "0,0,2,2,2,2,2,2,2,2,2,"
            "\"least x, greatest x, least y, greatest y, least z, greatest z\"");
  EXPECT_EQ(row_of(table, 3), "1,0,5,1,1,2,1,1,5,4,3,\"greatest x, least y, least z\"");
  EXPECT_EQ(row_of(table, 11), "3,2,5,3,2,0,1,1,7,6,5,nothing");
  EXPECT_EQ(bounds(space_toy_set().mesh), (Box{{0, 1, 1}, {7, 6, 5}}));
}

TEST(CaptionedFigures, CornersAreNumberedByTheBitsOfTheirAxes) {
  const Table corners = only_table(9);
  ASSERT_EQ(corners.rows.size(), 8U);
  EXPECT_EQ(row_of(corners, 0), "least,least,least,0,1,1");
  EXPECT_EQ(row_of(corners, 6), "least,greatest,greatest,0,6,5");
  const Table numbers = only_table(10);
  EXPECT_EQ(row_of(numbers, 1), "1,001,7,1,1,0 3 5");
  EXPECT_EQ(row_of(numbers, 6), "6,110,0,6,5,7 4 2");
}

TEST(CaptionedFigures, FacesGoCounterClockwiseAsSeenFromOutside) {
  const Table faces = only_table(11);
  ASSERT_EQ(faces.rows.size(), 6U);
  EXPECT_EQ(row_of(faces, 0), "1,least z,0 2 3 1,no");
  EXPECT_EQ(row_of(faces, 1), "2,greatest z,4 5 7 6,yes");
  EXPECT_EQ(row_of(faces, 2), "3,least y,0 1 5 4,yes");
  EXPECT_EQ(row_of(faces, 3), "4,greatest y,2 6 7 3,no");
  EXPECT_EQ(row_of(faces, 4), "5,least x,0 4 6 2,no");
  EXPECT_EQ(row_of(faces, 5), "6,greatest x,1 3 7 5,yes");
  const Result drawn = result_of(12);
  const Table& calls = drawn.tables.at(0);
  ASSERT_EQ(calls.rows.size(), 24U);
  EXPECT_EQ(row_of(calls, 0), "1,1,least z,0,0,1,1");
  EXPECT_EQ(row_of(calls, 23), "24,6,greatest x,5,7,1,5");
  for (const char* const title : {">1: least z<", ">2: greatest z<", ">6: greatest x<"}) {
    EXPECT_EQ(count_of(drawn.figures.at(0).svg, title), 1U) << title;
  }
  EXPECT_NE(drawn.remarks.at(0).find("here 3 of 6"), std::string::npos) << drawn.remarks.at(0);
}

TEST(CaptionedFigures, ReboxIsLooserThanRefitWhereTheSetTurnsAndEqualWhereItShifts) {
  const Table table = only_table(13);
  ASSERT_EQ(table.rows.size(), 35U);  // 7 nodes: before, and by two ways in two poses
  EXPECT_EQ(row_of(table, 0), "none,0,4,before,0,1,1,7,6,5,140,");
  EXPECT_EQ(row_of(table, 7), "shift,0,4,refit,2,2,1,9,7,5,140,");
  EXPECT_EQ(row_of(table, 8), "shift,0,4,rebox,2,2,1,9,7,5,140,1");
  // By hand: x' = 0.8 x - 0.6 y + 2 and y' = 0.6 x + 0.8 y + 1. Of the triangles' corners (0, 5)
  // and (7, 2) give the least and the greatest x', (2, 2) and (6, 6) of y'; of the box's corners
  // (0, 6), (7, 1), (0, 1) and (7, 6) do.
  EXPECT_EQ(row_of(table, 21), "turn and shift,0,4,refit,-1,3.8,1,6.4,9.4,5,165.76,");
  EXPECT_EQ(row_of(table, 22), "turn and shift,0,4,rebox,-1.6,1.8,1,7,10,5,282.08,1.70174");
}

TEST(CaptionedFigures, TheClassHasASlotForEachTreeId) {
  const Table fields = only_table(14);
  ASSERT_EQ(fields.rows.size(), 5U);
  EXPECT_EQ(row_of(fields, 0),
            "bounds,48,least and greatest point,\"(0.25, 0.25, 0) to (7.75, 4.25, 0)\","
            "\"(4.25, 0.25, 0) to (7.75, 4.25, 0)\"");
  EXPECT_EQ(row_of(fields, 2), "count,4,triangles below,8,4");
  const Table levels = only_table(15);
  ASSERT_EQ(levels.rows.size(), 15U);
  EXPECT_EQ(row_of(levels, 0), "1,1,64,1");
  EXPECT_EQ(row_of(levels, 3), "4,15,960,11");
  EXPECT_EQ(row_of(levels, 4), "5,31,1984,15");
  EXPECT_EQ(row_of(levels, 14), "15,32767,2097088,15");
}

TEST(CaptionedFigures, EightTrianglesMakeACompleteTreeOfDepth3) {
  const Result result = result_of(16);
  const Table& table = result.tables.at(0);
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(row_of(table, 0), "0,1,1,0,0,8");
  EXPECT_EQ(row_of(table, 1), "1,2,2,1,2,4");
  EXPECT_EQ(row_of(table, 2), "2,3,4,3,6,2");
  EXPECT_EQ(row_of(table, 3), "3,4,8,7,14,1");
  ASSERT_EQ(result.figures.size(), 2U);
  EXPECT_EQ(count_of(result.figures[0].svg, "<circle"), 15U);
}

TEST(CaptionedFigures, SplitIsCalledDepthFirstUntilTheLastLevel) {
  const Table table = only_table(17);
  ASSERT_EQ(table.rows.size(), 11U);
  EXPECT_EQ(row_of(table, 0), "1,0,0,0 1 2 3 4 5 6 7,\"6 left, 2 right\"");
  EXPECT_EQ(row_of(table, 3), "4,7,3,0 2,leaf: the last level");
  EXPECT_EQ(row_of(table, 4), "5,8,3,1,leaf: one triangle");
  EXPECT_EQ(row_of(table, 10), "11,6,2,7,leaf: one triangle");
}

TEST(CaptionedFigures, DepthFollowsFromTheTreeId) {
  const Table table = only_table(18);
  ASSERT_EQ(table.rows.size(), 15U);
  EXPECT_EQ(row_of(table, 0), "0,0,0,1,1");
  EXPECT_EQ(row_of(table, 10), "10,10 4 1 0,3,4,1011");
  EXPECT_EQ(row_of(table, 14), "20,20 9 4 1 0,4,5,10101");
}

TEST(CaptionedFigures, NodesAreMadeInPairs) {
  const Table children = only_table(19);
  ASSERT_EQ(children.rows.size(), 7U);
  EXPECT_EQ(row_of(children, 0), "0,0 1 2 3 4 5 6 7,1,0 1 4 5,2,2 3 6 7");
  EXPECT_EQ(row_of(children, 6), "6,6 7,13,6,14,7");
  const Table nodes = only_table(20);
  ASSERT_EQ(nodes.rows.size(), 15U);
  EXPECT_EQ(row_of(nodes, 0), "0,8,0 1 2 3 4 5 6 7,0.25,0.25,7.75,4.25");
  EXPECT_EQ(row_of(nodes, 4), "4,2,4 5,0.25,2.75,3.75,4.25");
  EXPECT_EQ(row_of(nodes, 14), "14,1,7,6.25,2.75,7.75,4.25");
}

TEST(CaptionedFigures, ParentsAreHalvesRoundedDown) {
  const Result result = result_of(21);
  const Table& table = result.tables.at(0);
  ASSERT_EQ(table.rows.size(), 15U);
  EXPECT_EQ(row_of(table, 0), "0,root,,,0,8");
  EXPECT_EQ(row_of(table, 1), "1,left,0,0,1,4");
  EXPECT_EQ(row_of(table, 4), "4,right,1.5,1,2,2");
  EXPECT_EQ(row_of(table, 14), "14,right,6.5,6,3,1");
  EXPECT_EQ(count_of(result.figures.at(0).svg, ">(4 - 1)/2 = 1<"), 2U);  // and its halo
  EXPECT_EQ(result.remarks.at(0).find("(4 - 1)/2 is 1.5: the caption's 1 "), 0U);
}

TEST(CaptionedFigures, OfEqualExtentsTheFirstAxisIsTheLongest) {
  const Table table = only_table(22);
  ASSERT_EQ(table.rows.size(), 7U);
  EXPECT_EQ(row_of(table, 2), "z longest,1,2,6,no,no,yes,z");
  EXPECT_EQ(row_of(table, 3), "x and y equal,6,6,1,yes,no,no,x");
  EXPECT_EQ(row_of(table, 4), "x and z equal,6,1,6,yes,no,no,x");
  EXPECT_EQ(row_of(table, 5), "y and z equal,1,6,6,no,yes,no,y");
  EXPECT_EQ(row_of(table, 6), "all equal,6,6,6,yes,no,no,x");
}

}  // namespace
}  // namespace soms::reproduce
