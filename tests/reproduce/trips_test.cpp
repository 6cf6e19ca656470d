// Experiments about traversals: on small stand-ins what must hold for any model, on the bunny every
// count of thesis_traversal.csv.
#include "tests/reproduce/trips.h"

#include "soms/base/error.h"
#include "soms/query/reference/overlap.h"
#include "soms/thesis/thesis_frames.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "thesis/run/golden.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trips/frames.h"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

namespace soms::reproduce {
namespace {

using trips::cell;
using trips::run_quick;
using trips::small_models;
using trips::table_of;

class Traversals : public testing::TestWithParam<std::string_view> {};

TEST_P(Traversals, GiveWholeTablesAndFigures) {
  const Models models = small_models();
  const Result result = run_quick(GetParam(), models);
  EXPECT_FALSE(result.tables.empty() && result.figures.empty());
  for (const Table& table : result.tables) {
    EXPECT_FALSE(table.rows.empty()) << table.id;
    for (const auto& row : table.rows) {
      ASSERT_EQ(row.size(), table.columns.size()) << table.id;
    }
  }
  for (const Figure& figure : result.figures) {
    EXPECT_EQ(figure.svg.substr(0, 4), "<svg") << figure.id;
    EXPECT_EQ(figure.svg.find("nan"), std::string::npos) << figure.id;
    EXPECT_FALSE(figure.caption.empty()) << figure.id;
  }
}

TEST_P(Traversals, GiveTheSameBytesTwiceWhereNothingIsTimed) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const Models models = small_models();
  const Result one = run_quick(GetParam(), models);
  const Result other = run_quick(GetParam(), models);
  ASSERT_EQ(one.tables.size(), other.tables.size());
  for (std::size_t i = 0; i < one.tables.size(); ++i) {
    EXPECT_EQ(trips::masked_csv(one.tables[i]), trips::masked_csv(other.tables[i]));
  }
  ASSERT_EQ(one.figures.size(), other.figures.size());
  for (std::size_t i = 0; i < one.figures.size(); ++i) {
    EXPECT_TRUE(one.figures[i].timed || one.figures[i].svg == other.figures[i].svg)
        << one.figures[i].id;
  }
  EXPECT_EQ(one.remarks, other.remarks);
}

TEST_P(Traversals, MarkTimesAsTimed) {
  const std::set<std::string> times{"collision",
                                    "frame_time",
                                    "fps",
                                    "traversal",
                                    "query",
                                    "mean",
                                    "median",
                                    "min",
                                    "max",
                                    "contact_frame_time",
                                    "contact_fps",
                                    "free_frame_time",
                                    "free_fps",
                                    "contact_collision",
                                    "contact_collision_drawn",
                                    "contact_drawing",
                                    "contact_fps_drawn",
                                    "free_collision",
                                    "free_collision_drawn",
                                    "free_drawing",
                                    "free_fps_drawn",
                                    "renderer"};
  const Models models = small_models();
  for (const Table& table : run_quick(GetParam(), models).tables) {
    for (const Column& column : table.columns) {
      EXPECT_EQ(column.kind == ColumnKind::timed, times.count(column.name) > 0)
          << table.id << ' ' << column.name;
    }
  }
}

TEST_P(Traversals, EndOnRequest) {
  const Models models = small_models();
  std::stop_source source;
  source.request_stop();
  const std::string_view item = GetParam();
  const Context context{.models = models, .quick = true, .limits = {.stop = source.get_token()}};
  try {
    (void)experiments_named(std::span(&item, 1)).front()->run(context);
    ADD_FAILURE() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
}

TEST_P(Traversals, ReportTheirProgress) {
  const Models models = small_models();
  double last = 0;
  const std::string_view item = GetParam();
  const Context context{.models = models, .quick = true, .limits = {.progress = [&](double share) {
                                                           EXPECT_GT(share, last);
                                                           EXPECT_LE(share, 1);
                                                           last = share;
                                                         }}};
  (void)experiments_named(std::span(&item, 1)).front()->run(context);
  EXPECT_TRUE(last == 0 || last == 1) << last;
}

INSTANTIATE_TEST_SUITE_P(Reproduce, Traversals, testing::ValuesIn(trips::traversal_items()),
                         [](const auto& test) {
                           std::string name(test.param);
                           std::replace_if(
                               name.begin(), name.end(),
                               [](char c) { return c == '-' || c == '.'; }, '_');
                           return name;
                         });

TEST(TraversalTables, EndTheRunWhereAnswersDisagree) {
  EXPECT_NO_THROW(require(true, "all"));
  try {
    require(false, "frame 7: contacts by one and by another");
    ADD_FAILURE() << "went on";
  } catch (const std::logic_error& error) {
    EXPECT_EQ(std::string(error.what()).find("frame 7: contacts by one and by another disagree"),
              0U);
  }
}

TEST(TraversalTables, SayWhatAStandInIs) {
  const Models models = small_models();
  for (const std::string_view item : {"figure-5.6", "figure-5.10", "traversals"}) {
    const Result result = run_quick(item, models);
    ASSERT_FALSE(result.remarks.empty());
    EXPECT_NE(result.remarks[0].find("stand-in"), std::string::npos) << item;
  }
}

// A user's scene may be anywhere and have any name.
TEST(TraversalsOfScenes, DoWithASceneOffThePathOfTheDrive) {
  Models models = small_models();
  Mesh away = *models.scenes[0].mesh;
  for (Vec3& v : away.vertices) {
    v += {0, 90000, 0};
  }
  models.scenes[0].mesh = std::make_shared<const Mesh>(std::move(away));
  models.scenes[0].name = "My <city>";
  const Result result = run_quick("figure-5.10", models);
  const Table& table = table_of(result, "figure_5_10");
  EXPECT_EQ(cell(table, table.rows.size() - 1, "root_overlap_frames"), "0");
  EXPECT_EQ(result.figures.size(), 1U);
  EXPECT_EQ(run_quick("traversals", models).figures.size(), 2U);
}

// On two equal objects it hardly matters which node is descended.
TEST(Figure510, ACaptionTellsOfTheLargerNodeOnlyWhereItMatters) {
  const Result result = run_quick("figure-5.10", small_models());
  for (const Figure& figure : result.figures) {
    EXPECT_TRUE(figure.id.find("right") == std::string::npos ||
                figure.caption.find("larger node") == std::string::npos)
        << figure.caption;
  }
}

TEST(TraversalTables, CaptionsTellTheOptionsOfTheTrees) {
  const Models models = small_models();
  for (const std::string_view item :
       {"figure-5.6", "orientation-back", "figure-5.10", "traversals"}) {
    for (const Table& table : run_quick(item, models).tables) {
      EXPECT_NE(table.caption.find(kThesisOptions), std::string::npos) << table.id;
    }
  }
}

TEST(TraversalTables, NameFiguresAfterModelsWhoseNamesFit) {
  EXPECT_EQ(id_word("u_mixed", 3), "u_mixed");
  EXPECT_EQ(id_word("My city", 3), "model3");
}

TEST(Traversals, FindTheContactsOfBruteForceInEveryFrame) {
  const Models models = small_models();
  const Result result = run_quick("traversals", models);
  const Table& table = table_of(result, "traversals");
  const Mesh& object = *models.objects[0].mesh;
  const Mesh mover = transformed(object, kDriveScale, UpAxis::y);
  std::map<std::string, std::size_t> contacts;
  const auto count = [&](const std::string& name, const Mesh& still, const Mesh& moving,
                         const std::vector<Vec3>& offsets) {
    for (const Vec3& by : offsets) {
      contacts[name] +=
          reference::overlap(still, Pose::identity(), moving, Pose::translation(by.x, by.y, by.z))
              .pairs.size();
    }
  };
  count("right", object, object, orientation_test(bounds(object), Approach::right));
  count("top", object, object, orientation_test(bounds(object), Approach::top));
  count("drive", *models.scenes[0].mesh, mover, city_drive());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::string test = cell(table, i, "test");
    EXPECT_GT(contacts.at(test), 0U);
    EXPECT_EQ(cell(table, i, "contacts"), std::to_string(contacts.at(test)));
    EXPECT_EQ(cell(table, i, "equal_frames"), cell(table, i, "frames"));
    EXPECT_NE(cell(table, i, "brute_force_frames"), "0");
  }
}

TEST(Figure435, PruningKeepsTheAnswersAndSavesTests) {
  const Models models = small_models();
  const Result result = run_quick("figure-4.35", models);
  const Table& table = table_of(result, "figure_4_35_counts");
  for (std::size_t i = 0; i < table.rows.size(); i += 2) {
    EXPECT_EQ(cell(table, i, "prune"), "on");
    EXPECT_EQ(cell(table, i + 1, "prune"), "off");
    EXPECT_EQ(cell(table, i, "leaf_pairs"), cell(table, i + 1, "leaf_pairs"));
    EXPECT_LT(std::stoul(cell(table, i, "box_tests")), std::stoul(cell(table, i + 1, "box_tests")));
    EXPECT_EQ(cell(table, i + 1, "nodes_seen_still"), cell(table, i + 1, "nodes_still"));
  }
}

TEST(Figure59, BothTraversalsTestTheSamePairsAndENodeEntersOnlyOverlappingOnes) {
  const Models models = small_models();
  const Result result = run_quick("figure-5.9", models);
  const Table& table = table_of(result, "figure_5_9_steps");
  std::map<std::string, std::map<std::string, std::string>> tested;
  std::map<std::string, std::set<std::string>> entered;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::string who = cell(table, i, "algorithm");
    if (cell(table, i, "what") == "test") {
      tested[who][cell(table, i, "pair")] = cell(table, i, "outcome");
    } else if (cell(table, i, "what") == "enter") {
      entered[who].insert(cell(table, i, "pair"));
    }
  }
  EXPECT_EQ(tested.at("E-Node"), tested.at("simultaneous"));
  EXPECT_LT(entered.at("E-Node").size(), entered.at("simultaneous").size());
  for (const std::string& pair : entered.at("E-Node")) {
    EXPECT_EQ(tested.at("E-Node").at(pair), "overlap") << pair;
  }
}

