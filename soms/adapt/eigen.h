/// \file
/// Poses, points and meshes to and from Eigen 3. Headers alone: the library does not need Eigen,
/// and soms.h does not include this file.
#pragma once

#include "soms/base/error.h"
#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::adapt {

/// n points, one a row: what soms stores, seen as a matrix without a copy.
using PointRows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// n triangles, one a row of three numbers of vertices; likewise.
using TriangleRows = Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;

[[nodiscard]] inline Vec3 to_vec3(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

[[nodiscard]] inline Eigen::Vector3d to_eigen(const Vec3& v) {
  return {v.x, v.y, v.z};
}

/// The pose of a 4x4 matrix that moves column vectors, however Eigen stores it; floats become the
/// equal doubles, and where they are too coarse, Rotation::nearest corrects them.
/// \errors As `Pose::from_row_major`.
template <class Derived>
[[nodiscard]] Pose to_pose(const Eigen::MatrixBase<Derived>& matrix,
                           Rotation rotation = Rotation::as_given) {
  EIGEN_STATIC_ASSERT_MATRIX_SPECIFIC_SIZE(Derived, 4, 4)
  std::array<double, 16> rows{};
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      rows[static_cast<std::size_t>(4 * i + j)] = static_cast<double>(matrix(i, j));
    }
  }
  return Pose::from_row_major(rows, rotation);
}

/// The pose of an Isometry3d, or of an Affine3d that neither scales nor shears; likewise of floats.
/// \errors As `Pose::from_row_major`.
template <class Scalar, int kMode, int kOptions>
[[nodiscard]] Pose to_pose(const Eigen::Transform<Scalar, 3, kMode, kOptions>& transform,
                           Rotation rotation = Rotation::as_given) {
  static_assert(kMode != Eigen::Projective, "a projection is no rigid motion");
  return to_pose(
      Eigen::Transform<Scalar, 3, Eigen::Affine, Eigen::ColMajor>(transform.affine()).matrix(),
      rotation);
}

/// Rotation, then shift. \errors As `Pose::from_quaternion`.
[[nodiscard]] inline Pose to_pose(const Eigen::Quaterniond& rotation,
                                  const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
  return Pose::from_quaternion(rotation.w(), rotation.x(), rotation.y(), rotation.z(),
                               to_vec3(shift));
}

/// The same numbers.
[[nodiscard]] inline Eigen::Isometry3d to_isometry(const Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.matrix() =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(pose.to_row_major().data());
  return result;
}

/// The rotation of a pose; its last bits are those of Eigen's formula.
[[nodiscard]] inline Eigen::Quaterniond to_quaterniond(const Pose& pose) {
  return Eigen::Quaterniond(to_isometry(pose).linear());
}

/// Vertices as a matrix of n rows: a view, valid as long as the vertices stay where they are.
[[nodiscard]] inline Eigen::Map<const PointRows> as_matrix(std::span<const Vec3> points) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return {points.empty() ? nullptr : &points[0].x, static_cast<Eigen::Index>(points.size()), 3};
}

/// The same, for writing: `as_matrix(vertices).rowwise() += Eigen::RowVector3d(0, 0, 1)`.
[[nodiscard]] inline Eigen::Map<PointRows> as_matrix(std::span<Vec3> points) {
  return {points.empty() ? nullptr : &points[0].x, static_cast<Eigen::Index>(points.size()), 3};
}

/// A vector would fit both.
[[nodiscard]] inline Eigen::Map<PointRows> as_matrix(std::vector<Vec3>& points) {
  return as_matrix(std::span(points));
}

/// Triangles as a matrix of n rows: a view.
[[nodiscard]] inline Eigen::Map<const TriangleRows> as_matrix(
    std::span<const std::array<std::uint32_t, 3>> triangles) {
  return {triangles.empty() ? nullptr : triangles[0].data(),
          static_cast<Eigen::Index>(triangles.size()), 3};
}

/// Points of a matrix with one a row, such as libigl's V.
/// \errors ErrorKind::usage unless it has three columns.
template <class Derived>
[[nodiscard]] std::vector<Vec3> to_points(const Eigen::MatrixBase<Derived>& rows) {
  if (rows.cols() != 3) {
    throw Error(ErrorKind::usage,
                "a matrix of points has " + std::to_string(rows.cols()) + " columns",
                "give one point per row, in three columns; transpose() a matrix of three rows");
  }
  std::vector<Vec3> points(static_cast<std::size_t>(rows.rows()));
  as_matrix(std::span(points)) = rows.template cast<double>();
  return points;
}

/// A mesh of a matrix of points and one of triangles, such as libigl's V and F.
/// \errors ErrorKind::usage unless both have three columns; out_of_range for an index that is
///         negative or above 2^32 - 1. All else is checked when a Shape is made of it.
template <class Points, class Triangles>
[[nodiscard]] Mesh to_mesh(const Eigen::MatrixBase<Points>& points,
                           const Eigen::MatrixBase<Triangles>& triangles) {
  if (triangles.cols() != 3) {
    throw Error(ErrorKind::usage,
                "a matrix of triangles has " + std::to_string(triangles.cols()) + " columns",
                "give one triangle per row, in three columns");
  }
  Mesh mesh;
  mesh.vertices = to_points(points);
  mesh.triangles.resize(static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index i = 0; i < triangles.rows(); ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto index = triangles(i, k);
      if (!std::in_range<std::uint32_t>(index)) {
        throw Error(ErrorKind::out_of_range,
                    "triangle " + std::to_string(i) + ": vertex " + std::to_string(index),
                    "give vertex numbers of 0 or more");
      }
      mesh.triangles[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
          static_cast<std::uint32_t>(index);
    }
  }
  return mesh;
}

}  // namespace soms::adapt
