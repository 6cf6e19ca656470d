/// \file
/// Bodies that touch at one moved and rounded vertex, and how much of the margins of
/// relative_pose.h they need.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/random.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/tree/shape.h"

namespace soms::test {

/// Two bodies of one segment each, which is a diagonal of its box. Both moved to the same place at
/// vertices `x` and `y`; body y is the one in whose axes they are seen.
struct Touch {
  Pose pose_x;
  Pose pose_y;
  Vec3 x;
  Vec3 end_x;
  Vec3 y;
  Vec3 end_y;
};

[[nodiscard]] Shape shape_x(const Touch& touch);
[[nodiscard]] Shape shape_y(const Touch& touch);

/// Shifts body y so that both vertices are moved to the same place; false where no shift that
/// rounds so was found.
[[nodiscard]] bool bring_together(Touch& touch);

/// A touch at corners of both boxes that are the farthest ones along an axis of y; `far` from the
/// origin.
[[nodiscard]] Touch random_touch(Rng& rng, double far);

/// The touch with a few numbers changed by a little; most often in their last bits.
[[nodiscard]] Touch changed(Rng& rng, Touch touch);

/// Shares of what the proof of relative_pose.h grants that a touch needs; at most 1 if the proof is
/// right.
struct Needed {
  double along_y = 0;  ///< largest |z_i|, of W
  double along_x = 0;  ///< largest |(N^T z)_j|, of 2 W
  double of_roots =
      -1;  ///< by how much the roots' boxes are apart in doubles, of 2 W; negative where they meet
};

/// What is needed where body y is seen from `frame`, in extended precision. \pre Units of both
/// bodies are 1.
[[nodiscard]] Needed needed(const Touch& touch, const Shape& x, const Shape& y,
                            const detail::ReferenceFrame& frame);

[[nodiscard]] Needed needed(const Touch& touch);

}  // namespace soms::test
