// Experiments that let objects collide: each object of the run has its rows, in every table and
// every claim.
#include "tests/reproduce/trips.h"
#include "tests/support/slow_build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {
namespace {

using trips::cell;
using trips::run_quick;

/// Words of a column, each once, in the order of the rows.
std::vector<std::string> words_of(const Table& table, std::string_view column) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::string word = cell(table, i, column);
    if (std::find(words.begin(), words.end(), word) == words.end()) {
      words.push_back(word);
    }
  }
  return words;
}

class AllObjects : public testing::TestWithParam<std::string_view> {};

TEST_P(AllObjects, HaveRowsInEveryTableAndEveryClaim) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const Models models = trips::two_objects();
  const Result result = run_quick(GetParam(), models);
  for (const Table& table : result.tables) {
    EXPECT_EQ(words_of(table, "model"), (std::vector<std::string>{"bunny", "venus"})) << table.id;
  }
  for (const Claim& claim : result.claims) {
    std::set<std::string> of_bunny;
    std::set<std::string> of_venus;
    for (const ClaimRow& row : claim.rows) {
      const std::size_t comma = row.subject.find(", ");
      ASSERT_NE(comma, std::string::npos) << row.subject;
      (row.subject.starts_with("bunny, ") ? of_bunny : of_venus)
          .insert(row.subject.substr(comma + 2));
    }
    EXPECT_FALSE(of_bunny.empty());
    EXPECT_EQ(of_bunny, of_venus) << claim.id;
  }
  std::set<std::string> ids;
  for (const Figure& figure : result.figures) {
    EXPECT_TRUE(ids.insert(figure.id).second) << figure.id;
    EXPECT_EQ(figure.svg.find("nan"), std::string::npos) << figure.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Reproduce, AllObjects,
                         testing::Values("figure-5.6", "orientation-bottom", "figure-5.10",
                                         "drives", "claim-cheaper", "claim-balanced",
                                         "claim-enode-faster", "claim-enode-earlier",
                                         "claim-enode-time"),
                         [](const auto& test) {
                           std::string name(test.param);
                           std::replace_if(
                               name.begin(), name.end(),
                               [](char c) { return c == '-' || c == '.'; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace soms::reproduce
