// The panel of trees and traversals.
#include "soms/thesis/traversals.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include "apps/view/control/imgui_input.h"
#include "apps/view/control/panel_text.h"
#include "apps/view/control/panels.h"
#include "apps/view/control/preset.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace soms::view {

namespace {

/// What the sliders reach; the command line goes farther.
constexpr int kMostInLeaf = 32;
constexpr int kMostLevels = 24;

constexpr std::array kMidpoints{Midpoint::thesis, Midpoint::centroid, Midpoint::aabb};
constexpr std::array kEmptySides{EmptySide::stop, EmptySide::next_axis, EmptySide::object_median,
                                 EmptySide::chain};

std::vector<std::string_view> rule_names() {
  std::vector<std::string_view> names;
  for (const RuleEntry& rule : rules()) {
    names.push_back(rule.kebab);
  }
  return names;
}

std::vector<std::string_view> traversal_names() {
  std::vector<std::string_view> names;
  for (const TraversalEntry& traversal : traversals()) {
    names.push_back(traversal.kebab);
  }
  return names;
}

/// A list of values, named; true when another was chosen.
template <typename Values, typename Value, typename NameOf>
bool choose_of(Widgets& widgets, const char* label, const Values& values, Value& value,
               NameOf&& name_of, std::optional<Action> action = std::nullopt) {
  std::vector<std::string_view> names;
  for (const Value each : values) {
    names.push_back(name_of(each));
  }
  const auto found = std::find(values.begin(), values.end(), value);
  int chosen = found == values.end() ? 0 : static_cast<int>(found - values.begin());
  if (!widgets.choose(label, chosen, names, action)) {
    return false;
  }
  value = values[static_cast<std::size_t>(chosen)];
  return true;
}

/// True if the rule uses midpoints and may leave a side empty.
bool splits_midpoints(Rule rule) {
  BuildOptions options{.rule = rule, .midpoint = Midpoint::thesis};
  return without_idle(options).midpoint == Midpoint::thesis;
}

}  // namespace

void Panels::tree_panel(ViewState& state) {
  if (!widgets_.heading("Tree and traversal")) {
    return;
  }
  presets(state);
  int rule = static_cast<int>(state.rule);
  if (widgets_.choose("Rule", rule, rule_names(), Action::rule_next)) {
    state.rule = static_cast<Rule>(rule);
  }
  traversal_choice(state);
  if (const std::string line = tree_line(state); !line.empty()) {
    ImGui::TextWrapped("%s", line.c_str());
  }
  level_boxes(state);
  tree_options(state);
}

void Panels::presets(ViewState& state) {
  const std::optional<Preset> now = preset_of(state);
  if (widgets_.radio("Default", now == Preset::product)) {
    choose(state, Preset::product);
  }
  ImGui::SameLine();
  if (widgets_.radio("Thesis", now == Preset::thesis, Action::thesis)) {
    apply(state, Action::thesis);
  }
}

void Panels::traversal_choice(ViewState& state) {
  int traversal = static_cast<int>(state.traversal);
  if (widgets_.choose("Traversal", traversal, traversal_names(), Action::traversal_next)) {
    state.traversal = static_cast<Traversal>(traversal);
  }
  if (has_descent(state.traversal)) {
    Descent descent = descent_of(state);
    if (choose_of(
            widgets_, "Descent", descents_of(state.traversal), descent,
            [](Descent each) { return entry(each).kebab; }, Action::descent_next)) {
      state.descent = descent;
    }
  }
}

/// What `--leaf`, `--levels`, `--midpoint` and `--empty-side` set.
void Panels::tree_options(ViewState& state) {
  if (!widgets_.heading("Build options", false)) {
    return;
  }
  BuildOptions& tree = state.tree;
  widgets_.slide("Leaf", tree.per_leaf, 1, std::max(kMostInLeaf, tree.per_leaf));
  // 0 stands for no limit.
  widgets_.slide("Levels", tree.level, 0, std::max(kMostLevels, tree.level));
  if (splits_midpoints(state.rule)) {
    choose_of(widgets_, "Midpoint", kMidpoints, tree.midpoint,
              [](Midpoint midpoint) { return soms::name(midpoint); });
    choose_of(widgets_, "Empty side", kEmptySides, tree.empty_side,
              [](EmptySide side) { return soms::name(side); });
  }
}

void Panels::level_boxes(ViewState& state) {
  if (state.limits.has_object) {
    if (widgets_.radio("City", state.tree_of == TreeOf::city, Action::tree_of)) {
      apply(state, Action::tree_of);
    }
    ImGui::SameLine();
    if (widgets_.radio("Object", state.tree_of == TreeOf::mover, Action::tree_of)) {
      apply(state, Action::tree_of);
    }
    ImGui::SameLine();
  }
  widgets_.check("Boxes", state.shown.tree_boxes, Action::tree_boxes);
  if (widgets_.slide("Level", state.level, 1, levels(state), Action::level_down)) {
    state.shown.tree_boxes = true;
  }
}

}  // namespace soms::view
