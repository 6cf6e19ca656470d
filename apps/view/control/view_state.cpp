#include "apps/view/control/view_state.h"

#include <algorithm>

namespace soms::view {

Choice choice(const ViewState& state) {
  return {state.shown,     state.rule,  state.traversal,        state.prune,
          state.tree_of,   state.level, state.orientation_test, state.learn,
          state.learn_step};
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
