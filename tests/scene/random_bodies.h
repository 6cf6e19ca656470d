/// \file
/// Small bodies, poses and boxes for tests of scenes.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"
#include "soms/base/random.h"
#include "soms/geometry/mesh.h"

#include <vector>

namespace soms::test {

/// A few triangles with corners on integers, so that touching is common and exact.
[[nodiscard]] Mesh random_mesh(Rng& rng);

/// A closed box of 12 triangles.
[[nodiscard]] Mesh box_mesh(const Box& box);

/// A shift by integers, or a rotation and a shift, within `reach` of the origin.
[[nodiscard]] Pose random_pose(Rng& rng, double reach);

/// Boxes of many kinds of scatter: even, flat, in a row, of sizes over three decades, points,
/// empty ones, all alike, far from the origin.
[[nodiscard]] std::vector<Box> random_boxes(Rng& rng);

}  // namespace soms::test
