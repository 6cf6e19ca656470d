#include "soms/base/pose.h"

#include "soms/base/error.h"
#include "soms/base/random.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

namespace soms {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNaN = std::nan("");

void expect_error(const std::function<void()>& call, ErrorKind kind, const std::string& words) {
  try {
    call();
    ADD_FAILURE() << "accepted: " << words;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Pose, DefaultMovesNothing) {
  EXPECT_EQ(Pose{}, Pose::identity());
  EXPECT_EQ(Pose{}.apply({0.1, -2e300, 5e-324}), (Vec3{0.1, -2e300, 5e-324}));
}

TEST(Pose, TranslationAdds) {
  const Pose pose = Pose::translation(1, 2, 3);
  EXPECT_EQ(pose.apply({10, 20, 30}), (Vec3{11, 22, 33}));
  EXPECT_EQ(pose.shift(), (Vec3{1, 2, 3}));
}

// Ten digits and more: the order of the sums and a fused multiply-add would change these bits.
TEST(Pose, AppliesWithOneRoundingAnOperationInOrder) {
  test::for_each_case("pose/order", 2000, [](Rng& rng) {
    Pose pose;
    for (double& entry : pose.m) {
      entry = rng.uniform(-1, 1);
    }
    const Vec3 v{rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9)};
    const Vec3 moved = pose.apply(v);
    for (std::size_t row = 0; row < 3; ++row) {
      // `volatile` keeps a compiler from fusing or reordering.
      volatile double sum = pose.m[4 * row] * v.x;
      volatile double term = pose.m[4 * row + 1] * v.y;
      sum = sum + term;
      term = pose.m[4 * row + 2] * v.z;
      sum = sum + term;
      sum = sum + pose.m[4 * row + 3];
      EXPECT_EQ(moved[row], sum);
    }
  });
}

TEST(Pose, SumsFromTheLeft) {
  Pose pose;
  pose.m = {1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1, -1e16};
  // ((1e16 + 1) + 1) + 1 loses every one; the shift comes last.
  EXPECT_EQ(pose.apply({1e16, 1, 1}), (Vec3{1e16, 1e16, 0}));
  // ((1 + 1) + 1e16) + 1 is a tie, rounded to even.
  EXPECT_EQ(pose.apply({1, 1, 1e16}), (Vec3{1e16 + 4, 1e16 + 2, 2}));
}

TEST(Pose, RoundsProductsBeforeSums) {
  // 1 - x*x with x = 1 + 2^-30: the product alone rounds to 1 + 2^-29, fused it would not.
  Pose pose;
  const double x = 1 + 0x1p-30;
  pose.m[0] = x;
  pose.m[3] = -(1 + 0x1p-29);
  EXPECT_EQ(pose.apply({x, 0, 0}).x, 0);
}

TEST(Pose, AboutZTurnsCounterClockwise) {
  const Vec3 moved = Pose::about_z(std::numbers::pi / 2, {0, 0, 5}).apply({1, 0, 0});
  EXPECT_NEAR(moved.x, 0, 1e-15);
  EXPECT_NEAR(moved.y, 1, 1e-15);
  EXPECT_EQ(moved.z, 5);
}

TEST(Pose, FromQuaternionTurnsByTheWrittenFormula) {
  EXPECT_EQ(Pose::from_quaternion(1, 0, 0, 0, {1, 2, 3}), Pose::translation(1, 2, 3));
  Pose half;
  half.m = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0};
  EXPECT_EQ(Pose::from_quaternion(0, 1, 0, 0), half);
  const Pose turn = Pose::from_quaternion(0.5, 0.5, 0.5, 0.5);
  EXPECT_EQ(turn.apply({1, 2, 3}), (Vec3{3, 1, 2}));
  const double w = 0.6;
  const double z = 0.8;
  const double s = 2 / (w * w + z * z);
  EXPECT_EQ(Pose::from_quaternion(w, 0, 0, z).m[0], 1 - s * (z * z));
  EXPECT_EQ(Pose::from_quaternion(w, 0, 0, z).m[4], s * (w * z));
}

TEST(Pose, FromQuaternionGivesARotationForEveryLengthItAccepts) {
  check(Pose::from_quaternion(0.707107, 0, 0, 0.707107));
  for (const double length : {1 - 4.9e-7, 1 + 4.9e-7}) {
    const double q = 0.5 * length;
    check(Pose::from_quaternion(q, q, q, q));
    check(Pose::from_quaternion(0, 0, length, 0));
  }
}

