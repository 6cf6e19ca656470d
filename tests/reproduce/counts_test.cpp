// Every count that the experiments show, against thesis_counts.csv, which an independent
// implementation wrote.
#include "thesis/run/counts.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/tree/option_names.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/golden_tables.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>

namespace soms::reproduce {
namespace {

constexpr std::array<std::string_view, 6> kKey{"model",     "rule",       "midpoint",
                                               "axis_from", "empty_side", "level"};

/// Numbers by the names of their columns.
using CountsByName = std::map<std::string, std::string>;
using Golden = std::map<std::string, CountsByName>;

Golden golden_rows() {
  Golden golden;
  const auto& columns = golden_trees().columns;
  for (const GoldenTree& tree :
       read_golden(test::data("thesis/thesis_counts.csv").parent_path()).trees) {
    CountsByName row;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      row[std::string(columns[k])] = tree.row.cells[k];
    }
    std::string key;
    for (const std::string_view name : kKey) {
      key += row.at(std::string(name)) + ",";
    }
    golden[key] = row;
  }
  return golden;
}

const Golden& golden() {
  static const Golden rows = golden_rows();
  return rows;
}

std::string cell_text(const Cell& cell) {
  if (const auto* const count = std::get_if<std::int64_t>(&cell)) {
    return std::to_string(*count);
  }
  const auto* const text = std::get_if<std::string>(&cell);
  return text == nullptr ? "" : *text;
}

CountsByName named_cells(const Table& table, const std::vector<Cell>& row) {
  CountsByName cells;
  for (std::size_t i = 0; i < row.size(); ++i) {
    cells[table.columns[i].name] = cell_text(row[i]);
  }
  return cells;
}

/// Key of the golden row that has these counts; rows with other options have none.
std::string key_of(CountsByName cells) {
  if (cells.contains("c_vertex") && cells["midpoint"] == "thesis" && cells["c_vertex"] != "2") {
    return "";
  }
  if (cells.contains("per_leaf") && cells["per_leaf"] != "1") {
    return "";
  }
  if (cells.contains("root_level") && cells["root_level"] == "0") {
    cells["level"] = std::to_string(std::stoi(cells["level"]) + 1);
  }
  cells.try_emplace("midpoint", "thesis");
  std::string key;
  for (const std::string_view name : kKey) {
    key += cells[std::string(name)] + ",";
  }
  return key;
}

/// How many rows of a table were compared with golden ones.
std::size_t rows_in_golden(const Table& table) {
  std::size_t compared = 0;
  for (const std::vector<Cell>& row : table.rows) {
    CountsByName cells = named_cells(table, row);
    const auto found = golden().find(key_of(cells));
    if (found == golden().end()) {
      continue;
    }
    cells.erase("level");
    for (const auto& [name, value] : cells) {
      if (const auto expected = found->second.find(name); expected != found->second.end()) {
        EXPECT_EQ(value, expected->second) << table.id << " " << found->first << " " << name;
      }
    }
    ++compared;
  }
  return compared;
}

Models with_scenes_only() {
  return find_models({}, {.scenes = true});
}

Models models_of_thesis() {
  return find_models(*test::outside_data(""), {.objects = true, .scenes = true});
}

/// A model of a few triangles, for what does not depend on which model it is.
Model small_model(std::string name, Mesh mesh, bool stand_in) {
  Model model;
  model.title = name + " for a test";
  model.name = std::move(name);
  model.file = stand_in ? "" : model.name + ".ply";
  model.stand_in = stand_in;
  model.hash = corner_hash(mesh);
  model.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return model;
}

TEST(Counts, TablesOfTheScenesShowTheGoldenCounts) {
  const Models models = with_scenes_only();
  ASSERT_EQ(models.scenes.size(), 3U);
  for (const auto run : {table_5_9, table_5_10, table_5_11}) {
    const Result result = run({.models = models});
    ASSERT_EQ(result.tables.size(), 1U);
    // Object median, and object mean, spatial median and SOMS on two axes with each policy.
    EXPECT_EQ(rows_in_golden(result.tables.front()), 3U * (1 + 4 * 4));
  }
}

TEST(Counts, TablesOfTheObjectsShowTheGoldenCounts) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  SOMS_NEEDS_OUTSIDE_DATA("tables 5.3 to 5.5 of four objects");
  const Models models = models_of_thesis();
  ASSERT_EQ(models.objects.size(), 4U);
  const Context context{.models = models};
  EXPECT_EQ(rows_in_golden(table_5_3(context).tables.front()), 4U * (1 + 4 * 3));
  EXPECT_EQ(rows_in_golden(table_5_4(context).tables.front()), 4U * 15 * 4);
  EXPECT_EQ(rows_in_golden(table_5_5(context).tables.front()), 4U * 15 * (1 + 3 * 2));
}

