#include "apps/view/control/help.h"

#include "apps/view/control/action.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace soms::view {
namespace {

/// The whole step that a fine one is a tenth of.
Action before_fine(Action fine) {
  return static_cast<Action>(static_cast<int>(fine) - (static_cast<int>(Action::object_right_fine) -
                                                       static_cast<int>(Action::object_right)));
}

TEST(Help, TellsEveryActionWithItsKeys) {
  const auto lines = help_lines();
  for (const ActionRow& row : actions()) {
    if (is_fine(row.action)) {
      EXPECT_TRUE(row.press.shift) << row.help;
      EXPECT_EQ(action_of(KeyPress{row.press.key}), before_fine(row.action)) << row.help;
      continue;
    }
    const bool reported = std::any_of(lines.begin(), lines.end(), [&](const HelpLine& line) {
      return line.text == row.help && line.keys == keys_of(row.action);
    });
    EXPECT_TRUE(reported) << row.help;
  }
}

TEST(Help, HasNoEmptyKeysAndHeadingsOnce) {
  std::vector<std::string> headings;
  for (const HelpLine& line : help_lines()) {
    EXPECT_FALSE(line.keys.empty());
    if (line.text.empty()) {
      headings.push_back(line.keys);
    }
  }
  std::sort(headings.begin(), headings.end());
  EXPECT_EQ(std::adjacent_find(headings.begin(), headings.end()), headings.end());
  EXPECT_EQ(headings.size(), 9U);
}

TEST(Help, IsTheTableOfTheManual) {
  std::ifstream file(std::filesystem::path(SOMS_DOCS) / "view.md");
  std::stringstream text;
  text << file.rdbuf();
  const std::string page = text.str();
  for (const HelpLine& line : help_lines()) {
    const std::string expected =
        line.text.empty() ? "**" + line.keys + "**" : "| " + line.keys + " | " + line.text + " |";
    EXPECT_NE(page.find(expected), std::string::npos) << expected;
  }
}

}  // namespace
}  // namespace soms::view
