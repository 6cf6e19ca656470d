#include "apps/view/control/view_state.h"

#include "soms/thesis/traversals.h"

#include <algorithm>

namespace soms::view {

namespace {

bool shows_trace(const Shown& shown) {
  return shown.visited || shown.pruned || shown.found;
}

}  // namespace

Choice choice(const ViewState& state) {
  return {state.shown,   state.rule,      state.traversal,
          state.prune,   state.tree,      state.descent,
          state.tree_of, state.level,     state.orientation_test,
          state.learn,   state.learn_step};
}

std::vector<Descent> descents_of(Traversal traversal) {
  if (traversal == Traversal::e_node) {
    return {Descent::both, Descent::larger, Descent::cross, Descent::fewest};
  }
  return traversal == Traversal::e_node_front ? std::vector{Descent::both, Descent::larger}
                                              : std::vector<Descent>{};
}

Descent descent_of(const ViewState& state) {
  const std::vector<Descent> possible = descents_of(state.traversal);
  const bool taken = std::find(possible.begin(), possible.end(), state.descent) != possible.end();
  return taken || possible.empty() ? state.descent : Descent::larger;
}

void begin_with(ViewState& state, const BuildOptions& build, const TraversalOptions& traversal) {
  state.rule = build.rule;
  state.tree = build;
  state.tree.rule = BuildOptions{}.rule;
  state.traversal = traversal.traversal;
  if (has_descent(traversal.traversal)) {
    state.descent = traversal.descent;
  }
}

void take_back(ViewState& state, const Choice& before) {
  state.rule = before.rule;
  state.traversal = before.traversal;
  state.prune = before.prune;
  state.tree = before.tree;
  state.descent = before.descent;
}

void choose_boxes(ViewState& state, const Choice& before) {
  if (state.traversal == Traversal::fast && shows_trace(state.shown) &&
      !shows_trace(before.shown)) {
    state.traversal = Traversal::e_node;
  }
}

int levels(const ViewState& state) {
  const int count =
      state.tree_of == TreeOf::city ? state.limits.city_levels : state.limits.mover_levels;
  return std::max(count, 1);
}

void clamp(ViewState& state) {
  state.level = std::clamp(state.level, 1, levels(state));
  state.speed = std::clamp(state.speed, kSlowest, kFastest);
  if (state.limits.frames > 0) {
    state.frame = std::min(state.frame, state.limits.frames - 1);
  }
  if (state.limits.movers > 0) {
    state.followed = std::min(state.followed, state.limits.movers - 1);
  } else if (state.camera == CameraMode::follow) {
    state.camera = CameraMode::orbit;
  }
}

const char* name(CameraMode mode) {
  switch (mode) {
    case CameraMode::orbit:
      return "orbit";
    case CameraMode::fly:
      return "fly";
    case CameraMode::follow:
      return "follow";
  }
  return "";
}

const char* name(TreeOf tree) {
  return tree == TreeOf::city ? "city" : "object";
}

}  // namespace soms::view
