#include "apps/view/verbs/tree_options.h"

#include "soms/base/error.h"

#include "apps/cli/parser.h"
#include "apps/view/window/viewer.h"
#include "tests/support/support.h"

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace soms::view {
namespace {

/// The trees and the traversal of a window that these words open.
ViewerOptions chosen_by(const std::string& words) {
  command::Parser parser("", "soms-view");
  ViewerOptions chosen;
  add_tree_options(parser, chosen.build, chosen.traversal);
  std::istringstream separate(words);
  (void)parser.parse({std::istream_iterator<std::string>(separate), {}});
  check_tree_options(parser, chosen.build, chosen.traversal);
  return chosen;
}

TEST(TreeOptions, WithoutAnyTreesAreBySomsAndTheTraversalIsTheProducts) {
  EXPECT_EQ(chosen_by("").build, (BuildOptions{.rule = Rule::soms}));
  EXPECT_EQ(chosen_by("").traversal, TraversalOptions{});
}

TEST(TreeOptions, ThoseOfTheThesisHaveOneName) {
  const ViewerOptions thesis = chosen_by("--thesis");
  EXPECT_EQ(thesis.build, thesis_options(Rule::soms));
  EXPECT_EQ(thesis.traversal, (TraversalOptions{.traversal = Traversal::e_node}));
  const ViewerOptions named = chosen_by(
      "--rule soms --midpoint thesis --leaf 1 --empty-side stop --levels 15 --traversal e-node "
      "--descent both");
  EXPECT_EQ(named.build, thesis.build);
  EXPECT_EQ(named.traversal, thesis.traversal);
}

TEST(TreeOptions, WhatIsNamedBesideThemWins) {
  for (const char* words : {"--thesis --levels 9 --traversal larger --rule object-median",
                            "--rule object-median --traversal larger --levels 9 --thesis"}) {
    const ViewerOptions chosen = chosen_by(words);
    EXPECT_EQ(chosen.build, thesis_options(Rule::object_median, 9));
    EXPECT_EQ(chosen.traversal, (TraversalOptions{.traversal = Traversal::larger}));
  }
  EXPECT_EQ(chosen_by("--thesis --rule quality").build, thesis_options(Rule::quality));
  EXPECT_THROW((void)chosen_by("--thesis --rule quality --midpoint thesis"), Error);
}

TEST(TreeOptions, OfTheWindowAreCheckedBeforeItOpens) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--tree", "descent=cross"},
        {"--tree", "rule=fast", "--tree", "midpoint=aabb"}}) {
    std::vector<std::string> all{SOMS_VIEW_COMMAND, "view", "none.ply"};
    all.insert(all.end(), words.begin(), words.end());
    const test::RunResult result = test::run_program(all);
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_NE(result.err.find("has no effect"), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace soms::view
