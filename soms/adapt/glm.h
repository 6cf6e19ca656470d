/// \file
/// Poses and points to and from glm. Headers alone: the library does not need glm, and soms.h does
/// not include this file.
#pragma once

#include "soms/base/pose.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace soms::adapt {

[[nodiscard]] inline Vec3 to_vec3(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

[[nodiscard]] inline glm::dvec3 to_glm(const Vec3& v) {
  return {v.x, v.y, v.z};
}

/// The pose of a matrix that moves column vectors, as glm's do.
/// \errors As `Pose::from_column_major`.
[[nodiscard]] inline Pose to_pose(const glm::dmat4& matrix,
                                  Rotation rotation = Rotation::as_given) {
  std::array<double, 16> columns{};
  for (std::size_t i = 0; i < 16; ++i) {
    columns[i] = matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)];
  }
  return Pose::from_column_major(columns, rotation);
}

/// The same of floats, which become the equal doubles: a rotation in floats is off one by 1e-7 or
/// so, and the product of many needs Rotation::nearest.
[[nodiscard]] inline Pose to_pose(const glm::mat4& matrix, Rotation rotation = Rotation::as_given) {
  return to_pose(glm::dmat4(matrix), rotation);
}

/// Rotation, then shift. \errors As `Pose::from_quaternion`.
[[nodiscard]] inline Pose to_pose(const glm::dquat& rotation,
                                  const glm::dvec3& shift = glm::dvec3(0)) {
  return Pose::from_quaternion(rotation.w, rotation.x, rotation.y, rotation.z, to_vec3(shift));
}

/// The same numbers.
[[nodiscard]] inline glm::dmat4 to_dmat4(const Pose& pose) {
  const std::array<double, 16> columns = pose.to_column_major();
  glm::dmat4 matrix(1);
  for (std::size_t i = 0; i < 16; ++i) {
    matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = columns[i];
  }
  return matrix;
}

/// The numbers rounded to floats, for drawing.
[[nodiscard]] inline glm::mat4 to_mat4(const Pose& pose) {
  return glm::mat4(to_dmat4(pose));
}

/// The rotation of a pose; its last bits are those of glm's formula.
[[nodiscard]] inline glm::dquat to_dquat(const Pose& pose) {
  return glm::quat_cast(glm::dmat3(to_dmat4(pose)));
}

/// Points, such as the vertices of a mesh.
[[nodiscard]] inline std::vector<Vec3> to_points(std::span<const glm::dvec3> points) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const glm::dvec3& point : points) {
    result.push_back(to_vec3(point));
  }
  return result;
}

/// The same of floats, which become the equal doubles.
[[nodiscard]] inline std::vector<Vec3> to_points(std::span<const glm::vec3> points) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const glm::vec3& point : points) {
    result.push_back(to_vec3(glm::dvec3(point)));
  }
  return result;
}

}  // namespace soms::adapt
