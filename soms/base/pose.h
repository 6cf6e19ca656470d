/// \file
/// Rigid placements of bodies, and the one way a vertex is moved.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"

#include <array>
#include <span>

namespace soms {

/// What a pose made of a matrix takes as its rotation. Floats and printed digits are often too
/// coarse for a pose as they are.
enum class Rotation {
  as_given,  ///< entries as they are, off a rotation by at most 1e-6
  nearest,   ///< what `Pose::normalized` makes of entries that are off by at most 1e-3
};

template <>
inline constexpr auto kWords<Rotation> = words(
    "Rotation", "What a matrix is taken as: its entries as they are, or the nearest rotation.",
    "as_given", "nearest");

/// Rigid motion `[R | t]`, row-major 3x4 doubles: `r00 r01 r02 tx  r10 r11 r12 ty  r20 r21 r22 tz`.
/// A default pose is the identity. Queries check a pose once, when they start (`check`).
struct Pose {
  std::array<double, 12> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  [[nodiscard]] bool operator==(const Pose&) const = default;

  [[nodiscard]] static Pose identity() { return {}; }

  [[nodiscard]] static Pose translation(double x, double y, double z);

  /// Rotation by the quaternion `(w, x, y, z)`, then the shift `t`. Refused when |q|^2 is off 1 by
  /// more than 1e-6. With n = ((w*w + x*x) + y*y) + z*z and s = 2 / n, entries are
  /// `1 - s*(y*y + z*z)`, `s*(x*y - w*z)` and so on, evaluated as written in pose.cpp, so the
  /// matrix is the same bits everywhere and passes `check`. \errors ErrorKind::not_rigid,
  /// ErrorKind::not_finite.
  [[nodiscard]] static Pose from_quaternion(double w, double x, double y, double z,
                                            const Vec3& t = {});

  /// Rotation by `angle` radians counter-clockwise about +z, then the shift `t`. The sine and
  /// cosine are those of the C library, whose last bits differ between platforms.
  [[nodiscard]] static Pose about_z(double angle, const Vec3& t = {});

  /// Rotation by `angle` radians about `axis`, counter-clockwise when the axis points at the
  /// viewer, then the shift `t`. The axis may have any length but 0.
  ///
  /// The axis is scaled by the power of two that brings its largest component into [1, 2). With
  /// k = sin(angle / 2) / sqrt((x*x + y*y) + z*z) of the scaled axis, the result is
  /// `from_quaternion(cos(angle / 2), k*x, k*y, k*z, t)`. Sine and cosine as in `about_z`; all else
  /// is the same bits everywhere. \errors ErrorKind::usage for an axis of length 0;
  /// ErrorKind::not_finite.
  [[nodiscard]] static Pose from_axis_angle(const Vec3& axis, double angle, const Vec3& t = {});

  /// The pose of a 4x4 matrix that moves column vectors, stored row by row: entries 3, 7 and 11 are
  /// the shift. The pose passes `check`.
  /// \errors ErrorKind::not_finite; not_rigid unless the last row is 0 0 0 1, and as `check` or,
  ///         with Rotation::nearest, as `normalized`. A matrix that is stored by columns, or that
  ///         scales, is named as such.
  [[nodiscard]] static Pose from_row_major(std::span<const double, 16> matrix,
                                           Rotation rotation = Rotation::as_given);

  /// The same, stored column by column, as OpenGL, glm and Eigen do: entries 12, 13 and 14 are the
  /// shift. \errors As `from_row_major`.
  [[nodiscard]] static Pose from_column_major(std::span<const double, 16> matrix,
                                              Rotation rotation = Rotation::as_given);

  /// The 4x4 matrix whose last row is 0 0 0 1, row by row, or column by column.
  [[nodiscard]] std::array<double, 16> to_row_major() const;
  [[nodiscard]] std::array<double, 16> to_column_major() const;

  /// The motion back, by the inverse matrix rather than the transposed one: adj(R) / det(R), where
  /// a cofactor is `a*b - c*d`, and then `0 - ((i00*tx + i01*ty) + i02*tz)` and likewise. The
  /// product with this pose, in either order, is off the identity by at most 4e-15 in each entry of
  /// R and by 1e-14 of |tx| + |ty| + |tz| in the shift. \errors As `check`.
  [[nodiscard]] Pose inverse() const;

  /// The rotation nearest to R with the same shift: for products of very many poses. For a
  /// matrix that is too far off a rotation to be a pose, see Rotation::nearest. Three steps of `R
  /// := R + (R * (I - RtR)) / 2`, whose rounding leaves entries of RtR - I of at most 4e-15.
  /// \errors ErrorKind::not_rigid where an entry of RtR - I is above 1e-3 before, or where R
  /// mirrors; not_finite.
  [[nodiscard]] Pose normalized() const;

  [[nodiscard]] Vec3 shift() const { return {m[3], m[7], m[11]}; }

  /// The moved vertex: `((r00*x + r01*y) + r02*z) + tx` and likewise y', z', each operation rounded
  /// once, in this order. This is a fact that answers are exact about, so it lives in a source file
  /// compiled without contraction.
  [[nodiscard]] Vec3 apply(const Vec3& v) const;
};

/// `b` first, then `a`: a body at `b` in the frame of a parent at `a`. Entry i,j of the rotation is
/// `(ai0*b0j + ai1*b1j) + ai2*b2j`, the shift is `a.apply(b.shift())`, each operation rounded once.
///
/// The product is a pose of its own, so `(a * b).apply(v)` and `a.apply(b.apply(v))` may differ in
/// the last bits. Each product adds what its factors are off a rotation, and up to 2e-15. Neither
/// factor is checked; queries check a pose when they start.
[[nodiscard]] Pose operator*(const Pose& a, const Pose& b);

/// Largest magnitude of a coordinate, before and after moving: 2^300.
inline constexpr double kMaxCoordinate = 0x1p300;

/// Throws unless the pose is finite and rigid: |RtR - I| at most 1e-6 in every entry, det R > 0.
/// \errors ErrorKind::not_finite, ErrorKind::not_rigid; the message names the entry that is off.
///         ErrorKind::unsupported where there is no `PlainArithmetic`.
void check(const Pose& pose);

/// Throws unless every vertex of a mesh with bounds `box` stays within `kMaxCoordinate` when moved:
/// `sum |r|*max + |t| <= 2^300` on each axis. O(1). An empty box passes.
/// \errors ErrorKind::out_of_range.
void check_range(const Pose& pose, const Box& box);

/// How far entries of RtR - I of a pose may be off 0.
inline constexpr double kRigidTolerance = 1e-6;

/// Whether `check` and `check_range` both pass. For callers that hold a `PlainArithmetic`.
[[nodiscard]] bool passes_checks(const Pose& pose, const Box& box);

}  // namespace soms
