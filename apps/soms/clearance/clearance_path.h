/// \file
/// The path of a profile, as `simulate` reads a route.
#pragma once

#include "soms/scene/motion_path.h"

#include "apps/world/world.h"

#include <cstddef>
#include <vector>

namespace soms::command {

/// The axis of the profile that heads along its path.
enum class Forward { x, y, minus_x, minus_y };

/// A path, and the row of its file that each of its poses is of.
struct ProfilePath {
  MotionPath motion;
  std::vector<std::size_t> rows = {};
};

/// The path of a route as `load_world` has it. Along points, the foot of the model is on each line,
/// which `forward` heads along; where a line ends, the model turns on the spot to the heading of
/// the next, and a half turn goes to the left. Poses are taken as they are, with the origin of the
/// model as the pivot, after it is rotated so that `forward` is +x.
[[nodiscard]] ProfilePath profile_path(const MoverRoute& route, const Vec3& foot, Forward forward);

}  // namespace soms::command