TEST(Pose, FromQuaternionRefusesOtherLengths) {
  EXPECT_NO_THROW(static_cast<void>(Pose::from_quaternion(1 + 4e-7, 0, 0, 0)));
  expect_error([] { static_cast<void>(Pose::from_quaternion(1 + 6e-7, 0, 0, 0)); },
               ErrorKind::not_rigid, "seven digits");
  expect_error([] { static_cast<void>(Pose::from_quaternion(0, 0, 0, 0)); }, ErrorKind::not_rigid,
               "quaternion");
  expect_error([] { static_cast<void>(Pose::from_quaternion(kNaN, 0, 0, 1)); },
               ErrorKind::not_finite, "quaternion");
  expect_error([] { static_cast<void>(Pose::from_quaternion(1, 0, kInfinity, 0)); },
               ErrorKind::not_finite, "quaternion");
}

TEST(Pose, CheckAcceptsWhatQuaternionsAndAnglesGive) {
  EXPECT_NO_THROW(check(Pose{}));
  test::for_each_case("pose/rigid", 200, [](Rng& rng) {
    EXPECT_NO_THROW(check(Pose::about_z(rng.uniform(-10, 10), {1e8, 0, 0})));
    const double w = rng.uniform(-1, 1);
    const double x = rng.uniform(-1, 1);
    const double y = rng.uniform(-1, 1);
    const double z = rng.uniform(-1, 1);
    const double n = std::sqrt(w * w + x * x + y * y + z * z);
    EXPECT_NO_THROW(check(Pose::from_quaternion(w / n, x / n, y / n, z / n)));
  });
}

TEST(Pose, CheckNamesTheEntryThatIsOff) {
  const auto with = [](std::size_t entry, double value) {
    Pose pose;
    pose.m[entry] = value;
    return pose;
  };
  EXPECT_NO_THROW(check(with(0, 1 + 4e-7)));
  expect_error([&] { check(with(0, 1 + 6e-7)); }, ErrorKind::not_rigid, "entry 0,0 of RtR - I");
  expect_error([&] { check(with(9, 2e-6)); }, ErrorKind::not_rigid,
               "entry 1,2 of RtR - I is 2e-06, above 1e-6");
  expect_error([&] { check(with(8, 0x1p-19)); }, ErrorKind::not_rigid, "is 1.9073486328125e-06,");
  expect_error([&] { check(with(5, -1)); }, ErrorKind::not_rigid, "mirrors");
  expect_error([&] { check(with(6, kNaN)); }, ErrorKind::not_finite, "entry r12");
  expect_error([&] { check(with(11, -kInfinity)); }, ErrorKind::not_finite, "entry tz");
  expect_error([&] { check(with(0, 1e200)); }, ErrorKind::not_rigid, "0,0");
}

TEST(Pose, CheckRangeBoundsEveryMovedVertex) {
  const double m = 0x1p300;
  EXPECT_NO_THROW(check_range({}, {{-m, -m, -m}, {m, m, m}}));
  EXPECT_NO_THROW(check_range(Pose::translation(1e305, 0, 0), {}));
  expect_error(
      [=] {
        check_range(Pose::translation(m / 2, 0, 0), {{0, 0, 0}, {m, 1, 1}});
      },
      ErrorKind::out_of_range, "along x");
  expect_error(
      [=] {
        check_range(Pose::about_z(0.5), {{0, -m, 0}, {m, 0, 1}});
      },
      ErrorKind::out_of_range, "along x");
  expect_error(
      [] {
        check_range(Pose::translation(0, 0, 1e300), {{0, 0, 0}, {1, 1, 1}});
      },
      ErrorKind::out_of_range, "along z");
}

// What passes the check stays within the limit after rounding, since rounding is monotone.
TEST(Pose, CheckRangeIsNeverExceeded) {
  test::for_each_case("pose/range", 2000, [](Rng& rng) {
    Pose pose = Pose::about_z(rng.uniform(-4, 4));
    const double reach = std::ldexp(rng.uniform(0.3, 1), 300);
    pose.m[3] = std::ldexp(rng.uniform(-1, 1), 300);
    const Box box{{-reach, -reach, -reach}, {reach, reach, reach}};
    try {
      check_range(pose, box);
    } catch (const Error&) {
      return;
    }
    for (const double x : {-reach, reach}) {
      for (const double y : {-reach, reach}) {
        const Vec3 moved = pose.apply({x, y, reach});
        EXPECT_LE(std::abs(moved.x), kMaxCoordinate);
        EXPECT_LE(std::abs(moved.y), kMaxCoordinate);
      }
    }
  });
}

}  // namespace
}  // namespace soms
