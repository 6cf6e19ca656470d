#include "thesis/run/experiment.h"

#include "soms/base/error.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

namespace soms::reproduce {
namespace {

std::vector<std::string> items_of(std::vector<std::string_view> words) {
  std::vector<std::string> items;
  for (const Experiment* experiment : experiments_named(words)) {
    items.emplace_back(experiment->item);
  }
  return items;
}

TEST(Experiment, EveryRowIsWholeAndUnique) {
  std::set<std::string_view> items;
  for (const Experiment& experiment : experiments()) {
    EXPECT_TRUE(items.insert(experiment.item).second) << experiment.item;
    EXPECT_FALSE(experiment.title.empty()) << experiment.item;
    EXPECT_NE(experiment.run, nullptr) << experiment.item;
    EXPECT_GT(experiment.weight, 0) << experiment.item;
  }
}

TEST(Experiment, NamesAndNumbersSelect) {
  EXPECT_EQ(items_of({"table-3.1"}), (std::vector<std::string>{"table-3.1"}));
  EXPECT_EQ(items_of({"3.1", "table-3.1"}), (std::vector<std::string>{"table-3.1"}));
  EXPECT_EQ(items_of({}).size(), experiments().size());
  EXPECT_EQ(items_of({"claims", "thesis", "beyond"}).size(), experiments().size());
}

TEST(Experiment, UnknownItemIsNamedWithTheChoices) {
  try {
    items_of({"3.1", "9.9"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_NE(std::string(error.what()).find("'9.9'"), std::string::npos) << error.what();
    EXPECT_NE(error.remedy().find("table-3.1"), std::string::npos) << error.remedy();
  }
}

TEST(Experiment, QuickRunsRepeatATenth) {
  const Models models;
  EXPECT_EQ((Context{.models = models}).repetitions(1000), 1000);
  EXPECT_EQ((Context{.models = models, .quick = true}).repetitions(1000), 100);
  EXPECT_EQ((Context{.models = models, .quick = true}).repetitions(20), 5);
  EXPECT_EQ((Context{.models = models, .quick = true}).repetitions(3), 3);
}

}  // namespace
}  // namespace soms::reproduce
