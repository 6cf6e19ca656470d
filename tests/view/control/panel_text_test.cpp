#include "apps/view/control/panel_text.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

TEST(PanelText, CostsOfTheSceneHaveNoPairsEntered) {
  Facts facts;
  facts.cost = {4274, 150, 3};
  facts.collision_ms = 0.351;
  EXPECT_EQ(cost_rows(facts), (Rows{{"Collision", "0.351 ms"},
                                    {"Box tests", "4,274"},
                                    {"Triangle tests", "150"},
                                    {"Exact tests", "3"}}));
}

TEST(PanelText, CostsOfATraversalSayWhatIsOfAPartOnly) {
  Facts facts;
  facts.cost = {1395, 771, 0};
  facts.collision_ms = 2;
  facts.entered = 400;
  facts.traversed = facts.trace_cut = true;
  facts.visited = 7;
  EXPECT_EQ(cost_rows(facts), (Rows{{"Collision", "2 ms"},
                                    {"Box tests", "1,395"},
                                    {"Triangle tests", "771"},
                                    {"Exact tests", "0"},
                                    {"Pairs entered", "400"},
                                    {"Object: entered", "at least 7"},
                                    {"Object: pruned", "at least 0"},
                                    {"Object: leaf pairs", "at least 0"}}));
  facts.cost_cut = true;
  EXPECT_EQ(cost_rows(facts)[1].second, "at least 1,395");
  EXPECT_EQ(cost_rows(facts)[4].second, "at least 400");
}

TEST(PanelText, OfTreesIsSaidWhatIsNotAsByDefault) {
  ViewState state;
  EXPECT_EQ(tree_line(state), "");
  state.traversal = Traversal::e_node;
  EXPECT_EQ(tree_line(state), "descent larger");
  begin_with(state, thesis_options(Rule::soms), {.traversal = Traversal::e_node});
  EXPECT_EQ(tree_line(state), "descent both, leaf 1, 15 levels, midpoint thesis, empty side stop");
  state.traversal = Traversal::fast;
  state.rule = Rule::quick;  // uses neither midpoints nor empty sides
  EXPECT_EQ(tree_line(state), "leaf 1, 15 levels");
}

}  // namespace
}  // namespace soms::view