using TripCounts = std::vector<std::string>;

/// "bunny bunny soms right larger": what a line of a golden table is of.
std::string key_of(const std::vector<std::string>& cells) {
  std::string key = cells.at(0);
  for (std::size_t i = 1; i < golden_traversals().keys; ++i) {
    key += " " + cells.at(i);
  }
  return key;
}

/// Counts of the golden tables by static, moving, rule, test and algorithm: those of the bunny, and
/// those of the other objects, which the same independent program wrote.
const std::map<std::string, TripCounts>& golden_trips() {
  static const std::map<std::string, TripCounts> rows = [] {
    std::map<std::string, TripCounts> read;
    const std::size_t keys = golden_traversals().keys;
    for (const GoldenTraversal& one :
         read_golden(soms::test::data("thesis/thesis_traversal.csv").parent_path()).traversals) {
      read[key_of(one.row.cells)] = TripCounts(
          one.row.cells.begin() + static_cast<std::ptrdiff_t>(keys), one.row.cells.end());
    }
    for (const auto& line : soms::test::read_csv(soms::test::data("thesis/other_objects.csv"))) {
      read[key_of(line)] = TripCounts(line.begin() + static_cast<std::ptrdiff_t>(keys), line.end());
    }
    return read;
  }();
  return rows;
}

