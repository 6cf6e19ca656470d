/// \file
/// How far apart are two posed meshes? Decided without any tree, before a time counts.
#pragma once

#include "soms/base/box.h"

#include "bench/peers/core/bunches.h"
#include "bench/peers/libraries/library.h"

#include <cstddef>

namespace soms::bench {

/// Measures in plain doubles, up to their rounding; 0 exactly where the meshes share a point. Each
/// mesh is cut into bunches of triangles that lie near each other; pairs of bunches are opened in
/// the order of the gaps of their boxes. Nothing is kept from pose to pose.
class DistanceJudge {
 public:
  DistanceJudge(const FloatMesh& mover, const FloatMesh& fixed);

  [[nodiscard]] double distance(const Pose& pose) const;

  /// How far rounding in `precision` may take a distance at `pose` from the true one: some units in
  /// the last place of the largest coordinate, and of exact answers the rounding of this judge.
  [[nodiscard]] double slack(Precision precision, const Pose& pose) const;

  [[nodiscard]] std::size_t mover_triangles() const { return mover_.triangles.size(); }

 private:
  Bunches mover_;
  Bunches fixed_;
  Box mover_bounds_;
  Box fixed_bounds_;
};

}  // namespace soms::bench
