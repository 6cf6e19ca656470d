#include "soms/base/error.h"
#include "soms/base/pose.h"
#include "soms/base/random.h"

#include "tests/support/host_arithmetic.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace soms {
namespace {

using std::numbers::pi;

/// What an error is to say.
struct Complaint {
  ErrorKind kind;
  std::string place;
  std::string remedy;
};

void expect_complaint(const std::function<void()>& call, const Complaint& complaint) {
  try {
    call();
    ADD_FAILURE() << "accepted: " << complaint.place;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), complaint.kind) << error.what();
    EXPECT_NE(error.place().find(complaint.place), std::string::npos) << error.place();
    EXPECT_NE(error.remedy().find(complaint.remedy), std::string::npos) << error.remedy();
  }
}

/// A rotation that is right to the last bits, and a shift of magnitude up to `far`.
Pose random_pose(Rng& rng, double far = 100) {
  Vec3 axis;
  do {
    axis = {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
  } while (dot(axis, axis) < 1e-6);
  return Pose::from_axis_angle(
      axis, rng.uniform(-7, 7),
      {rng.uniform(-far, far), rng.uniform(-far, far), rng.uniform(-far, far)});
}

/// A pose whose RtR - I has entries of up to 2 * `off`.
Pose bent(Pose pose, Rng& rng, double off) {
  Pose bend;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      bend.m[4 * i + j] += rng.uniform(-off, off);
    }
  }
  const Vec3 t = pose.shift();
  pose = pose * bend;
  pose.m[3] = t.x;
  pose.m[7] = t.y;
  pose.m[11] = t.z;
  return pose;
}

/// Greatest entry of RtR - I.
double off_a_rotation(const Pose& pose) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      long double sum = i == j ? -1 : 0;
      for (std::size_t row = 0; row < 12; row += 4) {
        sum += static_cast<long double>(pose.m[row + i]) * pose.m[row + j];
      }
      most = std::max(most, std::abs(static_cast<double>(sum)));
    }
  }
  return most;
}

void expect_near(const Pose& a, const Pose& b, double rotation, double shift) {
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_LE(std::abs(a.m[i] - b.m[i]), i % 4 == 3 ? shift : rotation) << i;
  }
}

double length_1(const Vec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

TEST(PoseProduct, MovesByTheSecondFactorFirst) {
  const Pose quarter = Pose::from_quaternion(0.5, 0.5, 0.5, 0.5);  // x to y, y to z, z to x
  const Pose right = Pose::translation(10, 0, 0);
  EXPECT_EQ((right * quarter).apply({1, 2, 3}), (Vec3{13, 1, 2}));
  EXPECT_EQ((quarter * right).apply({1, 2, 3}), (Vec3{3, 11, 2}));
  EXPECT_EQ(quarter * Pose{}, quarter);
  EXPECT_EQ(Pose{} * quarter, quarter);
}

// Ten digits and more: another order of the sums, or a fused multiply-add, would change these bits.
TEST(PoseProduct, IsTheWrittenFormulaWithOneRoundingAnOperation) {
  test::for_each_case("pose/product", 2000, [](Rng& rng) {
    const Pose a = random_pose(rng);
    const Pose b = random_pose(rng);
    const Pose product = a * b;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        // `volatile` keeps a compiler from fusing or reordering.
        volatile double sum = a.m[4 * i] * b.m[j];
        volatile double term = a.m[4 * i + 1] * b.m[4 + j];
        sum = sum + term;
        term = a.m[4 * i + 2] * b.m[8 + j];
        sum = sum + term;
        EXPECT_EQ(product.m[4 * i + j], sum);
      }
    }
    EXPECT_EQ(product.shift(), a.apply(b.shift()));
  });
}

TEST(PoseProduct, MovesAsItsFactorsDoButForRounding) {
  bool differed = false;
  test::for_each_case("pose/product-apply", 500, [&](Rng& rng) {
    const Pose a = random_pose(rng);
    const Pose b = random_pose(rng);
    const Vec3 v{rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9)};
    const Vec3 once = (a * b).apply(v);
    const Vec3 twice = a.apply(b.apply(v));
    EXPECT_LE(length_1(once - twice), 1e-12);
    differed = differed || !(once == twice);
  });
  EXPECT_TRUE(differed);  // the header says that they may
}