/// The bunny and the scenes, with one of the scenes only where `scene` names it.
Models golden_models(const std::string& scene = "") {
  Models models = find_models(*soms::test::outside_data(""), {.objects = true});
  for (Model& generated : find_models({}, {.scenes = true}).scenes) {
    if (scene.empty() || generated.name == scene) {
      models.scenes.push_back(generated);
    }
  }
  return models;
}

/// Number of rows that the golden tables have too; each must be equal. Of orientation tests, whose
/// tables have one test and one algorithm.
std::size_t compare_rows(const Table& table, const std::string& test,
                         const std::string& algorithm) {
  std::size_t compared = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::string rule = cell(table, i, "rule");
    const std::string name =
        test.empty()
            ? key_of({cell(table, i, "static"), cell(table, i, "moving"), rule,
                      cell(table, i, "test"), cell(table, i, "algorithm")})
            : key_of({cell(table, i, "model"), cell(table, i, "model"), rule, test, algorithm});
    const auto row = golden_trips().find(name);
    if (row != golden_trips().end()) {
      const GoldenLayout& layout = golden_traversals();
      for (std::size_t k = layout.keys; k < layout.columns.size(); ++k) {
        EXPECT_EQ(cell(table, i, layout.columns[k]), row->second[k - layout.keys])
            << name << ' ' << layout.columns[k];
      }
      ++compared;
    }
  }
  return compared;
}

