/// \file
/// How one tree stands to another, and by how much box tests must give way to rounding.
///
/// The claim that every test rests on. Let `u` be a point of a triangle of tree x and `v` one of
/// tree y, both relative to their trees' origins, such that the *moved and rounded* triangles share
/// the moved point. Then z = N u + D - v has |z_i| <= W on every axis i of y, where N, D, W are
/// `matrix`, `shift`, `slack` below (in the mesh's units). Proof.
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
/// Places. With u = o_x + p and v = o_y + q, d = N o_x + D - o_y:
///   z = N p + d - q              bounds the gap along the axes of y by W, and
///   N^T z = p - N^T (q - d) + (N^T N - I) p  bounds that along the axes of x by
///   1.74 W + defect * |p|_1, `defect` being the largest entry of |N^T N - I|.
/// Any vector n in y's axes is a direction too: n z is at most |n|_1 W, and for n in x's axes
/// |n|_1 (1.74 W + defect |p|_1). So normals and edge products need no bound of their own, whatever
/// the rounding they were computed with: only their products with corners do.
///
/// In float: S = reach_x + reach_y + |d|_1. A gap between centers carries the rounding of d, of
/// entries of N, of three products and four sums, and of stored corners: 9 * 2^-24 S; turned by N^T
/// that is 1.74 times as much, and the turn adds 4 * 1.74; radii and the comparison add 7: below
/// 30 * 2^-24 S a test (times |n|_1 for a direction). Where -N^T d stands for d in x's axes,
/// N N^T d - d is at most 3 defect |d|_1. `relative` = 2^-18 + 4 defect, 64 * 2^-24 and more,
/// leaves a factor two. `slack` has 2^-100 added for what underflows in lengths; products of three
/// lengths get 2^-140 more where they are compared. Nothing overflows: boxes of y are below 2^22,
/// those of x are scaled to y's units by a power of two that is at most 1, d is at most 2^42 once
/// the roots meet, and five factors stay in range.
#pragma once

#include "soms/base/pose.h"
#include "soms/tree/layout/wide_tree.h"

#include <array>
#include <cmath>

namespace soms::detail {

using Matrix3 = std::array<std::array<double, 3>, 3>;
using Matrix3f = std::array<std::array<float, 3>, 3>;

/// Rotation of a pose.
[[nodiscard]] Matrix3 rotation(const Pose& pose);

/// A tree at a place, prepared to be the one in whose axes a pair is seen.
struct Viewer {
  Viewer(const WideTree& t, const Pose& p);

  const WideTree* tree;
  Pose pose;
  Matrix3 inverse;      // of the rotation, as computed
  double residual = 0;  // largest entry of |inverse * rotation - I|
  double reach = 0;     // largest moved coordinate, bounded; V of the proof is a sum of two
};

class RelativePose;

/// A place in tree x seen from one in tree y, in y's units: what a test of boxes needs.
struct Relation {
  const RelativePose* pose;
  std::array<float, 3> offset;  ///< d of the proof
  float margin;                 ///< gaps up to this may be rounding
};

/// Tree x seen in the axes of tree y.
class RelativePose {
 public:
  /// \pre  Both trees have a node; x.exponent() >= y.exponent(); the poses passed their checks.
  RelativePose(const WideTree& x, const Pose& pose_x, const Viewer& y);

  /// The roots' boxes are surely apart: nothing overlaps, and nothing else may be asked.
  [[nodiscard]] bool apart() const { return apart_; }

  /// N of the proof.
  [[nodiscard]] const Matrix3f& matrix() const { return rounded_; }

  [[nodiscard]] const Matrix3f& magnitude() const { return magnitude_; }

  /// Turns lengths of x's layout into those of y's.
  [[nodiscard]] float ratio() const { return ratio_; }

  /// Offset d and margin of a pair of places, `reach_x` in units of x.
  [[nodiscard]] Relation between(const std::array<double, 3>& x, float reach_x,
                                 const std::array<double, 3>& y, float reach_y) const {
    Relation relation{this, {}, 0};
    float distance = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double turned = (matrix_[i][0] * x[0] + matrix_[i][1] * x[1]) + matrix_[i][2] * x[2];
      relation.offset[i] = static_cast<float>(((turned + shift_[i]) - y[i]) * scale_);
      distance += std::abs(relation.offset[i]);
    }
    relation.margin = relative_ * ((reach_x * ratio_ + reach_y) + distance) + slack_;
    return relation;
  }

 private:
  [[nodiscard]] bool roots_apart(const WideNode& x, double unit_x, const WideNode& y, double unit_y,
                                 double slack) const;

  Matrix3 matrix_ = {};
  std::array<double, 3> shift_ = {};
  double scale_ = 1;
  Matrix3f rounded_ = {};
  Matrix3f magnitude_ = {};
  float ratio_ = 1;
  float relative_ = 0;
  float slack_ = 0;
  bool apart_ = false;
};

}  // namespace soms::detail
