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
/// Where |D| is at most 2 V, plain doubles suffice: D_i and D_k are off by 2 each, s by 3 of its
/// units, which is 6 seen from D_k, the product by 2, and the difference by 4. 96.6 + 16 < 128.
///
/// Blocks. In float, divide the rows across by 2^(1/2): then they are as those of parity_frame.h,
/// and what is proved there holds, multiplied again, if l1_radius counts 1.5 times: S = 1.5
/// l1_radius + |B_1| + |B_2|. Along, the row has length 1.
///
/// Where the ray's line surely crosses a triangle, its place along the ray is that of the corners,
/// z_i, weighted by the areas a_i beside the edges across from them. Areas are off by less than A,
/// the area that `within` compares with, and have one sign; corners are off by E along the ray.
/// With areas as computed in place of a_i the mean moves by at most 5 A / |a_0 + a_1 + a_2| times
/// the corners' range, and with corners as computed by E; ranges as computed are short by 2 E at
/// most, and 5 A is at most 5/3 of the sum, 10/3 E. Nine roundings of the range and one of the
/// place are below 2^-20 of the range and E / 8: in all 6 A / |sum| + 2^-20 of the range, and 6 E.
///
/// Nodes are seen along the mesh's axes. With X the inverse of R as computed (relative_pose.h, with
/// r its residual), the ray's point at place p is, seen from the tree's origin,
///   v(p) = X (p w - from),   w = d / |d_k|, and from_k = 0,
/// and a moved point of the body that lies there is v(p) but for e, in units of u64 V: m and O' are
/// off by 8.02 together, `from` by 16, w by 3 and |p| is at most 3.47 V, so 10.4; seen by X, 1.74
/// times as much: 60. X w and X from are rounded, 5.3 times 3.47 and 8.6: 27. X R is not I: 10.5
/// r V. A node's origin o is abreast of p_0 = (P R)_0 o, and p_0 X w - o is a matrix times o, whose
/// entries are off by 2.3, times the 1-norm of o: 14; its products and their sums with X from are
/// off by 28.6 and 12.4. Together 142 + 10.5 r / u64, and where a far |D| is, 1.74 * 2^-95 |D|:
/// below U = s (2 (128 u64 V + 2^-95 |D| + 2^-1064) + 12 r V).
///
/// In float, in units of 2^-24 L, L the node's l1_radius. Where the ray meets a box at place p_0 +
/// x, |x| is at most L + U, so `local`, the ray at p_0 from o, is at most 4.02 L + 6.1 U in the
/// 1-norm; where it is more the ray misses, and "misses" is true however it was found. Turned to a
/// node's own axes Q it is off by 4.02 * 1.74 + 12.1, the direction by (3 + 5.3) |x|, Q^T Q by 2,
/// a direction's component that is taken for kLeastAhead by |x|: 31. Between centers and it lie
/// 5.02 L at most, and half sides are at most L: gaps are off by 5.02 once more, and inverse,
/// products and differences by 3 * 6.02 + 1: below 56. With half sides that give way by 2^-17 L +
/// U, which is 128 and more, no interval of places is too narrow, whatever the direction. Places
/// are then added to p_0, off by 2^-24 (|p_0| + 2 L) and U: 2^-20 (L + |p_0|) + U suffices. Where
/// the bound of an interval is beyond 2 L, it is off by less than it is too far.
///
/// Underflow. In the world, products with entries of P R, X and s, and what is halved, are off by
/// 2^-1075 each: fewer than 100 of them on the way to a number, X included, are below 2^-1064, of
/// which U has two. s itself, and the low parts of doubles in pairs, may be off by 2^-1074, times
/// |D|: nothing beside 2^-95 |D|. Sums and differences of doubles are exact where they are small.
/// Ends of the ray: a product of time and speed, both rounded to 2^-1075, and the rounding that
/// ends give way by, underflow to less than the 2^-1064 that they give way by, too. In float, what
/// is rounded to less than 2^-126 is off by 2^-150. W and U have 2^-100 more:
///   corners, and the ray as a node sees it, are off by less than 2^-146, of which |1 / w_k| times
///   enters into places, as it does of U; products with it, at most 2^24, by 2^-150 more;
///   twice an area by 2^-149: A has 2^-126 more, so a sum of three areas that are surely of one
///   sign is above 2^-125, one over it is below 2^125, and above 2^-100, as no sum is beyond 2^100;
///   shares of areas, which are at most 1, by 2^-150, times ranges below 2^24, and their products
///   by 2^-150 more: below 2^-125, of what 6 E leaves, which is E; 6 A over the sum is at most 2,
///   and its product with the range off by 2^-126 at most.
/// No product has three lengths or more: where corners are next to 2^-50 such a one would vanish.
///
/// Where U exceeds 2^50 floats tell nothing, and the scale is taken as 0, as there.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/geometry/detail/ray_plane.h"
#include "soms/query/detail/kernels/line_tasks.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/tree/layout/detail/wide_tree.h"

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
  struct Sheared;

  [[nodiscard]] bool shear(const RayLine& line, const ScaledDirection& direction,
                           Sheared& sheared) const;
  void see_blocks(const Sheared& sheared, LineNumbers& numbers) const;
  void see_nodes(const Sheared& sheared, LineNumbers& numbers) const;
  static void scale(LineView& view, double scale);

  ReferenceFrame reference_;
  Matrix3 rotation_;
  Vec3 half_;  // sides of the moved box, with what they give way by
  double scale_;
  double near_;      // 2 V
  double rounding_;  // W without what a far origin adds, in the mesh's units
  double residual_;  // what U has beside 2 W
};

}  // namespace soms::detail
