// Readings of E-Node: every count by an independent implementation, and an earlier level beside
// trees that are built to that level.
#include "thesis/races/e_node_readings.h"

#include "soms/thesis/thesis_frames.h"

#include "tests/reproduce/trips.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "thesis/races/earlier_nodes.h"
#include "thesis/run/golden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace soms::reproduce {
namespace {

using trips::cell;
using trips::run_quick;
using trips::small_models;
using trips::table_of;

/// Counts of a trip on trees that are built to a level, by the library's E-Node.
EarlierLevel built_to(const Trip& trip) {
  EarlierLevel sum;
  const MovedTrip moved(trip, {});
  LeafPairs pairs;
  const std::vector<Frame> frames =
      traverse_frames(trip, {"enode_both", {.traversal = Traversal::e_node}}, {}, &pairs);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    sum.box_tests += frames[k].counts.box_tests;
    sum.entered += frames[k].counts.entered;
    sum.first_tests += frames[k].counts.first_tests;
    sum.pairs += frames[k].counts.leaf_pairs;
    for (const NodePair pair : pairs[k]) {
      sum.touching_pairs += moved.contacts(k, pair, 1);
    }
    if (!pairs[k].empty()) {
      ++sum.called_frames;
      sum.first_frame = std::min(sum.first_frame, k);
    }
  }
  return sum;
}

/// Compares every level of a trip, made for a level by `made`.
template <class Made>
void compare_levels(const Made& made) {
  const Trip whole = made(kObjectLevel);
  const MovedTrip moved(whole, {});
  const std::vector<Frame> exact = answer_frames(whole, named_traversal("larger"), {});
  const std::vector<EarlierLevel> levels = earlier_nodes(moved, exact, {});
  ASSERT_GT(levels.size(), 5U);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    EXPECT_EQ(levels[i], built_to(made(static_cast<int>(i) + 1))) << "level " << i + 1;
  }
  EXPECT_GE(levels.front().called_frames, levels.back().called_frames);
  EXPECT_LT(levels.front().pairs, levels.back().pairs);
  EXPECT_GT(levels.back().touching_pairs, 0U);
}

TEST(EarlierNodes, AreThoseOfTreesBuiltToTheLevel) {
  const Models models = small_models();
  compare_levels([&](int level) {
    return orientation_trip(models.objects[0], Approach::right, thesis_rules(level).back());
  });
}

TEST(EarlierNodes, AreThoseOfTreesBuiltToTheLevelInADrive) {
  const Models models = small_models();
  compare_levels([&](int level) {
    const Contender build = thesis_rules(level).back();
    return drive_trip(models.scenes[0], models.objects[0], build, build);
  });
}

TEST(EnodeReadings, StandAsTheirWordsHaveIt) {
  const Result result = run_quick("readings-e-node", small_models());
  const Table& reasons = table_of(result, "readings_e_node_reasons");
  std::map<std::string, std::string> stands;
  for (std::size_t i = 0; i < reasons.rows.size(); ++i) {
    stands[cell(reasons, i, "reading")] = cell(reasons, i, "stands");
    for (const char* const words : {"title", "speaks_for", "speaks_against", "why"}) {
      EXPECT_FALSE(cell(reasons, i, words).empty()) << i << ' ' << words;
    }
  }
  EXPECT_EQ(stands, (std::map<std::string, std::string>{{"family_both", "taken"},
                                                        {"family_larger", "open"},
                                                        {"family_cross", "against"},
                                                        {"family_fewest", "open"},
                                                        {"front_both", "against"},
                                                        {"front_larger", "against"},
                                                        {"chain", "open"},
                                                        {"first_leaves", "open"},
                                                        {"first_contact", "open"},
                                                        {"boxes_only", "against"}}));
}

// A query that stops does no more than one that goes on, and boxes alone miss no contact.
TEST(EnodeReadings, CountsFitTogether) {
  const Result result = run_quick("readings-e-node", trips::two_objects());
  const Table& table = table_of(result, "readings_e_node");
  std::map<std::string, std::int64_t> tests;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    tests[cell(table, i, "reading") + cell(table, i, "course")] =
        std::stoll(cell(table, i, "box_tests"));
    const std::string contact = cell(table, i, "contact_frames");
    EXPECT_TRUE(contact.empty() ||
                std::stoll(contact) <= std::stoll(cell(table, i, "leaf_frames")));
  }
  for (const std::string course : {"bunny, four sides", "venus, four sides"}) {
    const std::int64_t whole = tests.at("family_both" + course);
    EXPECT_EQ(tests.at("chain" + course), whole);
    EXPECT_LT(tests.at("first_leaves" + course), tests.at("first_contact" + course));
    EXPECT_LT(tests.at("first_contact" + course), whole);
  }
  EXPECT_EQ(tests.count("family_bothvenus, ball drive"), 0U);  // quick: drives of the first alone
  const Table& levels = table_of(result, "readings_e_node_levels");
  for (std::size_t i = 0; i < levels.rows.size(); ++i) {
    EXPECT_GE(std::stoll(cell(levels, i, "false_frames")), 0) << i;
    EXPECT_GE(std::stoll(cell(levels, i, "false_pairs")), 0) << i;
  }
}

/// Rows of a golden file that a table has too, by their first `keys` columns; each must be equal.
std::size_t compare(const Table& table, const std::string& file, std::size_t keys) {
  const auto lines = soms::test::read_csv(soms::test::data("thesis/" + file));
  std::size_t compared = 0;
  for (std::size_t line = 1; line < lines.size(); ++line) {
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      bool same = true;
      for (std::size_t k = 0; k < keys; ++k) {
        same = same && cell(table, i, lines[0][k]) == lines[line][k];
      }
      for (std::size_t k = keys; same && k < lines[0].size(); ++k) {
        EXPECT_EQ(cell(table, i, lines[0][k]), lines[line][k])
            << file << " line " << line + 1 << ' ' << lines[0][k];
      }
      compared += same ? 1U : 0U;
    }
  }
  return compared;
}

TEST(EnodeReadings, EveryCountIsThatOfAnIndependentProgram) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  SOMS_NEEDS_OUTSIDE_DATA("69 rows about readings of E-Node: bunny, Venus and the plain city");
  Models models = find_models(*soms::test::outside_data(""), {.objects = true});
  std::erase_if(models.objects,
                [](const Model& model) { return model.name != "bunny" && model.name != "venus"; });
  models.scenes = {find_models({}, {.scenes = true}).scenes.back()};
  const Result result = run_quick("readings-e-node", models);
  EXPECT_EQ(compare(table_of(result, "readings_e_node"), "e_node_readings.csv", 3), 30U);
  EXPECT_EQ(compare(table_of(result, "readings_e_node_levels"), "e_node_levels.csv", 3), 30U);
  EXPECT_EQ(compare(table_of(result, "readings_e_node_frames"), "first_frames.csv", 3), 9U);
}

}  // namespace
}  // namespace soms::reproduce
