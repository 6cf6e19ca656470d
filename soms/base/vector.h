/// \file
/// Points and directions in space, in double precision.
#pragma once

#include <array>
#include <cstddef>

namespace soms {

/// A point or direction: three doubles in the caller's unit.
struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;

  /// Component along axis 0 (x), 1 (y) or 2 (z).
  [[nodiscard]] constexpr double operator[](std::size_t axis) const {
    return axis == 0 ? x : axis == 1 ? y : z;
  }

  [[nodiscard]] constexpr double& operator[](std::size_t axis) {
    return axis == 0 ? x : axis == 1 ? y : z;
  }

  /// Equal as numbers: -0 equals +0, NaN equals nothing.
  [[nodiscard]] constexpr bool operator==(const Vec3&) const = default;

  constexpr Vec3& operator+=(const Vec3& v) {
    x += v.x;
    y += v.y;
    z += v.z;
    return *this;
  }
};

[[nodiscard]] constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

[[nodiscard]] constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

[[nodiscard]] constexpr Vec3 operator-(const Vec3& a) {
  return {-a.x, -a.y, -a.z};
}

[[nodiscard]] constexpr Vec3 operator*(const Vec3& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}

[[nodiscard]] constexpr Vec3 operator*(double s, const Vec3& a) {
  return a * s;
}

[[nodiscard]] constexpr double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[nodiscard]] constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A closed triangle by its corners; without area it is the segment or point it is.
struct Triangle {
  Vec3 a;
  Vec3 b;
  Vec3 c;
  [[nodiscard]] constexpr bool operator==(const Triangle&) const = default;
};

}  // namespace soms
