/// \file
/// Rigid placements of bodies, and the one way a vertex is moved.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"

#include <array>

namespace soms {

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

  /// Rotation by `angle` radians counter-clockwise about +z, then the shift `t`.
  [[nodiscard]] static Pose about_z(double angle, const Vec3& t = {});

  [[nodiscard]] Vec3 shift() const { return {m[3], m[7], m[11]}; }

  /// The moved vertex: `((r00*x + r01*y) + r02*z) + tx` and likewise y', z', each operation rounded
  /// once, in this order. This is a fact that answers are exact about, so it lives in a source file
  /// compiled without contraction.
  [[nodiscard]] Vec3 apply(const Vec3& v) const;
};

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

}  // namespace soms