TEST(PoseProduct, StaysARotationForThousandsOfFactors) {
  test::for_each_case("pose/chain", 5, [](Rng& rng) {
    Pose chain;
    constexpr int kFactors = 20'000;
    for (int k = 0; k < kFactors; ++k) {
      chain = chain * random_pose(rng, 0);
    }
    EXPECT_LE(off_a_rotation(chain), kFactors * 4e-15);
    check(chain);
  });
}

TEST(PoseProduct, RoundsToNearestWhateverTheHostProgramChose) {
  Rng rng(7);
  const Pose a = random_pose(rng);
  const Pose b = random_pose(rng);
  const Pose drifted = bent(a, rng, 1e-4);
  const auto all = [&] { return std::array{a * b, a.inverse(), drifted.normalized()}; };
  const std::array<Pose, 3> plain = all();
  for (const test::HostMode& mode : test::host_modes()) {
    std::array<Pose, 3> hosted;
    {
      const test::HostArithmetic host(mode);
      hosted = all();
    }
    EXPECT_EQ(hosted, plain) << mode.name;
  }
}

TEST(PoseInverse, UndoesThePoseWithinItsBounds) {
  test::for_each_case("pose/inverse", 2000, [](Rng& rng) {
    // Rotations to the last bits, and poses as far off as `check` accepts.
    Pose pose = bent(random_pose(rng, 1e6), rng, rng.uniform(0, 1) < 0.5 ? 0 : 2e-7);
    check(pose);
    const double bound = 1e-14 * length_1(pose.shift());
    expect_near(pose * pose.inverse(), Pose{}, 4e-15, bound);
    expect_near(pose.inverse() * pose, Pose{}, 4e-15, bound);
  });
}

TEST(PoseInverse, IsExactForShiftsAndQuarterTurns) {
  EXPECT_EQ(Pose::translation(1, -2, 0.1).inverse(), Pose::translation(-1, 2, -0.1));
  const Pose turn = Pose::from_quaternion(0.5, 0.5, 0.5, 0.5, {1, 2, 3});
  EXPECT_EQ(turn * turn.inverse(), Pose{});
  EXPECT_EQ(turn.inverse().inverse(), turn);
  EXPECT_FALSE(std::signbit(Pose{}.inverse().m[3]));
}

TEST(PoseInverse, RefusesWhatIsNoPose) {
  Pose flat;
  flat.m[0] = 0;
  expect_complaint([&] { static_cast<void>(flat.inverse()); },
                   {ErrorKind::not_rigid, "entry 0,0 of RtR - I is 1", "give a rotation"});
}

TEST(PoseNormalized, IsARotationToTheLastBitsNearby) {
  test::for_each_case("pose/normalized", 2000, [](Rng& rng) {
    const Pose pose = random_pose(rng);
    const Pose drifted = bent(pose, rng, rng.uniform(0, 1) < 0.5 ? 1e-7 : 1.5e-4);
    const Pose normal = drifted.normalized();
    EXPECT_LE(off_a_rotation(normal), 4e-15);
    EXPECT_EQ(normal.shift(), drifted.shift());
    // No farther than the distance to the rotation that it was bent from, in the Frobenius norm.
    double to_nearest = 0;
    double to_first = 0;
    for (std::size_t i = 0; i < 12; ++i) {
      to_nearest += std::pow(normal.m[i] - drifted.m[i], 2);
      to_first += std::pow(pose.m[i] - drifted.m[i], 2);
    }
    EXPECT_LE(std::sqrt(to_nearest), std::sqrt(to_first) + 1e-15);
  });
}

TEST(PoseNormalized, KeepsWhatIsARotationAlready) {
  EXPECT_EQ(Pose::translation(1, 2, 3).normalized(), Pose::translation(1, 2, 3));
  const Pose turn = Pose::from_quaternion(0.5, 0.5, 0.5, 0.5, {1, 2, 3});
  EXPECT_EQ(turn.normalized(), turn);
}

