/// \file
/// How one tree stands to another, and by how much box tests must give way to rounding.
///
/// The claim that every test rests on. Let `u` be a point of a triangle of tree x and `v` one of
/// tree y, both relative to their trees' origins, such that the *moved and rounded* triangles share
/// the moved point. Then z = N u + D - v has |z_i| <= W on every axis i of y, where N, D are
/// `matrix_`, `shift_` below (in the mesh's units). Proof.
///
/// Write R, t for a pose, O for a tree's origin, u64 = 2^-53, and V for the sum over both bodies of
/// max_k (sum_j |R_kj| max|x_j| + |t_k|): no moved coordinate, and no partial sum of one, exceeds
/// its body's share. The moved vertex is off its real image by at most 4.01 u64 V on an axis, and a
/// convex combination no more, so the real images of u and v differ by e, |e_k| <= 4.01 u64 V.
///
/// Let X be the inverse of R_y as computed. Whatever its errors, its rows are directions, and
///   X e = (X R_x) u + X (R_x O_x + t_x - R_y O_y - t_y) - (X R_y) v.
/// Rows of X have 1-norm at most sqrt(3) (1 + 2e-6) < 1.74, as poses are orthonormal to 1e-6.
/// |u_j|, |v_j| <= 3.47 V (twice sqrt(3) times the largest moved coordinate). So |z - X e| is at
/// most the sum of these, each in units of u64 V:
///   N = fl(X R_x): 3.01 an entry (Cauchy), three entries, times 3.47:             32
///   D: the two moved origins 4.01 each, their difference 1.01, times 1.74;
///      and the product with X, 3.01 * 1.74:                                       22
///   X R_y is not I: three entries off by the measured `residual` r, times 3.47;
///      r itself is measured with an error of 3.01 u64:          10.5 r / u64  +   32
/// and |X e| is at most 1.74 * 4.01 = 7. Offsets of nodes, N o_x + D - o_y in double, add
/// 3.01 * 1.74 * 3.47 + 2 * 11.3 < 41; the test of the roots sums boxes of at most 10 V in four
/// steps, 40 more; corners of blocks, first taken about the tree's origin, are off by 1.74 * 3.47
/// and 3.47: 10 more. Together 184 + 10.5 r / u64; W = (192 u64 + 12 r) V + 2^-1064, where the last
/// covers all products that underflow. `slack` is 2 W, since tests along x's axes see N^T z, whose
/// entries are at most 1.74 W.
///
/// Nodes and blocks. With u = o_x + p and v = o_y + q, d = N o_x + D - o_y:
///   z = N p + d - q              bounds the gap along the axes of y by W, and
///   N^T z = p - N^T (q - d) + (N^T N - I) p  bounds that along the axes of x by
///   1.74 W + defect * |p|_1, `defect` being the largest entry of |N^T N - I|.
/// Any vector n in y's axes is a direction too: n z is at most |n|_1 W, and for n in x's axes
/// |n|_1 (1.74 W + defect |p|_1). So normals and edge products need no bound of their own, whatever
/// the rounding they were computed with: only their products with corners do.
///
/// Oriented nodes. A node may have axes Q of its own, floats that are orthonormal to 2^-23: then
/// p = Q_x a, q = Q_y b, and Q_y^T z = M a + Q_y^T d - Q_y^T Q_y b with M = Q_y^T N Q_x. That has
/// the form above, with M for N and Q_y^T d for d, |Q_y^T z| <= 1.74 W, and 2^-23 |b|_1 more.
///
/// In float, in units of 2^-24 S with S = radius_x + radius_y + |d|_1: entries of M are off by 10
/// at most (two products of three), d by 7, stored corners by 4, Q_y^T Q_y by 2; three products and
/// four sums add 5: a gap between centers is off by 28. Turned by M^T that is 1.74 times as much,
/// and the turn adds 13 * 1.74; radii add 13, M^T M - I 8 more than `defect`, comparisons 7: below
/// 100 a test (times |n|_1 for a direction). Where -M^T d stands for d in x's axes, M M^T d - d is
/// at most 3 defect |d|_1 more. A margin of (2^-17 + 4 defect) S is 128 and more.
///
/// No offset is needed for S: where the nodes share a point, d = z - N p + q, so |d|_1 is at most
/// 3 W and sqrt(3) (1 + 1e-5) (|p|_2 + |q|_2), in oriented axes too, and S at most 2.733 (radius_x
/// + radius_y) + 3 W. `relative` is 2.75 (2^-17 + 4 defect) a unit of radius_x + radius_y, which
/// covers the sum's rounding; what 3 W adds, below 1e-4 W, the slack has left over (1.74 of 2 W are
/// used). Where S is more, the nodes share nothing, and "apart" is true however it was found.
///
/// `slack` has 2^-100 added for what underflows in lengths; products of three or four lengths
/// get 2^-140 more where they are compared, and products of a normal and an axis 2^-147 before they
/// are multiplied by a length.
///
/// Slabs. All points p of a block of x have l <= n.p <= u, n the block's float normal, of length 1
/// to 2^-22. Seen in y's axes it is m = N n in float, each entry off by 4.01: N^T m is off n by 7
/// and 1.74 defect, so m.(N p) is off n.p by (7 * 2^-24 + 1.74 defect) |p|_1. Besides m.d is off by
/// 4 (d once rounded, three products, two sums), the stored corners q of y by 1 and m.q by 3.1, and
/// the ends of the interval by 2.1 for two sums: below 20, and |m.z| <= 1.74 W. For y's normal held
/// against x, N^T n is off by 4.01 an entry, which adds 4.01 |p|_1 in place of the 7 and defect.
/// Both stay below the margin of a test of boxes.
///
/// Triangles. Corners of x moved in float are off by 6.1 S at most, corners of y by 1: boxes of
/// triangles give way by more. What is sure beyond boxes: kernels/triangle_pairs.h.
///
/// Nothing overflows: boxes of y are below 2^22, those of x are scaled to y's units by a power of
/// two that is at most 1, d is at most 2^42 once the roots meet, and five factors stay in range.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/single_box_descent.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace soms::detail {

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Rotation of a pose.
[[nodiscard]] Matrix3 rotation(const Pose& pose);

