// Figures 3.9 and 4.1 to 4.44: what they show and what they say of it.
#include "tests/reproduce/trips.h"
#include "tests/reproduce/well_formed.h"

#include <gtest/gtest.h>

#include <memory>

namespace soms::reproduce {
namespace {

using trips::cell;
using trips::run_quick;
using trips::table_of;

const Models& shared_models() {
  static const Models some = trips::small_models();
  return some;
}

std::size_t rows_where(const Table& table, std::string_view column, std::string_view value) {
  std::size_t count = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    count += cell(table, row, column) == value ? 1U : 0U;
  }
  return count;
}

TEST(DrawnRules, FiguresOfChapters3And4AreWellFormedAndSmall) {
  for (const char* const item :
       {"figure-3.9", "figure-4.1", "figure-4.2", "figure-4.3", "figure-4.4", "figure-4.5",
        "figure-4.6", "figure-4.7", "figure-4.41", "figure-4.42", "figure-4.44"}) {
    const Result result = run_quick(item, shared_models());
    EXPECT_FALSE(result.figures.empty()) << item;
    for (const Figure& figure : result.figures) {
      EXPECT_EQ(soms::test::markup_fault(figure.svg), "") << item;
      EXPECT_LT(figure.svg.size(), 400'000U) << item;
      EXPECT_FALSE(figure.alt.empty()) << item;
      EXPECT_FALSE(figure.timed) << item;
    }
  }
}

TEST(DrawnRules, TheTestObjectStandsLeftOfAScene) {
  const Figure figure = run_quick("figure-3.9", shared_models()).figures.at(0);
  EXPECT_EQ(figure.alt.find("Test object: "), 0U) << figure.alt;
  EXPECT_NE(figure.alt.find("500 times as large"), std::string::npos) << figure.alt;
  EXPECT_NE(figure.alt.find(shared_models().scenes.at(0).title), std::string::npos) << figure.alt;
}

TEST(DrawnRules, CommonRulesAreObjectMedianObjectMeanAndSpatialMedian) {
  const Table table = table_of(run_quick("figure-4.1", shared_models()), "figure_4_1_planes");
  EXPECT_EQ(cell(table, 0, "rule"), "object_median");
  EXPECT_EQ(cell(table, 1, "rule"), "object_mean");
  EXPECT_EQ(cell(table, 2, "rule"), "spatial_median");
  EXPECT_EQ(rows_where(table, "rule", "soms"), 0U);
}

TEST(DrawnRules, SomsKeepsMoreLevelsOfTheSmallSetBalanced) {
  const Result result = run_quick("figure-4.2", shared_models());
  const Table& table = table_of(result, "figure_4_2_levels");
  // By hand: the large triangle moves spatial median's plane, so that two midpoints of sixteen, of
  // one x, are left on its other side; SOMS halves the grid four times.
  EXPECT_EQ(cell(table, 0, "rule"), "spatial_median");
  EXPECT_EQ(cell(table, 0, "balanced_level"), "2");
  EXPECT_EQ(cell(table, 0, "fewest_triangles"), "2");
  EXPECT_EQ(cell(table, 0, "most_triangles"), "14");
  EXPECT_EQ(cell(table, 1, "rule"), "soms");
  EXPECT_EQ(cell(table, 1, "balanced_level"), "5");
  EXPECT_EQ(cell(table, 7, "nodes"), "16");
  EXPECT_NE(result.figures.at(0).caption.find("full to level 2, that of SOMS to level 5"),
            std::string::npos)
      << result.figures.at(0).caption;
}

TEST(DrawnRules, SpatialMedianDividesNoSetOfFigure4Dot3) {
  const Table table = table_of(run_quick("figure-4.3", shared_models()), "figure_4_3_planes");
  ASSERT_EQ(table.rows.size(), 8U);
  for (std::size_t row = 0; row < table.rows.size(); row += 2) {
    const std::string set = cell(table, row, "set");
    EXPECT_EQ(cell(table, row, "rule"), "spatial_median");
    EXPECT_EQ(cell(table, row, "divides"), "no") << set;
    EXPECT_EQ(cell(table, row + 1, "rule"), "soms");
    EXPECT_EQ(cell(table, row + 1, "divides"), set == "one_midpoint" ? "no" : "yes") << set;
  }
}

TEST(DrawnRules, PseudoCodeShowsWhatSomsDoesWithASet) {
  const Result result = run_quick("figure-4.5", shared_models());
  const std::string& svg = result.figures.at(0).svg;
  for (const char* const words :
       {"(8, 3.25) (1, 3) (3, 3) (5, 3)", "(1, 3) to (8, 3.25)", "x = 4.5", "2 left, 2 right"}) {
    EXPECT_EQ(soms::test::count_of(svg, words), 1U) << words;
  }
}

TEST(DrawnRules, RulesInSpaceStandInTheOrderOfTheThesis) {
  const Table table = table_of(run_quick("figure-4.7", shared_models()), "figure_4_7_planes");
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(cell(table, 0, "rule"), "object_median");
  EXPECT_EQ(cell(table, 1, "rule"), "spatial_median");
  EXPECT_EQ(cell(table, 2, "rule"), "object_mean");
  EXPECT_EQ(cell(table, 3, "rule"), "soms");
}

TEST(DrawnRules, ACityIsReadBackAsItWasWritten) {
  const Models cities = find_models({}, {.scenes = true});
  const Table table = table_of(run_quick("figure-4.43", cities), "figure_4_43_reading");
  ASSERT_EQ(table.rows.size(), cities.scenes.size());
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    EXPECT_EQ(cell(table, row, "equal"), "yes");
    EXPECT_EQ(cell(table, row, "bytes"), std::to_string(cities.scenes[row].bytes));
    EXPECT_EQ(cell(table, row, "hash_read"), cell(table, row, "hash_written"));
    EXPECT_EQ(cell(table, row, "faces_read"),
              std::to_string(cities.scenes[row].mesh->triangles.size()));
  }
}

TEST(DrawnRules, ACityThatThe3DSFileCannotHoldIsReportedAsUnequal) {
  Models models = trips::small_models();
  Mesh mesh = *models.scenes.at(0).mesh;
  mesh.vertices.at(0).x += 1e-12;  // 3DS keeps single precision
  models.scenes.at(0).hash = corner_hash(mesh);
  models.scenes.at(0).mesh = std::make_shared<const Mesh>(std::move(mesh));
  const Result result = run_quick("figure-4.43", models);
  EXPECT_EQ(cell(table_of(result, "figure_4_43_reading"), 0, "equal"), "no");
}

TEST(DrawnRules, TheCitysTreeIsShownAtFourLevelsSomsFirst) {
  const Result result = run_quick("figure-4.44", shared_models());
  ASSERT_EQ(result.figures.size(), 2U);
  EXPECT_EQ(result.figures[0].id, "figure_4_44");
  EXPECT_EQ(result.figures[0].caption, "Boxes of the tree of SOMS at levels 1, 3, 5 and 7.");
  const Table& table = table_of(result, "figure_4_44_levels");
  EXPECT_EQ(rows_where(table, "rule", "soms"), 4U);
  EXPECT_EQ(cell(table, 0, "nodes"), "1");
  EXPECT_EQ(cell(table, 3, "level"), "7");
}

}  // namespace
}  // namespace soms::reproduce
