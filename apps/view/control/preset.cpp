#include "apps/view/control/preset.h"

#include "soms/thesis/traversals.h"

#include <array>

namespace soms::view {

namespace {

struct Chosen {
  BuildOptions build;
  TraversalOptions traversal;
};

Chosen meant_by(Preset preset) {
  if (preset == Preset::thesis) {
    return {thesis_options(Rule::soms), {.traversal = Traversal::e_node}};
  }
  return {{.rule = Rule::soms}, {}};
}

/// True if nothing that has an effect differs.
bool same_trees(const ViewState& a, const ViewState& b) {
  return a.rule == b.rule && a.tree == b.tree && a.traversal == b.traversal && a.prune == b.prune &&
         (!has_descent(a.traversal) || a.descent == b.descent);
}

}  // namespace

void choose(ViewState& state, Preset preset) {
  const auto [build, traversal] = meant_by(preset);
  begin_with(state, build, traversal);
  state.prune = true;
  state.shown.visited = state.shown.pruned = state.shown.found = false;
  if (preset == Preset::thesis) {
    show_traversed(state);
  }
}

void show_traversed(ViewState& state) {
  state.shown.visited = state.shown.pruned = state.shown.found = true;
  if (state.traversal == Traversal::fast) {
    state.traversal = Traversal::e_node;
  }
}

std::optional<Preset> preset_of(const ViewState& state) {
  for (const Preset preset : std::array{Preset::product, Preset::thesis}) {
    ViewState wanted = state;
    choose(wanted, preset);
    if (same_trees(state, wanted)) {
      return preset;
    }
  }
  return std::nullopt;
}

}  // namespace soms::view