/// Largest coordinate, and partial sum of one, that moving a vertex of `box` can give: a body's
/// share of V.
[[nodiscard]] double moved_extent(const Pose& pose, const Box& box);

/// A tree at a place, prepared to be the one in whose axes a pair is seen.
struct ReferenceFrame : ReferenceNumbers {
  ReferenceFrame(const WideTree& t, const Pose& p);

  const WideTree* tree;
};

/// Largest magnitudes of a box's coordinates.
[[nodiscard]] Vec3 farthest(const Box& box);

[[nodiscard]] MovedNumbers moved_numbers(const WideTree& tree);

/// Whether a node has axes of its own, and which; blocks have the mesh's.
inline bool is_oriented(const WideNode& node) {
  return node.oriented != 0;
}

inline bool is_oriented(const TriangleBlock&) {
  return false;
}

inline layout::Axes axes_of(const WideNode& node) {
  return node.axes();
}

inline layout::Axes axes_of(const TriangleBlock&) {
  return layout::kMeshAxes;
}

/// A 3 x 3 matrix in float, and the magnitudes of its entries; rows are padded to four.
struct Turn {
  alignas(16) std::array<std::array<float, 4>, 3> entry;
  alignas(16) std::array<std::array<float, 4>, 3> magnitude;
};

/// A node of tree x seen from one in tree y, in y's units and along the nodes' axes: what tests
/// of boxes need.
struct BoxRelation {
  BoxRelation() = default;
  BoxRelation(const BoxRelation&) = delete;
  BoxRelation& operator=(const BoxRelation&) = delete;
  ~BoxRelation() = default;

  const Turn* turn;             // M of the proof
  std::array<float, 3> offset;  // d of the proof
  float margin;                 // gaps up to this may be rounding
  float ratio;                  // turns lengths of x's layout into those of y's
  Turn own;                     // where `turn` points unless both nodes have their mesh's axes
};

/// Tree x seen in the axes of tree y.
class RelativePose {
 public:
  /// \pre  Both trees have a node; x.exponent() >= y.exponent(); the poses passed their checks.
  RelativePose(const WideTree& x, const Pose& pose_x, const ReferenceFrame& y);

  /// A box in the world in place of x: that of a body at the identity, whose origin is the center.
  /// \pre  y has a node, the box is not empty, and its ends are within kMaxCoordinate.
  RelativePose(const Box& x, const ReferenceFrame& y);

  /// The same of one found among others.
  RelativePose(const WideTree& x, const WideTree& y, const RelativePoses& poses, std::size_t i);

  /// Puts it beside others, for that constructor; `box` is its `single_box`, the place found if y
  /// has a ground plan. \pre Bit i of `poses.apart` is clear.
  void put(RelativePoses& poses, std::size_t i, const SingleBox& box) const;

  /// Makes `numbers` and `relate` ready, which cost more than most queries of a small body.
  void prepare();

  /// All of x as one box. Not returned, as GroundPlan::place is not.
  void single_box(SingleBox& box) const;

  /// The roots' boxes are surely apart: nothing overlaps, and nothing else may be queried.
  [[nodiscard]] bool apart() const { return apart_; }

  /// Turns lengths of x's layout into those of y's.
  [[nodiscard]] float ratio() const { return numbers_.ratio; }

  [[nodiscard]] const PoseNumbers& numbers() const { return numbers_; }

  /// That of the reference frame.
  [[nodiscard]] double residual() const { return residual_; }

  /// Where `x`, a node or block of tree x, is as seen from `y`, one of tree y.
  template <class X, class Y>
  void relate(const X& x, const Y& y, BoxRelation& relation) const {
    relation.offset = numbers_.offset(x.origin, y.origin);
    relation.turn = &turn_;
    if (is_oriented(x) || is_oriented(y)) {
      turn(axes_of(x), axes_of(y), relation);
    }
    relation.margin =
        numbers_.relative * (x.l1_radius * numbers_.ratio + y.l1_radius) + numbers_.slack;
    relation.ratio = numbers_.ratio;
  }

 private:
  /// \param exponents By which the units of the layouts differ.
  RelativePose(const MovedNumbers& x, const Pose& pose_x, const ReferenceFrame& y, int exponents);

  /// M and Q_y^T d for nodes with axes of their own.
  void turn(const layout::Axes& x, const layout::Axes& y, BoxRelation& relation) const;

  PoseNumbers numbers_;
  std::array<double, 9> matrix_;  // rows of N
  double residual_;
  int exponents_;                    // by which the units of the layouts differ
  std::array<double, 3> half_seen_;  // of x's box along y's axes
  Turn turn_;                        // N in float, once prepared
  bool apart_;
};

}  // namespace soms::detail
