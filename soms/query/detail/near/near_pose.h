/// \file
/// What float bounds of distances are worth: the proof that nothing near is dropped.
///
/// Near bodies. Let a, b be points of the moved and rounded triangles, g = a - b in world
/// coordinates, and z = N u + D - v the same seen by relative_pose.h in the axes of y. There g was
/// 0 and |z_i| <= W; the same sums give z = X g + w with |w_i| <= W for any g, since no term of W
/// uses that the points meet: its largest factors are moved coordinates, which V bounds.
///
/// Stretch. X is the inverse of R_y but for what rounding and the pose itself leave, and a pose is
/// orthonormal to 1e-6 only. With E = max |R_y^T R_y - I| lengths change by R_y^-1 by a factor
/// within 1 +- 1.53 E, and with r = max |X R_y - I| by X R_y by one within 1 +- 3 r. E is measured
/// with an error of 4 u64, r with one of 3.01 u64: |X g| is within (1 +- s) |g| for
/// s = 2 E + 4 r + 32 u64.
///
/// Keys. A key of two boxes is a lower bound of |X g| over their points, made of gaps along axes or
/// one other direction. A gap along an axis of either node is off by (2^-17 + 4 defect) S + 2 W at
/// most, with S = radius_x + radius_y + |d|_1 (relative_pose.h: below 100 of 128 units for a test
/// of an axis; a direction n takes |n|_1 times that). Lengths of gap vectors are lengths of |X g|
/// to the factor that axes are off by: 2^-21 for those of two nodes, 1 + 1.5 defect for N; eight
/// roundings of a length add 2^-21. `shrink` is 1 - 2^-19 - 2 defect.
///
/// The offset. Let m = 2^-17 + 4 defect and let two nodes hold points with |X g| <= z. Then
/// |d|_1 <= sqrt(3) (z + W + |p|_2 + |q|_2), so S <= 2.733 (radius_x + radius_y) + 1.74 (z + W).
/// Kernels subtract 2.75 m (radius_x + radius_y) + 2 W from each gap. What is left of m S, at most
/// 1.74 m z on an axis, is sqrt(3) times that in a vector of three: the key is at most
/// z (1 + 3.02 m). So a pair whose key exceeds (1 + 4 m) z has no points that near: `limit`. Tests
/// of slabs and of triangles' boxes along one axis take z and 1.74 m z more than for overlap, with
/// axes and normals of length 1 to 2^-22: `slack` of the numbers here has z (1 + 4 m) added. Large
/// leaves take `limit` along axes, and |n|_2 times it along other directions n (LargeLeaf).
///
/// Underflow. Products of two lengths lose 2^-150 each, so a square of a gap vector or of the reach
/// is off by 3 * 2^-150 and its root by 2^-74. Gaps give way by 2 W, of which axes use 1.74 W:
/// `rounding` of the numbers here is 2^-70 at least, so 2^-73 of it is left. W alone is above 2^-68
/// unless y is a point, since V is at least half of y's size over sqrt(3) and y's size 2^-20 in its
/// unit (or tiny in a unit of 2^-1000, where W's 2^-1064 is more). Along other directions v a gap
/// has 2^-140 taken off and is divided by 2^-60 at least: |v| is rounded by 2^-29 of it there. The
/// radii of y along v, by 2^-148 of half_y, then by that over 2^-60: beside 2^-20 half_y, which
/// boxes that an axis parts are surely apart, that is below 2^-66 of it.
///
/// Far bodies. Where bodies are many times their size apart, 2^-17 of the offset outweighs them.
/// Then directions differ little, and one decides: with w = c_x - c_y, the world difference of the
/// nodes' origins rounded to float, |g| >= w.g / |w|, and w.g = w.(c_x - c_y) + (R_x^T w).p -
/// (R_y^T w).q. No rotation is inverted, so none need be orthonormal. Keys are bounds less `base`,
/// the distance of the roots' origins: what is left is as small as the bodies. In units of u64 V, V
/// as in relative_pose.h: moved origins 4.01 each and their difference 1.01 on an axis, the moved
/// vertices 4.01; times sqrt(3) below 23; the product with w / |w| and the base another 12 of |c_x
/// - c_y|, which is below 3.5 V: below 65. The slack is 256 u64 V, and 2^-1064 for products that
/// underflow; w is scaled before it is squared, so |w| does not. Sums over boxes in float are off
/// by less than 2^-19 (radius_x + radius_y), since no more than twelve roundings and the axes'
/// 2^-23 meet; 2^-100 units of a layout are added for floats that underflow. FarSearch comes first,
/// with one direction for all nodes; this serves where it gives up.
#pragma once

#include "soms/base/vector.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/relative_pose.h"

#include <array>
#include <cstdint>
#include <limits>

namespace soms::detail {

/// `max |R^T R - I|`.
[[nodiscard]] double skew(const Matrix3& r);

/// Two trees at their places, as queries of nearness see them. Keys and limits are floats in units
/// of y's layout.
class NearPose {
 public:
  explicit NearPose(PairFrame& frame);
  /// A copy has a limit of its own.
  NearPose(const NearPose&) = default;
  NearPose& operator=(const NearPose&) = delete;
  ~NearPose() = default;

  /// Only what may be as near as `upper`, a distance in the world, counts from now on.
  void set_limit(double upper);

  /// Pairs whose keys exceed this are not as near.
  [[nodiscard]] float limit() const { return limit_; }

  /// No points whose boxes have this key are nearer than this in the world.
  [[nodiscard]] double distance_of(float key) const;

  /// Bodies are so far apart that `far_keys` bound their distances.
  [[nodiscard]] bool far() const { return far_; }

  /// Numbers for tests of near bodies: slabs and boxes within the limit pass.
  [[nodiscard]] const PoseNumbers& numbers() const { return numbers_; }

  /// As Kernels::bound_nodes, for far bodies.
  void far_keys(const NodeTask& task, float limit, NodeKeys& keys) const;

  /// Keys of the pairs of triangles of two blocks, row by row of x.
  using BlockKeys = std::array<std::array<float, TriangleBlock::kWidth>, TriangleBlock::kWidth>;
  void far_keys(const TriangleBlock& x, const TriangleBlock& y, BlockKeys& keys) const;

 private:
  /// What a direction gives for all pairs of two nodes or blocks.
  struct Heading {
    std::array<float, 3> in_x;  ///< the direction along x's axes, of length 1 or nearly so
    std::array<float, 3> in_y;
    double between = 0;  ///< of the origins along it, less `base_`, in units of y
    double margin = 0;   ///< what bounds give way by
  };

  /// Of two nodes or two blocks.
  template <class X, class Y>
  [[nodiscard]] Heading heading(const X& x, const Y& y) const;

  PosedShape x_;
  PosedShape y_;
  PoseNumbers numbers_;
  double stretch_;
  double scale_;      // of y's layout, 0 where rounding outweighs all
  double base_ = 0;   // what keys of far bodies leave out, in the world
  double slack_ = 0;  // of far bodies, in units of y
  bool far_ = false;
  float limit_ = std::numeric_limits<float>::infinity();
};

}  // namespace soms::detail
