/// \file
/// How do two solids stand to each other? Decided without any tree, before a time counts.
#pragma once

#include "bench/peers/core/pair_counter.h"
#include "bench/peers/core/probe_judge.h"
#include "bench/peers/libraries/library.h"

#include <cstddef>
#include <vector>

namespace soms::bench {

/// Judges bodies whose surfaces are closed and connected. Where they share no point, a corner of
/// each says all; where they do, corners of one body on both sides of the other prove a crossing.
class SolidJudge {
 public:
  SolidJudge(const FloatMesh& mover, const FloatMesh& fixed);

  /// The number of the relation, or kTouching where surfaces meet and no corner proves more than
  /// that.
  [[nodiscard]] double relation(const Pose& pose) const;

  /// Triangles that are looked at for a pose, roughly.
  [[nodiscard]] std::size_t looks() const { return mover_.triangles.size(); }

  static constexpr double kTouching = 1;

 private:
  FloatMesh mover_;
  FloatMesh fixed_;
  PairCounter pairs_;
  SideJudge of_mover_;
  SideJudge of_fixed_;
};

}  // namespace soms::bench
