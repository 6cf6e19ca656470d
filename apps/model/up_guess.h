/// \file
/// Guesses which axis is up in a model whose file does not say it.
#pragma once

#include "soms/geometry/mesh.h"

namespace soms::command {

/// True if a model looks as if y were up, not z: what stands has a wide base and a narrower top,
/// and is about alike at either end of the other axes. Compared are the shares of the ground plan
/// that the corners within 5 % of either end span. Unsure models, and those that lie flat on z, do
/// not look so. A guess is good enough to draw by; answers must not depend on it. \cost
/// O(triangles).
[[nodiscard]] bool looks_y_up(const MeshView& mesh);

}  // namespace soms::command
