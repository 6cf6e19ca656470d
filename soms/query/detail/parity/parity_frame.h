/// \file
/// A body as rays along a world axis see it, and what float tests of such rays are worth: the proof
/// that no crossing is lost, and none is invented.
///
/// The question. A point p, a ray from p along world axis a, one way or the other, and triangles
/// whose vertices m = fl(R x + t) are moved and rounded. Kernels tell of a triangle that the ray
/// surely crosses it off its edges, that it surely misses it and p is not on it, or that floats
/// cannot tell; the last are decided exactly (triangle_crossing.h). A node whose bit is not set
/// holds none but surely missed ones.
///
/// In the world. Write O for the tree's origin, o for that of a node or block relative to it, s for
/// the layout's scale, u64 = 2^-53, and V for max_k (sum_j |R_kj| max|x_j| + |t_k|), as
/// relative_pose.h does for one body. A moved vertex is off R x + t by 4.01 u64 V on an axis at
/// most. Computed are D = fl(R O + t) - p and B = s (D + R o), in double. `outside` was true for
/// all points with |D_k| > H_k + 64 u64 V, H the half sides of the moved box: so |D_k| is below 3.5
/// V here, and each entry of o and x - O at most 3.47 V. In units of u64 V, D is off by 4.01
/// and 3.5, R o by 3.01 * 3.47 = 10.5 (Cauchy), the sum by 7: together 25. Stored corners c were
/// taken about O and o in double, off by 3.47 and 6.94, seen along a row of R by 1.74 times
/// that: 18.1. So
///   s (m - p)_k = (R c)_k + B_k + e,  |e| <= W = s (64 u64 V + 2^-1064),
/// since 25 + 18.1 + 4.01 < 64; the last term covers all products that underflow. `slack` is W
/// rounded up, and 2^-100 for what underflows in float. Without a rotation less is rounded.
///
/// Nodes. A node's boxes hold points b with s (x - O - o) = Q b for its axes Q, exactly floats
/// (frame.h). Then s (m - p) = (R Q) b + B + e. In float, in units of 2^-24 S with S = l1_radius +
/// |B_1| + |B_2| across the ray (l1_radius + |B_0| along it): entries of R Q are off by 5, products
/// with centers and radii 3 more, sums 2, B by 1, the comparison 2: below 16. So the ray misses
/// what lies beyond 2^-20 S + W on an axis; the margin is 2^-19 S + W. Oriented boxes are seen as
/// hexagons. A direction n = (-z_k, y_k) across the ray, made of floats, is a direction whatever
/// its errors: n . (y, z) is off by |n|_1 (11 S for both coordinates, 8 S for the products n and
/// R Q, each rounded, 4 S for the sums) in those units, below 24, and |n|_1 W; |n|_1 is below
/// 1.4143 (1 + 2e-6), so 1.5 times the margin suffices. Other than for two trees no inverse and no
/// transpose of R stands for one another, so no pose needs to be orthonormal for it.
///
/// Blocks. Corners seen from p are off by 5.01 for R c, 1 for B, 1 for the sum: 7.01 of 2^-24 S
/// for S as above; `error` E = 2^-21 S + W and the like along the ray. Twice the area beside an
/// edge, y0 z1 - z0 y1, has factors of at most (1 + 1e-6) S: it is off by 4 E S + 2 E^2 for those
/// and by 2^-22 S^2 < E S / 2 for its own rounding, below E (5 S + 3 E); compared is E (6 S + 4 E)
/// + 2^-140, where the last covers underflow. Two areas of different signs: p is outside of the
/// triangle seen along the ray, however thin. Three of one sign: strictly inside. All
/// corners surely ahead or behind: so is the triangle.
///
/// Underflow. In the world, products with entries of R, and what is halved, are off by 2^-1075
/// each: 17 of them are below 2^-1064. Sums and differences of doubles are exact where they are
/// that small. In float, what is rounded to less than 2^-126 is off by 2^-150: a row's product with
/// a corner, center or radius by less than 2^-147, once more for R Q; magnitudes of n by 2^-149,
/// times a radius below 2^23. All are below the 2^-100 of `slack`, and so are margins that
/// underflow themselves. Twice an area is off by 2^-149, and what it is compared with by as much:
/// below 2^-140. Nothing is divided.
///
/// Nothing overflows: corners are below 2^22, and B below 2^24 + W. Where W exceeds 2^50, the body
/// is less than a rounding of where it lies: then s is taken as 0 and W as 2^50, floats tell
/// nothing, and every triangle is decided exactly.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/query/detail/kernels/parity_tasks.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstddef>

namespace soms::detail {

/// A tree at a place, as rays along one of the world's axes see it: the one on which it is
/// shortest, so that rays meet little of it.
class ParityFrame {
 public:
  /// \pre The tree is not empty; the pose passed its checks.
  ParityFrame(const WideTree& tree, const Pose& pose);

  [[nodiscard]] const RayNumbers& numbers() const { return numbers_; }

  /// The axis of all rays: 0 is x.
  [[nodiscard]] std::size_t axis() const { return numbers_.axis[0]; }

  /// True if the point is surely off the body's box. \pre The point is within 2^300.
  [[nodiscard]] bool outside(const Vec3& point) const;

  /// The ray from a point to the nearer side of the box.
  [[nodiscard]] RayStart start(const Vec3& point) const;

 private:
  RayNumbers numbers_;
  Vec3 origin_;  // of the tree, moved
  Vec3 half_;    // sides of the moved box, with what they give way by
};

}  // namespace soms::detail
