/// \file
/// Building blocks of the referee's own bodies: kept apart from soms/generate, so that a change
/// there moves no figure here.
#pragma once

#include "soms/base/random.h"
#include "soms/geometry/mesh.h"

#include "bench/peers/libraries/library.h"

#include <cmath>

namespace soms::bench {

inline constexpr double kPi = 3.14159265358979323846;

[[nodiscard]] std::array<float, 3> narrow(const Vec3& v);
[[nodiscard]] Vec3 wide(const std::array<float, 3>& v);
[[nodiscard]] Mesh widened(const FloatMesh& mesh);
[[nodiscard]] Vec3 unit(const Vec3& v);

/// Uniform on the unit sphere.
[[nodiscard]] Vec3 random_direction(Rng& rng);

/// A uniform random rotation (Shoemake), shifted by `t`.
[[nodiscard]] Pose random_rotation(Rng& rng, const Vec3& t);

void append(FloatMesh& mesh, const FloatMesh& other);

/// 12 triangles.
[[nodiscard]] FloatMesh box(const Vec3& center, const Vec3& half, double yaw = 0);

/// `power` below 1 makes it boxy; 2 * around * rings triangles.
[[nodiscard]] FloatMesh ellipsoid(const Vec3& center, const Vec3& half, std::uint32_t around,
                                  std::uint32_t rings, double power = 1);

/// 4 * around triangles.
[[nodiscard]] FloatMesh cylinder(const Vec3& center, const Vec3& axis, double radius, double half,
                                 std::uint32_t around);

/// 2 * along * around triangles, reach 1.
[[nodiscard]] FloatMesh torus_knot(std::uint32_t along, std::uint32_t around);

/// `torus_knot` in the referee's sizes: 1,000, 10,000, 100,000 and a million triangles.
/// \errors ErrorKind::usage for others.
[[nodiscard]] FloatMesh referee_knot(std::uint64_t triangles);

/// 4 km of hills, streets and boxes: 5,672, 100,000, a million or 5 million triangles.
/// \errors ErrorKind::usage for others.
[[nodiscard]] FloatMesh referee_city(std::uint64_t triangles);

/// 1,000 triangles: 4.5 x 1.95 x 1.45 m, nose to +x, wheels down to z = 0.
[[nodiscard]] FloatMesh referee_car();

/// 308 triangles, 1 m across, about the origin.
[[nodiscard]] FloatMesh referee_drone();

}  // namespace soms::bench
