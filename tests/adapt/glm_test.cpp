#include "soms/adapt/glm.h"

#include "soms/base/error.h"

#include "tests/support/support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace soms::adapt {
namespace {

glm::dmat4 random_matrix(Rng& rng) {
  const glm::dvec3 axis(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1));
  const glm::dvec3 shift(rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9));
  return glm::rotate(glm::translate(glm::dmat4(1), shift), rng.uniform(-3, 3), axis);
}

TEST(Glm, MovesPointsAsThePoseDoes) {
  test::for_each_case("glm/matrix", 200, [](Rng& rng) {
    const glm::dmat4 matrix = random_matrix(rng);
    const Pose pose = to_pose(matrix);
    const glm::dvec3 v(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1));
    EXPECT_LE(glm::length(to_glm(pose.apply(to_vec3(v))) - glm::dvec3(matrix * glm::dvec4(v, 1))),
              1e-14);
    EXPECT_TRUE(to_dmat4(pose) == matrix);
  });
}

TEST(Glm, ComposesAndInvertsAsThePoseDoes) {
  const auto distance = [](const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0;
    for (int i = 0; i < 4; ++i) {
      most = std::max(most, glm::length(a[i] - b[i]));
    }
    return most;
  };
  test::for_each_case("glm/compose", 200, [&](Rng& rng) {
    const glm::dmat4 a = random_matrix(rng);
    const glm::dmat4 b = random_matrix(rng);
    EXPECT_LE(distance(to_dmat4(to_pose(a) * to_pose(b)), a * b), 1e-13);
    EXPECT_LE(distance(to_dmat4(to_pose(a).inverse()), glm::inverse(a)), 1e-13);
  });
}

TEST(Glm, TakesFloatsAsTheyAre) {
  const glm::mat4 matrix = glm::rotate(glm::mat4(1), 0.7F, glm::vec3(0, 0, 1));
  const Pose pose = to_pose(matrix);
  EXPECT_EQ(pose.m[0], static_cast<double>(matrix[0][0]));
  EXPECT_EQ(pose.m[4], static_cast<double>(matrix[0][1]));
  EXPECT_TRUE(to_mat4(pose) == matrix);
}

// As of the product of some dozens of rotations in floats.
TEST(Glm, CorrectsFloatsOnRequest) {
  const glm::mat4 drifted =
      glm::scale(glm::rotate(glm::mat4(1), 0.7F, glm::vec3(0, 0, 1)), glm::vec3(1.0000015F));
  EXPECT_THROW(static_cast<void>(to_pose(drifted)), Error);
  const Pose pose = to_pose(drifted, Rotation::nearest);
  check(pose);
  EXPECT_EQ(pose, to_pose(glm::dmat4(drifted), Rotation::nearest));
  EXPECT_NEAR(pose.m[0], static_cast<double>(drifted[0][0]), 2e-6);
}

TEST(Glm, RefusesScaleAndTheOtherOrder) {
  EXPECT_THROW(static_cast<void>(to_pose(glm::scale(glm::dmat4(1), glm::dvec3(2)))), Error);
  try {
    const glm::dmat4 shift = glm::translate(glm::dmat4(1), glm::dvec3(1, 2, 3));
    static_cast<void>(to_pose(glm::transpose(shift)));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(error.place().find("is 1 2 3 1"), std::string::npos) << error.what();
  }
}

TEST(Glm, StoresMatricesByColumns) {
  const glm::dmat4 shift = glm::translate(glm::dmat4(1), glm::dvec3(1, 2, 3));
  const Pose pose = Pose::from_column_major(std::span<const double, 16>(glm::value_ptr(shift), 16));
  EXPECT_EQ(pose, Pose::translation(1, 2, 3));
}

// glm::dquat is constructed w first and, unless reported otherwise, stored w last.
TEST(Glm, KeepsTheOrderOfQuaternions) {
  const glm::dquat quarter_about_x(std::sqrt(0.5), std::sqrt(0.5), 0, 0);
  const Pose pose = to_pose(quarter_about_x, {1, 0, 0});
  EXPECT_LE(glm::length(to_glm(pose.apply({0, 1, 0})) - glm::dvec3(1, 0, 1)), 1e-15);
  EXPECT_NEAR(to_dquat(pose).w, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(to_dquat(pose).x, std::sqrt(0.5), 1e-15);
}

TEST(Glm, TakesPointsOfDoublesAndOfFloats) {
  const std::vector<glm::dvec3> points{{1, 2, 3}, {0.1, 0, 0}};
  EXPECT_EQ(to_points(points), (std::vector<Vec3>{{1, 2, 3}, {0.1, 0, 0}}));
  const std::vector<glm::vec3> floats{{0.1F, 0, 0}};
  EXPECT_EQ(to_points(floats), (std::vector<Vec3>{{0.1F, 0, 0}}));
}

}  // namespace
}  // namespace soms::adapt
