/// \file
/// Meshes, movements and curves as few bytes: whole multiples of a step, each as its difference
/// from what the numbers before let expect.
#pragma once

#include "soms/base/vector.h"

#include "apps/report/base64.h"
#include "apps/report/drawn_mesh.h"

#include <array>
#include <cstdint>
#include <span>

namespace soms::report {

/// Turnings (parts of unit quaternions) are multiples of 1 / kTurns.
inline constexpr double kTurns = 131072;

/// Seven bits a byte, the lowest first; all but the last byte have the highest bit set (LEB128).
void put_unsigned(Base64Writer& data, std::uint64_t value);

/// 0, -1, 1, -2, 2 as 0, 1, 2, 3, 4.
void put_signed(Base64Writer& data, std::int64_t value);

/// The power of two of which `size` has at most 2^bits, and more than half as many.
[[nodiscard]] double step_of(double size, int bits);

/// Corner by corner: 0 for a vertex that comes first, or how many vertices ago the corner's vertex
/// was first. A vertex that comes first is followed by its coordinates in steps, each less that
/// of the one before. Vertices that no triangle has are left out.
void put_mesh(Base64Writer& data, const DrawnMesh& mesh, double step);

/// Points, each less the one before; the first less the origin.
void put_points(Base64Writer& data, std::span<const Vec3> points, double step);

/// Lines from and to points around `place`: each start less the start before, each end less its
/// start.
void put_lines(Base64Writer& data, std::span<const std::array<Vec3, 2>> lines, const Vec3& place,
               double step);

/// A body's places and turnings, one after the other: each less what even motion leads to. A
/// turning is given the sign that is nearer to the one before.
class PackedPath {
 public:
  PackedPath(Base64Writer& data, double step) : data_(data), step_(step) {}

  /// `turn` is a unit quaternion.
  void put(const Vec3& place, std::array<double, 4> turn);

 private:
  Base64Writer& data_;
  double step_;
  bool begun_ = false;
  std::array<std::int64_t, 7> before_{};
  std::array<std::int64_t, 7> change_{};
};

}  // namespace soms::report
