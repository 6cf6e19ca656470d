/// \file
/// A body as rays in any direction see it, and what float tests of such rays are worth: the proof
/// that no hit is lost, and none is invented.
///
/// This is the proof of parity_frame.h, which is for rays along axis k, carried over to a direction
/// d of which component k is the largest. Take P with the rows
///   p0 = sign(d_k) e_k,   p1 = e_i - s_i e_k,   p2 = e_j - s_j e_k,   s = d / d_k,
/// so that P moves the ray to axis 0: with m a moved vertex and o the ray's origin, m is on the
/// ray's line if p1.(m - o) = p2.(m - o) = 0, and p0.m grows along the ray. Rows of P R stand for
/// rows of R. They have 2-norms up to 2^(1/2) (1 + 1e-6) and 1-norms up to 2; u64 = 2^-53, V, O and
/// s(cale) as there.
///
/// Along the ray, places are taken from the tree's origin, not from the ray's, and the ray is an
/// interval of them: so a far origin spoils nothing. Across, D = O' - o with O' = fl(R O + t) is
/// exact as a sum of two doubles, and s_i is in double-double: `from`, D_i - s_i D_k, is off by
/// 2^-95 |D| beside the roundings that follow. For segments so is d, exactly to - from.
///
/// In the world, in units of u64 V: m is off by 4.01 on an axis and O' too, seen across 8.02 each.
/// Entries of P R are off by 4, times the 1-norm of o or x - O, at most 6.01 V: 24. Their products
/// with it and sums are off by 3.01 * 1.4143 * 3.47 = 14.8. Rays that pass the moved box farther
/// than its shadow are dropped before, so sums are below 12 V: 12. Stored corners were off by 10.41
/// on an axis, seen across by at most 2.46 of that: 25.7. A start of the ray within 4 V: 4.
/// Together 96.6 < 128: W = s (128 u64 V + 2^-95 |D| + 2^-1064).
///
/// In float, divide the rows across by 2^(1/2): then they are as those of parity_frame.h, and what
/// is proved there holds, multiplied again, if l1_radius counts 1.5 times: S = 1.5 l1_radius +
/// |B_1| + |B_2|. Strips: the 2 by 3 matrix of p1 and p2 has norm at most 3^(1/2), so |n|_1 is at
/// most 6^(1/2) = 2.45: 2.5 times the margin. Along, the row has length 1.
///
/// Where W exceeds 2^50 floats tell nothing, and the scale is taken as 0, as there.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/geometry/detail/exact_ray.h"
#include "soms/geometry/detail/ray_plane.h"
#include "soms/query/detail/kernels/line_tasks.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/tree/layout/wide_tree.h"

namespace soms::detail {

/// A ray beside a tree, in doubles and as kernels see it.
struct RayCourse {
  LineNumbers numbers;
  double start = 0;     ///< along, from the tree's origin
  double speed = 0;     ///< growth along for each unit of the scaled direction
  double shortest = 0;  ///< `length` of the scaled direction surely is at least this
  double longest = 0;   ///< and at most this

  /// Only what is met until this time, in units of the scaled direction, matters from now on.
  void set_far(double time);
};

/// A tree at a place.
class RayFrame {
 public:
  /// \pre The tree is not empty; the pose passed its checks.
  RayFrame(const WideTree& tree, const Pose& pose);

  /// False if the ray surely misses the body's box; `course` may be unfinished then.
  [[nodiscard]] bool start(const RayLine& line, const ScaledDirection& direction,
                           RayCourse& course) const;

 private:
  Matrix3 rotation_;
  Vec3 origin_;  // of the tree, moved
  Vec3 half_;    // sides of the moved box, with what they give way by
  double scale_;
  double rounding_;
};

}  // namespace soms::detail