TEST(PoseNormalized, MakesARotationOfThreeDigitsAndRefusesTwo) {
  Pose pose;
  pose.m = {0.707, -0.707, 0, 5, 0.707, 0.707, 0, 6, 0, 0, 1, 7};
  EXPECT_THROW(check(pose), Error);
  const Pose normal = pose.normalized();
  check(normal);
  EXPECT_NEAR(normal.m[0], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(normal.m[1], -std::sqrt(0.5), 1e-15);
  pose.m = {0.71, -0.71, 0, 5, 0.71, 0.71, 0, 6, 0, 0, 1, 7};
  expect_complaint([&] { static_cast<void>(pose.normalized()); },
                   {ErrorKind::not_rigid, "above 1e-3", "give a rotation"});
  pose.m = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  expect_complaint([&] { static_cast<void>(pose.normalized()); },
                   {ErrorKind::not_rigid, "mirrors", "mirror the mesh"});
}

TEST(PoseFromAxisAngle, TurnsCounterClockwiseAboutTheAxis) {
  const Pose about_x = Pose::from_axis_angle({1, 0, 0}, pi / 2, {0, 0, 5});
  const Vec3 moved = about_x.apply({0, 1, 0});
  EXPECT_LE(length_1(moved - Vec3{0, 0, 6}), 1e-15);
  EXPECT_EQ(Pose::from_axis_angle({0, 3, 0}, 0, {1, 2, 3}), Pose::translation(1, 2, 3));
  test::for_each_case("pose/axis-z", 200, [](Rng& rng) {
    const double angle = rng.uniform(-10, 10);
    expect_near(Pose::from_axis_angle({0, 0, 2}, angle), Pose::about_z(angle), 1e-15, 0);
    expect_near(Pose::from_axis_angle({0, 0, -2}, angle), Pose::about_z(-angle), 1e-15, 0);
  });
}

// The formula of Rodrigues is the twin.
TEST(PoseFromAxisAngle, AgreesWithTheFormulaOfRodrigues) {
  test::for_each_case("pose/rodrigues", 500, [](Rng& rng) {
    const Vec3 axis{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1)};
    const double angle = rng.uniform(-7, 7);
    const Vec3 u = axis * (1 / std::sqrt(dot(axis, axis)));
    const Vec3 v{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const Vec3 expected = v * std::cos(angle) + cross(u, v) * std::sin(angle) +
                          u * (dot(u, v) * (1 - std::cos(angle)));
    EXPECT_LE(length_1(Pose::from_axis_angle(axis, angle).apply(v) - expected), 1e-14);
  });
}

// Squares of these lengths overflow, or vanish; the steps are the same but for a power of two.
TEST(PoseFromAxisAngle, TakesAnAxisOfAnyLength) {
  const Pose pose = Pose::from_axis_angle({0.3, -0.5, 0.7}, 1.25);
  check(pose);
  EXPECT_LE(off_a_rotation(pose), 2e-15);
  for (const double scale : {0x1p-900, 0x1p-30, 0x1p30, 0x1p1000}) {
    EXPECT_EQ(Pose::from_axis_angle(Vec3{0.3, -0.5, 0.7} * scale, 1.25), pose);
  }
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(Pose::from_axis_angle({0, least, 0}, 1), Pose::from_axis_angle({0, 1, 0}, 1));
}

TEST(PoseFromAxisAngle, RefusesAnAxisThatIsNoDirection) {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  expect_complaint(
      [] {
        static_cast<void>(Pose::from_axis_angle({0, -0.0, 0}, 1));
      },
      {ErrorKind::usage, "the axis of rotation is 0 0 0", "such as 0 0 1"});
  for (const auto& [axis, angle] : {std::pair{Vec3{nan, 0, 1}, 1.0}, std::pair{Vec3{0, 0, 1}, nan},
                                    std::pair{Vec3{0, infinity, 1}, 1.0}}) {
    const Vec3 direction = axis;
    const double turn = angle;
    expect_complaint([&] { static_cast<void>(Pose::from_axis_angle(direction, turn)); },
                     {ErrorKind::not_finite, "the axis or the angle", "radians"});
  }
}

TEST(PoseMatrix, IsReadByRowsAndByColumns) {
  const std::array<double, 16> rows{0, 0, 1, 7, 1, 0, 0, 8, 0, 1, 0, 9, 0, 0, 0, 1};
  const std::array<double, 16> columns{0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 7, 8, 9, 1};
  const Pose pose = Pose::from_row_major(rows);
  EXPECT_EQ(pose.apply({1, 2, 3}), (Vec3{10, 9, 11}));
  EXPECT_EQ(Pose::from_column_major(columns), pose);
  EXPECT_EQ(pose.to_row_major(), rows);
  EXPECT_EQ(pose.to_column_major(), columns);
}

TEST(PoseMatrix, ComesBackBitForBit) {
  test::for_each_case("pose/matrix", 100, [](Rng& rng) {
    const Pose pose = bent(random_pose(rng), rng, 1e-7);
    EXPECT_EQ(Pose::from_row_major(pose.to_row_major()), pose);
    EXPECT_EQ(Pose::from_column_major(pose.to_column_major()), pose);
  });
}

TEST(PoseMatrix, NamesTheOtherOrderWhereTheShiftStandsInTheLastRow) {
  const Pose shift = Pose::translation(7, 8, 9);
  expect_complaint([&] { static_cast<void>(Pose::from_row_major(shift.to_column_major())); },
                   {ErrorKind::not_rigid, "is 7 8 9 1, its last column 0 0 0 1",
                    "call Pose::from_column_major"});
  expect_complaint([&] { static_cast<void>(Pose::from_column_major(shift.to_row_major())); },
                   {ErrorKind::not_rigid, "is 7 8 9 1", "call Pose::from_row_major"});
}

TEST(PoseMatrix, RefusesProjectionsAndNumbersThatAreNone) {
  std::array<double, 16> matrix = Pose::translation(1, 2, 3).to_row_major();
  matrix[15] = 2;
  expect_complaint([&] { static_cast<void>(Pose::from_row_major(matrix)); },
                   {ErrorKind::not_rigid, "is 0 0 0 2, not 0 0 0 1", "without projection"});
  matrix[15] = std::nan("");
  expect_complaint([&] { static_cast<void>(Pose::from_row_major(matrix)); },
                   {ErrorKind::not_finite, "not finite", "sixteen finite numbers"});
  matrix[15] = 1;
  matrix[3] = std::nan("");
  expect_complaint([&] { static_cast<void>(Pose::from_row_major(matrix)); },
                   {ErrorKind::not_finite, "entry tx", "finite"});
}

/// 45 degrees about z, written with three digits, and a shift.
std::array<double, 16> rough_rotation() {
  return {0.707, -0.707, 0, 5, 0.707, 0.707, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1};
}

TEST(PoseMatrix, IsMadeTheNearestRotationOnRequest) {
  const std::array<double, 16> rows = rough_rotation();
  expect_complaint([&] { static_cast<void>(Pose::from_row_major(rows)); },
                   {ErrorKind::not_rigid, "of RtR - I", "Rotation::nearest"});
  const Pose pose = Pose::from_row_major(rows, Rotation::nearest);
  check(pose);
  EXPECT_LE(off_a_rotation(pose), 4e-15);
  EXPECT_EQ(pose.shift(), (Vec3{5, 6, 7}));
  Pose given;
  std::copy_n(rows.begin(), 12, given.m.begin());
  EXPECT_EQ(pose, given.normalized());
  const std::array<double, 16> columns{0.707, 0.707, 0, 0, -0.707, 0.707, 0, 0,
                                       0,     0,     1, 0, 5,      6,     7, 1};
  EXPECT_EQ(Pose::from_column_major(columns, Rotation::nearest), pose);
}

TEST(PoseMatrix, IsMadeNoRotationWhereItIsFarFromOne) {
  std::array<double, 16> matrix = rough_rotation();
  const auto make = [&] { static_cast<void>(Pose::from_row_major(matrix, Rotation::nearest)); };
  matrix[0] = 0.71;
  expect_complaint(make, {ErrorKind::not_rigid, "above 1e-3", "give a rotation"});
  matrix = Pose{}.to_row_major();
  matrix[0] = -1;
  expect_complaint(make, {ErrorKind::not_rigid, "mirrors", "mirror the mesh"});
  matrix = rough_rotation();
  matrix[15] = 2;
  expect_complaint(make, {ErrorKind::not_rigid, "is 0 0 0 2, not 0 0 0 1", "without projection"});
}

TEST(PoseMatrix, SaysWhatToDoAboutScale) {
  std::array<double, 16> matrix = Pose::about_z(1).to_row_major();
  for (const std::size_t i : {0U, 1U, 2U, 4U, 5U, 6U, 8U, 9U, 10U}) {
    matrix[i] *= 0.001;
  }
  expect_complaint([&] { static_cast<void>(Pose::from_row_major(matrix)); },
                   {ErrorKind::not_rigid, "RtR - I", "the matrix scales by 0.001: divide"});
  // Unlike along the axes: no one number can be taken out.
  matrix = Pose{}.to_row_major();
  matrix[0] = 2;
  expect_complaint([&] { static_cast<void>(Pose::from_row_major(matrix)); },
                   {ErrorKind::not_rigid, "entry 0,0 of RtR - I is 3", "give a rotation"});
}

}  // namespace
}  // namespace soms