TEST(Counts, OptionsAndBalanceShowTheGoldenCounts) {
  SOMS_NEEDS_OUTSIDE_DATA("options and balance of the objects and scenes");
  const Models models = models_of_thesis();
  const Result balanced = balance({.models = models});
  EXPECT_EQ(rows_in_golden(balanced.tables.front()), 7U * (1 + 3 * 2));
  const Result varied = options({.models = models});
  // Two rules, with each of 24 combinations and with the root at level 0.
  EXPECT_EQ(rows_in_golden(varied.tables.at(1)), 4U * 2 * (24 + 1));
}

TEST(Counts, GeneratedScenesHaveTheirFileAndItsBytes) {
  const Models models = with_scenes_only();
  const Table table = table_3_3({.models = models}).tables.front();
  ASSERT_EQ(table.rows.size(), models.scenes.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    CountsByName cells = named_cells(table, table.rows[i]);
    EXPECT_EQ(cells["file"], "scenes/" + models.scenes[i].name + ".3ds");
    EXPECT_EQ(cells["bytes"], std::to_string(scene_file(models.scenes[i]).size()));
  }
}

TEST(Counts, OptionsVaryTheSizeOfLeavesToo) {
  const Models models = find_models({}, {.objects = true, .scenes = true});
  const Result result = options({.models = models});
  std::map<std::string, std::size_t> rows;
  for (const std::vector<Cell>& row : result.tables.at(1).rows) {
    ++rows[named_cells(result.tables[1], row)["per_leaf"]];
  }
  const std::size_t per_value = 2 * (1 + models.scenes.size());
  EXPECT_EQ(rows["2"], per_value);
  EXPECT_EQ(rows["5"], per_value);
  EXPECT_EQ(rows["1"], per_value * (24 + 3));
  for (const std::vector<Cell>& row : result.tables.at(0).rows) {
    CountsByName cells = named_cells(result.tables[0], row);
    if (cells["option"] == "per_leaf") {
      EXPECT_TRUE(cells["value"] == "2" || cells["value"] == "5") << cells["value"];
    }
  }
}

TEST(Counts, SharedCaptionTellsTheOptionsOfTheThesis) {
  for (const Rule rule :
       {Rule::object_median, Rule::object_mean, Rule::spatial_median, Rule::soms}) {
    const BuildOptions options = thesis_options(rule);
    EXPECT_EQ(options.midpoint, Midpoint::thesis);
    EXPECT_EQ(options.empty_side, EmptySide::stop);
    EXPECT_EQ(options.c_vertex, 2);
    Table table = count_table("t", "T", std::array<std::string_view, 1>{"axis_from"},
                              std::array{Counted{nullptr, {"r", "R", true, options}, {}}});
    EXPECT_EQ(cell_text(table.rows[0][0]), rule == Rule::soms ? "inner" : "outer");
  }
  for (const char* const part :
       {"midpoint thesis", "outer box (SOMS: inner)", "empty side stop", "C = 2"}) {
    EXPECT_NE(kThesisOptions.find(part), std::string_view::npos) << part;
  }
}

TEST(Counts, CaptionsOfAllBuildsTellTheOptionsOfEach) {
  const std::vector<Contender> builds = all_builds(kSceneLevel);
  const BuildOptions& sah = builds.at(4).options;
  EXPECT_EQ(sah, (BuildOptions{.rule = Rule::sah, .level = kSceneLevel, .per_leaf = 1}));
  EXPECT_EQ(sah.midpoint, Midpoint::aabb);
  EXPECT_EQ(sah.empty_side, EmptySide::object_median);
  const BuildOptions& library = builds.at(5).options;
  EXPECT_EQ(library.rule, Rule::fast);
  EXPECT_EQ(library.per_leaf, 8);
  EXPECT_EQ(library.level, 0);
  for (const char* const part : {"midpoint aabb", "object_median", "rule fast",
                                 "leaves of at most 8 triangles", "no limit of levels"}) {
    EXPECT_NE(kComparedOptions.find(part), std::string_view::npos) << part;
  }
  const Models models = with_scenes_only();
  for (const auto run : {table_5_9, table_5_10, table_5_11}) {
    const Result result = run({.models = models});
    const std::string& caption = result.figures.at(0).caption;
    EXPECT_NE(caption.find(kComparedOptions), std::string::npos) << caption;
  }
}

TEST(Counts, BalanceSaysWhichMidpointEachTreeUses) {
  Models models;
  models.objects.push_back(small_model("sphere", generate_sphere(200), false));
  const Result result = balance({.models = models});
  EXPECT_NE(result.figures.at(0).caption.find(kComparedOptions), std::string::npos);
  const Table& table = result.tables.at(0);
  for (const std::vector<Cell>& row : table.rows) {
    CountsByName cells = named_cells(table, row);
    const bool of_library = cells.at("rule") == "sah" || cells.at("rule") == "default";
    EXPECT_EQ(cells.at("midpoint"), of_library ? "aabb" : "thesis") << cells.at("rule");
  }
}

TEST(Counts, ObjectMedianBalancesBetterThanSomsOnEveryModel) {
  SOMS_NEEDS_OUTSIDE_DATA("the remark on balance");
  const Models models = models_of_thesis();
  const Result result = balance({.models = models});
  EXPECT_NE(result.remarks.front().find("higher on 0, equal on 0, lower on 7 of 7"),
            std::string::npos)
      << result.remarks.front();
}

