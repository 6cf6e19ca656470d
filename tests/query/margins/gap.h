/// \file
/// Bodies of one triangle each at a known distance, and which filters of a query of nearness keep
/// them.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/random.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/near/near_pose.h"
#include "soms/tree/shape.h"

namespace soms::test {

/// Triangles, which may be segments or points, and their poses. The second is the reference where
/// sizes do not decide it.
struct Gap {
  Pose pose_x;
  Pose pose_y;
  Triangle x;
  Triangle y;
};

[[nodiscard]] Shape shape_of(const Triangle& t);

/// Corners of boxes of any shape face each other at a distance of 2^-60 to 2^6 of the larger one;
/// `far` from the origin.
[[nodiscard]] Gap random_gap(Rng& rng, double far);

/// The same of bodies that are `kFar` sizes and more apart (near_pose.cpp).
[[nodiscard]] Gap random_far_gap(Rng& rng, double far);

/// The gap with a few numbers changed by a little; most often in their last bits.
[[nodiscard]] Gap changed(Rng& rng, Gap gap);

/// Two posed shapes seen as a query of nearness sees them.
struct Seen {
  Seen(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);

  Body a;
  Body b;
  detail::PairFrame frame;
  detail::NearPose pose;
  double distance;  ///< of their first triangles: the double next to it from above
};

/// Bounds that the filters give, in the world: above the distance, and the proofs are wrong. Those
/// that the limit for this distance lets pass are within it.
struct Bounds {
  bool nodes = false;   ///< keys of the roots' lanes are within the limit
  bool slabs = false;   ///< the blocks' slabs meet
  bool boxes = false;   ///< the triangles' boxes are near, and they are along the line between them
  bool pairs = false;   ///< the bound of the triangles is within the limit
  double of_nodes = 0;  ///< what the keys say of the distance
  double of_pairs = 0;
};

/// By one instruction set; near bodies only.
[[nodiscard]] Bounds bounds_of(Seen& seen, const detail::Kernels& kernels);

/// What the filters of far bodies say of the distance: the roots' key, and the triangles'.
struct FarBounds {
  float of_nodes = 0;
  float of_triangles = 0;
};

[[nodiscard]] FarBounds far_bounds_of(const Seen& seen);

/// Shares of the margins that a gap needs; above 1 if a proof is wrong.
struct NeededOfGap {
  double nodes = 0;  ///< least share with which the roots' keys keep it, that of the limit included
  double slabs = 0;  ///< the same of the blocks' slabs
  double far = 0;    ///< what the keys of far triangles are above the distance, margins left out
};

/// By one instruction set; `far` of far bodies, and the others of near ones.
[[nodiscard]] NeededOfGap needed(const Seen& seen, const detail::Kernels& kernels);

}  // namespace soms::test
