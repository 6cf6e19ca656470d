#include "soms/adapt/eigen.h"

#include "soms/generate/shapes.h"
#include "soms/tree/shape.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>

namespace soms::adapt {
namespace {

Eigen::Isometry3d random_isometry(Rng& rng) {
  const Eigen::Vector3d axis(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1));
  return Eigen::Translation3d(rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9)) *
         Eigen::AngleAxisd(rng.uniform(-3, 3), axis.normalized());
}

TEST(Eigen, MovesPointsAsThePoseDoes) {
  test::for_each_case("eigen/isometry", 200, [](Rng& rng) {
    const Eigen::Isometry3d isometry = random_isometry(rng);
    const Pose pose = to_pose(isometry);
    const Eigen::Vector3d v(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1));
    EXPECT_LE((to_eigen(pose.apply(to_vec3(v))) - isometry * v).norm(), 1e-14);
    EXPECT_TRUE(to_isometry(pose).matrix() == isometry.matrix());
  });
}

TEST(Eigen, ComposesAndInvertsAsThePoseDoes) {
  test::for_each_case("eigen/compose", 200, [](Rng& rng) {
    const Eigen::Isometry3d a = random_isometry(rng);
    const Eigen::Isometry3d b = random_isometry(rng);
    EXPECT_LE((to_isometry(to_pose(a) * to_pose(b)).matrix() - (a * b).matrix()).norm(), 1e-13);
    EXPECT_LE((to_isometry(to_pose(a).inverse()).matrix() - a.inverse().matrix()).norm(), 1e-13);
  });
}

TEST(Eigen, TakesMatricesOfEitherStorageAndOfFloats) {
  const Pose pose = Pose::from_quaternion(0.5, 0.5, 0.5, 0.5, {7, 8, 9});
  const Eigen::Matrix4d columns = to_isometry(pose).matrix();
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = columns;
  EXPECT_NE(columns.data()[3], rows.data()[3]);
  EXPECT_EQ(to_pose(columns), pose);
  EXPECT_EQ(to_pose(rows), pose);
  EXPECT_EQ(to_pose(columns.cast<float>()), pose);
  EXPECT_EQ(to_pose(Eigen::Isometry3f(to_isometry(pose).cast<float>())), pose);
  EXPECT_EQ(to_pose(Eigen::Affine3d(columns)), pose);
  EXPECT_EQ(to_pose(Eigen::AffineCompact3d(to_isometry(pose))), pose);
}

// As of the product of some dozens of rotations in floats.
TEST(Eigen, CorrectsFloatsOnRequest) {
  Eigen::Isometry3f drifted(Eigen::Translation3f(7, 8, 9) *
                            Eigen::AngleAxisf(0.7F, Eigen::Vector3f::UnitZ()));
  drifted.linear() *= 1.0000015F;
  EXPECT_THROW(static_cast<void>(to_pose(drifted)), Error);
  const Pose pose = to_pose(drifted, Rotation::nearest);
  check(pose);
  EXPECT_EQ(pose, to_pose(drifted.matrix(), Rotation::nearest));
  EXPECT_EQ(pose.shift(), (Vec3{7, 8, 9}));
  EXPECT_LE((to_isometry(pose).matrix() - drifted.matrix().cast<double>()).norm(), 4e-6);
}

TEST(Eigen, RefusesScaleAsThePoseDoes) {
  Eigen::Affine3d scaled = Eigen::Affine3d::Identity();
  scaled.scale(2);
  try {
    static_cast<void>(to_pose(scaled));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_rigid);
    EXPECT_NE(error.remedy().find("scales by 2:"), std::string::npos) << error.what();
  }
}

// Eigen::Quaterniond is constructed w first and stored w last.
TEST(Eigen, KeepsTheOrderOfQuaternions) {
  const Eigen::Quaterniond quarter_about_x(std::sqrt(0.5), std::sqrt(0.5), 0, 0);
  const Pose pose = to_pose(quarter_about_x, {1, 0, 0});
  EXPECT_LE((to_eigen(pose.apply({0, 1, 0})) - Eigen::Vector3d(1, 0, 1)).norm(), 1e-15);
  EXPECT_NEAR(to_quaterniond(pose).w(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(to_quaterniond(pose).x(), std::sqrt(0.5), 1e-15);
}

TEST(Eigen, SeesVerticesAndTrianglesWithoutACopy) {
  Mesh mesh = generate_mover(MoverKind::car);
  const auto points = as_matrix(std::span<const Vec3>(mesh.vertices));
  ASSERT_EQ(points.rows(), static_cast<Eigen::Index>(mesh.vertices.size()));
  EXPECT_EQ(points.data(), &mesh.vertices[0].x);
  EXPECT_EQ(points(3, 2), mesh.vertices[3].z);
  const auto triangles = as_matrix(mesh.triangles);
  EXPECT_EQ(triangles(5, 1), mesh.triangles[5][1]);
  const double z = mesh.vertices[3].z;
  as_matrix(std::span(mesh.vertices)).rowwise() += Eigen::RowVector3d(0, 0, 8);
  EXPECT_EQ(mesh.vertices[3].z, z + 8);
  as_matrix(mesh.vertices).rowwise() += Eigen::RowVector3d(0, 0, 8);
  EXPECT_EQ(mesh.vertices[3].z, z + 8 + 8);
  const Mesh& unchanged = mesh;
  EXPECT_EQ(as_matrix(unchanged.vertices).data(), &mesh.vertices[0].x);
  EXPECT_EQ(as_matrix(std::span<const Vec3>()).rows(), 0);
}

TEST(Eigen, MakesAMeshOfTwoMatrices) {
  const Mesh car = generate_mover(MoverKind::car);
  const Eigen::MatrixXd points = as_matrix(std::span<const Vec3>(car.vertices));
  const Eigen::MatrixXi triangles = as_matrix(car.triangles).cast<int>();
  const Mesh mesh = to_mesh(points, triangles);
  EXPECT_EQ(mesh.vertices, car.vertices);
  EXPECT_EQ(mesh.triangles, car.triangles);
  check(mesh);
}

TEST(Eigen, RefusesMatricesOfAnotherForm) {
  const Eigen::MatrixXd points = Eigen::MatrixXd::Zero(3, 4);
  EXPECT_THROW(static_cast<void>(to_points(points)), Error);
  Eigen::MatrixXi triangles = Eigen::MatrixXi::Zero(2, 3);
  triangles(1, 2) = -1;
  try {
    static_cast<void>(to_mesh(Eigen::MatrixXd::Zero(1, 3), triangles));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.place(), "triangle 1: vertex -1");
  }
  EXPECT_THROW(static_cast<void>(to_mesh(Eigen::MatrixXd::Zero(1, 3), Eigen::MatrixXi::Zero(2, 4))),
               Error);
}

}  // namespace
}  // namespace soms::adapt