TEST(Counts, StandInsAreNamedInCaptionsAndRows) {
  const Models models = find_models({}, {.objects = true, .scenes = true});
  for (const auto run : {table_5_3, table_5_9, balance}) {
    const Result result = run({.models = models});
    for (const Table& table : result.tables) {
      EXPECT_NE(table.caption.find("Stand-ins: "), std::string::npos) << table.caption;
      for (const std::vector<Cell>& row : table.rows) {
        EXPECT_EQ(named_cells(table, row)["origin"], "stand-in");
      }
    }
    for (const Figure& figure : result.figures) {
      EXPECT_NE(figure.svg.find("(stand-in)"), std::string::npos) << figure.id;
    }
  }
}

TEST(Counts, ModelsOfFilesAreNoStandIns) {
  Models models;
  models.objects.push_back(small_model("ball", generate_sphere(80), false));
  const Table table = table_5_3({.models = models}).tables.front();
  EXPECT_EQ(table.caption.find("Stand-ins"), std::string::npos) << table.caption;
  EXPECT_EQ(named_cells(table, table.rows.front())["origin"], "ball.ply");
}

TEST(Counts, EmptyModelHasARowAndNoShare) {
  Models models;
  models.scenes.push_back(small_model("nothing", Mesh{}, true));
  for (const auto run : {table_5_9, table_5_10, table_5_11}) {
    const Result result = run({.models = models});
    EXPECT_EQ(named_cells(result.tables.front(), result.tables.front().rows.front())["triangles"],
              "0");
  }
  const Model& nothing = models.scenes.front();
  EXPECT_EQ(balanced_level(nothing, thesis_rules(3).front(), {}), 1);
}

TEST(Counts, TwoRunsAreTheSameBytes) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  Models models = with_scenes_only();
  models.objects.push_back(small_model("knot", generate_knot(300), true));
  for (const auto run : {table_3_1, table_3_3, table_5_3, table_5_4, table_5_5, table_5_9,
                         table_5_10, table_5_11, options, balance}) {
    const Result first = run({.models = models});
    const Result second = run({.models = models, .quick = true});
    ASSERT_EQ(first.tables.size(), second.tables.size());
    for (std::size_t i = 0; i < first.tables.size(); ++i) {
      EXPECT_EQ(to_csv(first.tables[i]), to_csv(second.tables[i]));
      for (const Column& column : first.tables[i].columns) {
        EXPECT_EQ(column.kind, ColumnKind::counted) << first.tables[i].id << " " << column.name;
      }
    }
    for (std::size_t i = 0; i < first.figures.size(); ++i) {
      EXPECT_EQ(first.figures[i].svg, second.figures.at(i).svg);
      EXPECT_FALSE(first.figures[i].timed);
    }
    EXPECT_EQ(first.remarks, second.remarks);
  }
}

TEST(Counts, EveryLevelIsThereOnceAndBuildsWithoutLimitAtTheEnd) {
  const std::vector<Contender> contenders = at_every_level(3, all_builds);
  const std::size_t unlimited = static_cast<std::size_t>(
      std::count_if(contenders.begin(), contenders.end(),
                    [](const Contender& one) { return one.options.level == 0; }));
  const std::size_t builds = all_builds(1).size();
  EXPECT_EQ(contenders.size(), 3 * (builds - unlimited) + unlimited);
  EXPECT_GE(unlimited, 1U);
  EXPECT_EQ(contenders.front().options.level, 1);
  EXPECT_EQ(contenders.back().options.level, 0);
}

TEST(Counts, TitleTellsOfAnOptionThatChangedOnly) {
  const Contender soms = thesis_rules(7).back();
  EXPECT_EQ(with(soms, EmptySide::stop).title, soms.title);
  EXPECT_EQ(with(soms, AxisFrom::inner).title, soms.title);
  EXPECT_EQ(with(soms, EmptySide::next_axis).title, soms.title + ", next axis");
  EXPECT_EQ(with(soms, AxisFrom::outer).title, soms.title + ", outer axis");
  EXPECT_TRUE(has_usual_options(soms));
  EXPECT_FALSE(has_usual_options(with(soms, AxisFrom::outer)));
}

TEST(Counts, ComparisonFromNoneHasNoPercentage) {
  EXPECT_EQ(compare(904, 423), "904 to 423 (+114 %)");
  EXPECT_EQ(compare(5, 0), "5 to 0");
}

TEST(Counts, StopRequestEndsTheCounting) {
  const Models models = with_scenes_only();
  std::stop_source stop;
  stop.request_stop();
  Context context{.models = models};
  context.limits.stop = stop.get_token();
  for (const auto run : {table_5_9, figure_5_4, table_5_7}) {
    EXPECT_THROW(static_cast<void>(run(context)), Error);
  }
}

}  // namespace
}  // namespace soms::reproduce