TEST(GoldenTraversals, EveryRowIsFoundByTraverseFrames) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  SOMS_NEEDS_OUTSIDE_DATA("225 rows of thesis_traversal.csv (the mover is the bunny)");
  GoldenTables tables = read_golden(soms::test::data("thesis/thesis_traversal.csv").parent_path());
  tables.trees.clear();
  const GoldenComparison found = compare_with_golden(tables, golden_models(), {});
  EXPECT_EQ(found.compared(), 225U);
  EXPECT_EQ(found.different(), 0U) << sentence_of(found.differences.front());
}

TEST(GoldenTraversals, CellsOfTheTableOfTraversalsAreThoseOfTheGoldenTable) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  SOMS_NEEDS_OUTSIDE_DATA("99 rows of the table traversals");
  const Result result = run_quick("traversals", golden_models("u_plain"));
  // 4 rules x 2 approaches and 3 rules x 1 drive, 9 traversals each.
  EXPECT_EQ(compare_rows(table_of(result, "traversals"), "", ""), 99U);
}

TEST(GoldenTraversals, CellsOfFigure510AreThoseOfTheGoldenTable) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  SOMS_NEEDS_OUTSIDE_DATA("105 rows of figure 5.10");
  const Result result = run_quick("figure-5.10", golden_models("u_plain"));
  Table table = table_of(result, "figure_5_10");
  for (auto& row : table.rows) {
    if (row[5] == Cell("larsson")) {
      row[5] = std::string("simultaneous");
    }
  }
  // 3 traversals: of the bunny 10 trips, of Venus 9 and of either teapot 8, for of these the golden
  // table has no drives, or on SOMS trees alone.
  EXPECT_EQ(compare_rows(table, "", ""), 105U);
}

TEST(GoldenTraversals, CellsOfTheOrientationTestsAreThoseOfTheGoldenTable) {
  SOMS_NEEDS_OUTSIDE_DATA("64 rows of figures 5.6 to 5.8 and of the test from the bottom");
  const Models models = golden_models("u_plain");
  const std::array<std::array<std::string, 3>, 4> items{
      {{"figure-5.6", "figure_5_6", "right"},
       {"figure-5.7", "figure_5_7", "left"},
       {"figure-5.8", "figure_5_8", "top"},
       {"orientation-bottom", "orientation_bottom", "bottom"}}};
  for (const auto& [item, id, test] : items) {
    const Result result = run_quick(item, models);
    // 4 objects, 4 rules
    EXPECT_EQ(compare_rows(table_of(result, id + "_counts"), test, "larger"), 16U) << id;
  }
}

}  // namespace
}  // namespace soms::reproduce
