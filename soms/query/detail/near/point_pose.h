/// \file
/// What float bounds of a point's distances are worth: the proof that nothing near is dropped.
///
/// A point P beside a body at a pose R, t: the tree's origin O lies at C = R O + t as computed, X
/// is the inverse of R as computed, and D = X (P - C) is the point's place from the tree's origin.
/// With y a point of a moved and rounded triangle, v the same from the tree's origin and
/// z = D - v, this is the case of near_pose.h whose first body is the point: N, p and u are
/// nothing, and z = X (P - y) + w. u64 = 2^-53; V is the largest moved coordinate plus that of P.
///
/// Rounding. In units of u64 V on an axis of w: moved vertices are off by 4.01, times 1.74 for a
/// row of X: 7; C by 4.01, P - C by 1.01, the product with X by 3.01, times 1.74: 14; X R is not
/// I: 10.5 r / u64 + 32, r being the measured residual (relative_pose.h). The place from the origin
/// of a node or block, D - o, is a difference of two numbers of at most 3.5 V: 7. Corners of
/// blocks, first taken about the tree's origin: 10. Together 70 + 10.5 r / u64; W = (96 u64 + 12 r)
/// V + 2^-1064. `slack` is 2 W, for axes of a node that see 1.74 W.
///
/// Stretch. |X (P - y)| is within (1 +- s) |P - y|, s = 2 E + 4 r + 32 u64 with E = max |R^T R - I|
/// (near_pose.h). So `limit`, in units of the layout, is upper (1 + s) rounded up: what is as near
/// as `upper` has no larger key.
///
/// Boxes. Let d be the offset from the node's origin, rounded to float, u = 2^-24, S = |d|_1 +
/// radius. In units of u S: d is off by 1 on an axis of the mesh, by 1.74 along one of the node;
/// the product with the node's axes by 3.01 * 1.74, and these are orthonormal to 2^-23: 4; the
/// differences of centers and half sides round by 3. That is below 14 beside W; each gap gives way
/// by 64 u S + 2 W. Lengths of gap vectors are lengths of z to 2^-22 for the node's axes; eight
/// roundings of a length are below 2^-21: keys are shortened by 2^-19.
///
/// Triangles. A corner's offset from the point is off by 3 u S on an axis beside W: the stored
/// corner by 1, d by 1, their difference by 1. Any direction n proves a lower bound, the least
/// product of n and a corner over the length of n, whatever rounding n was made with. Products and
/// sums add 3.02 u S |n|_1: below 7 u S |n|_1 in all, for which 16 are taken off, and W |n|_1
/// beside them, for which 2 W. 2^-140 covers what underflows; the length, the quotient and the
/// product round by less than 2^-20, for which keys are shortened by 2^-19.
///
/// Underflow. Squares of gaps that underflow turn a root by 2^-74 at most (near_pose.h), products
/// of gaps' parts lose 2^-150. Of the 2 W that gaps give way by, 1.74 W are used, and 2 W is above
/// 2^-66 unless the body is a point: then each point is far, or on it. The length of a direction is
/// taken as 2^-60 at least; longer ones are rounded by 2^-29 of them. Divisors of shares are 2^-100
/// at least, so shares are finite or clamped: they only choose the direction.
///
/// Far points. Where the point is many times the body's size away, u S outweighs the body. Then
/// directions differ little, and one decides, as for far bodies (near_pose.h): with w the way from
/// a node's origin to the point in the world, |P - y| >= w.(P - y) / |w|. Keys are bounds less
/// `base`, the distance of the tree's origin. Margins are those of far bodies: 256 u64 V + 2^-1064
/// and 2^-19 radius.
#pragma once

#include "soms/base/vector.h"
#include "soms/query/body.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/relative_pose.h"

#include <array>
#include <limits>

namespace soms::detail {

/// A body as queries of points see it: what does not depend on the point.
class PointFrame {
 public:
  /// \pre The pose passed its check and the mesh is not empty. The body must stay.
  explicit PointFrame(const Body& body);

  [[nodiscard]] const PosedShape& body() const { return body_; }

  [[nodiscard]] const ReferenceFrame& reference() const { return reference_; }

  /// s of the proof.
  [[nodiscard]] double stretch() const { return stretch_; }

  /// From its tree's origin no point of the body is farther.
  [[nodiscard]] double radius() const { return radius_; }

 private:
  PosedShape body_;
  ReferenceFrame reference_;
  double stretch_;
  double radius_;
};

/// A point beside a tree. Keys and limits are floats in units of the tree's layout.
class PointPose {
 public:
  /// The frame must stay.
  PointPose(const PointFrame& frame, const Vec3& point);

  /// Only what may be as near as `upper`, a distance in the world, counts from now on.
  void set_limit(double upper);

  /// Boxes and triangles whose keys exceed this are not as near.
  [[nodiscard]] float limit() const { return limit_; }

  /// Nothing whose box has this key is nearer than this in the world.
  [[nodiscard]] double distance_of(float key) const;

  /// The point is so far off that `far_keys` bound distances.
  [[nodiscard]] bool far() const { return far_; }

  [[nodiscard]] const PointNumbers& numbers() const { return numbers_; }

  /// As Kernels::bound_boxes and Kernels::bound_triangles, for far points.
  void far_keys(const WideNode& node, PointNodeKeys& keys) const;
  void far_keys(const TriangleBlock& block, PointBlockKeys& keys) const;

 private:
  /// What a direction gives for all lanes of a node or block.
  struct Heading {
    Vec3 along;          ///< the direction along its axes
    double between = 0;  ///< of its origin and the point along it, less `base_`
    double margin = 0;   ///< what bounds give way by
  };

  template <class Y>
  [[nodiscard]] Heading heading(const Y& y) const;

  const PointFrame* frame_;
  Vec3 point_;
  PointNumbers numbers_;
  double base_ = 0;   // what keys of far points leave out, in the world
  double slack_ = 0;  // of far points, in units of the layout
  bool far_ = false;
  float limit_ = std::numeric_limits<float>::infinity();
};

}  // namespace soms::detail
