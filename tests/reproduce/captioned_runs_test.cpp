// Figures 4.23 to 4.40 and 5.1, which are made from their captions: what their runs count.
#include "tests/reproduce/trips.h"
#include "tests/reproduce/well_formed.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>

namespace soms::reproduce {
namespace {

using trips::cell;
using trips::run_quick;
using trips::table_of;

const Models& models() {
  static const Models some = trips::small_models();
  return some;
}

Table table(const std::string& figure, const std::string& name) {
  std::string id = "figure_" + figure + "_" + name;
  std::string item = "figure-" + figure;
  item.replace(item.find('_'), 1, ".");
  return table_of(run_quick(item, models()), id);
}

/// A row as text.
std::string run_row(const Table& of, std::size_t row) {
  std::string words;
  for (const Column& column : of.columns) {
    words += (words.empty() ? "" : ",") + cell(of, row, column.name);
  }
  return words;
}

TEST(CaptionedRuns, AreWellFormedAndSmall) {
  for (const char* const item :
       {"figure-4.23", "figure-4.24", "figure-4.25", "figure-4.26", "figure-4.27", "figure-4.28",
        "figure-4.29", "figure-4.31", "figure-4.32", "figure-4.33", "figure-4.34", "figure-4.36",
        "figure-4.37", "figure-4.39", "figure-4.40", "figure-5.1"}) {
    const Result result = run_quick(item, models());
    ASSERT_EQ(result.figures.size(), 1U) << item;
    EXPECT_FALSE(result.tables.empty()) << item;
    EXPECT_EQ(soms::test::markup_fault(result.figures[0].svg), "") << item;
    EXPECT_LT(result.figures[0].svg.size(), 400'000U) << item;
    EXPECT_FALSE(result.figures[0].timed) << item;
  }
}

TEST(CaptionedRuns, CenterOfATriangleDependsOnCornerC) {
  const std::string csv = to_csv(table("4_23", "centers"));
  // By hand: C is (6, 9), f the middle of (0, 0) and (12, 0); then C is (0, 0).
  EXPECT_NE(csv.find("isosceles,2,6,0,6,4.5,6,3,6,4.5,yes"), std::string::npos) << csv;
  EXPECT_NE(csv.find("isosceles,0,9,4.5,4.5,2.25,6,3,6,4.5,no"), std::string::npos) << csv;
  EXPECT_NE(csv.find("oblique,2,4,0,10,4,"), std::string::npos) << csv;
}

TEST(CaptionedRuns, SidesAreCountedTriangleByTriangle) {
  const Table steps = table("4_24", "steps");
  ASSERT_EQ(steps.rows.size(), 4U);
  EXPECT_EQ(cell(steps, 0, "side"), "right");
  EXPECT_EQ(cell(steps, 3, "left_count"), "2");
  EXPECT_EQ(cell(steps, 3, "right_count"), "2");
  const Table stored = table("4_25", "triangles");
  EXPECT_EQ(run_row(stored, 4), "1,0,1");
  EXPECT_EQ(run_row(stored, 7), "2,1,3");
}

TEST(CaptionedRuns, NodesAreDividedDepthFirst) {
  const Table steps = table("4_26", "steps");
  ASSERT_EQ(steps.rows.size(), 7U);
  EXPECT_EQ(cell(steps, 2, "tree_id"), "3");
  EXPECT_EQ(cell(steps, 2, "outcome"), "leaf: one triangle");
  const Table grid = table("4_28", "steps");
  ASSERT_EQ(grid.rows.size(), 15U);
  EXPECT_EQ(run_row(grid, 0), "0,0,16,x,,8,8,divided");
  EXPECT_EQ(run_row(grid, 3), "7,3,2,,,,,leaf: last level");
}

TEST(CaptionedRuns, ArraysKeepPlacesOfNodesThatDoNotExist) {
  const Table arrays = table("4_27", "arrays");
  ASSERT_EQ(arrays.rows.size(), 14U);
  EXPECT_EQ(run_row(arrays, 2), "one_large,2,yes,2,3 0,6");
  EXPECT_EQ(run_row(arrays, 7), "one_midpoint,0,yes,3,0 1 2,9");
  EXPECT_EQ(run_row(arrays, 8), "one_midpoint,1,no,,,");
}

TEST(CaptionedRuns, TraversalsOfTheSmallTreesMakeNineTests) {
  const Table steps = table("4_31", "steps");
  ASSERT_EQ(steps.rows.size(), 9U);
  EXPECT_EQ(cell(steps, 4, "pair"), "5|3");
  const Table stack = table("4_36", "steps");
  ASSERT_EQ(stack.rows.size(), 9U);
  EXPECT_EQ(run_row(stack, 0), "1,0|0,overlap: push 4,1|1 1|2 2|1 2|2");
  EXPECT_EQ(run_row(stack, 8), "9,2|2,apart,empty");
  const Table nodes = table("4_34", "nodes");
  ASSERT_EQ(nodes.rows.size(), 15U);
  EXPECT_EQ(run_row(nodes, 2), "2,yes,5,yes");
  EXPECT_EQ(run_row(nodes, 3), "3,yes,7,no");
}

TEST(CaptionedRuns, RootsMeetInSeventeenOf49Frames) {
  const Table roots = table("4_32", "roots");
  ASSERT_EQ(roots.rows.size(), 7U);
  for (std::size_t row = 0; row < 6; ++row) {
    EXPECT_EQ(cell(roots, row, "roots_overlap"), "17");
    EXPECT_EQ(cell(roots, row, "ended_there"), "32");
  }
}

TEST(CaptionedRuns, BoxesAreApartIfOneAxisIs) {
  const Table boxes = table("4_33", "boxes");
  ASSERT_EQ(boxes.rows.size(), 5U);
  EXPECT_EQ(run_row(boxes, 0), "overlap,yes,yes,yes,yes");
  EXPECT_EQ(run_row(boxes, 1), "touching,yes,yes,yes,yes");
  EXPECT_EQ(run_row(boxes, 4), "apart_z,yes,yes,no,no");
}

TEST(CaptionedRuns, GeneratedCityIsFourPartsAndRoads) {
  const Models cities = find_models({}, {.scenes = true});
  const Table parts = table_of(run_quick("figure-4.40", cities), "figure_4_40_parts");
  ASSERT_EQ(parts.rows.size(), 15U);
  const std::vector<std::string> counts{"1434", "1350", "1330", "1490", "68",   "1418", "1418",
                                        "1418", "1418", "0",    "1454", "1454", "1442", "1322"};
  for (std::size_t row = 0; row < counts.size(); ++row) {
    EXPECT_EQ(cell(parts, row, "triangles"), counts[row]) << row;
  }
  const Table objects = table_of(run_quick("figure-4.39", cities), "figure_4_39_objects");
  ASSERT_EQ(objects.rows.size(), 3U);
  EXPECT_EQ(run_row(objects, 0), "terrain,128,128");
  EXPECT_EQ(run_row(objects, 2), "signs,280,1434");
}

TEST(CaptionedRuns, PartOneOfManyObjectsIsDrawnInFourStages) {
  Models many = trips::small_models();
  Mesh mesh = *many.scenes.at(0).mesh;
  mesh.parts.clear();
  for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id) {
    mesh.parts.push_back({"object " + std::to_string(id), Part::kNoParent, id, 1});
  }
  many.scenes.at(0).mesh = std::make_shared<const Mesh>(std::move(mesh));
  const Result result = run_quick("figure-4.39", many);
  const std::size_t objects = table_of(result, "figure_4_39_objects").rows.size();
  ASSERT_GT(objects, 4U);
  EXPECT_EQ(soms::test::count_of(result.figures.at(0).alt, " triangles"), 4U);
  EXPECT_NE(result.figures.at(0).alt.find("with all " + std::to_string(objects) + " objects"),
            std::string::npos)
      << result.figures.at(0).alt;
}

TEST(CaptionedRuns, TestingProcedureHasEveryTestOfChapter5Once) {
  const Table steps = table("5_1", "steps");
  std::multiset<std::string> items;
  for (std::size_t row = 0; row < steps.rows.size(); ++row) {
    items.insert(cell(steps, row, "item"));
  }
  for (const Experiment& experiment : experiments()) {
    const std::string item(experiment.item);
    const bool chapter_5 = item.starts_with("table-5.") || item.starts_with("figure-5.");
    EXPECT_EQ(items.count(item) == 1,
              (chapter_5 && item != "figure-5.1") || item.starts_with("table-3."))
        << item;
  }
}

TEST(CaptionedRuns, CountsOfTheBunnyAreGolden) {
  SOMS_NEEDS_OUTSIDE_DATA("counts of the bunny's trees");
  const Models bunny = find_models(*soms::test::outside_data(""), {.objects = true});
  Models all = bunny;
  all.scenes = trips::small_models().scenes;
  const Table slots = table_of(run_quick("figure-4.27", all), "figure_4_27_slots");
  EXPECT_EQ(cell(slots, 0, "slots"), "32767");
  EXPECT_EQ(cell(slots, 0, "used"), "1847");
  const Table levels = table_of(run_quick("figure-4.29", all), "figure_4_29_levels");
  ASSERT_EQ(levels.rows.size(), 15U);
  EXPECT_EQ(run_row(levels, 5), "6,63,32,0,192");
  EXPECT_EQ(run_row(levels, 14), "15,1847,924,920,5544");
  const Table descents = table_of(run_quick("figure-4.37", all), "figure_4_37_descents");
  const std::vector<std::string> tests{"96407", "117039", "54249", "50987", "48619"};
  for (std::size_t row = 0; row < tests.size(); ++row) {
    EXPECT_EQ(cell(descents, row, "box_tests"), tests[row]);
    EXPECT_EQ(cell(descents, row, "leaf_pairs"), "7417");
  }
}

}  // namespace
}  // namespace soms::reproduce
