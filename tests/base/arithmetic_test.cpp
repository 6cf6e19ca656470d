#include "soms/base/arithmetic.h"

#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/base/pose.h"

#include "tests/support/host_arithmetic.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <stdexcept>

namespace soms {
namespace {

using test::HostArithmetic;

bool is_plain() {
  try {
    check_arithmetic();
    return true;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::unsupported);
    return false;
  }
}

TEST(Arithmetic, AcceptsThePlainKind) {
  EXPECT_NO_THROW(check_arithmetic());
}

TEST(Arithmetic, RefusesOtherKinds) {
  for (const test::HostMode& mode : test::host_modes()) {
    const HostArithmetic host(mode);
    EXPECT_EQ(is_plain(), mode.name == "traps") << mode.name;
  }
}

TEST(Arithmetic, IsPlainWhileRequestedAndTheHostsAgainAfterwards) {
  for (const test::HostMode& mode : test::host_modes()) {
    const HostArithmetic host(mode);
    const unsigned long found = test::arithmetic_settings();
    {
      const PlainArithmetic plain;
      EXPECT_TRUE(is_plain()) << mode.name;
      const PlainArithmetic again;
      EXPECT_TRUE(is_plain()) << mode.name;
    }
    EXPECT_EQ(test::arithmetic_settings(), found) << mode.name;
    EXPECT_THROW(
        {
          const PlainArithmetic plain;
          throw std::runtime_error("");
        },
        std::runtime_error);
    EXPECT_EQ(test::arithmetic_settings(), found) << mode.name;
  }
}

TEST(Arithmetic, TrapsNothingWhereTheHostTraps) {
  for (const test::HostMode& mode : test::host_modes()) {
    const HostArithmetic host(mode);
    const PlainArithmetic plain;
    volatile double most = std::numeric_limits<double>::max();
    volatile double zero = 0;
    EXPECT_EQ(most * most, std::numeric_limits<double>::infinity());
    EXPECT_NE(zero / zero, zero / zero);
  }
}

TEST(Arithmetic, IsPlainInEveryThread) {
  for (const test::HostMode& mode : test::host_modes()) {
    const HostArithmetic host(mode);
    std::atomic<int> others = 0;
    for_each_chunk(200, 1, Limits{.threads = 8},
                   [&](std::size_t, std::size_t) { others += is_plain() ? 0 : 1; });
    EXPECT_EQ(others, 0) << mode.name;
  }
}

TEST(Arithmetic, PosesAreTheSameUnderEverySetting) {
  const Pose plain = Pose::from_quaternion(0.8, 0.36, 0.48, 0, {1, 2, 3});
  const Pose turned = Pose::about_z(0.1);
  for (const test::HostMode& mode : test::host_modes()) {
    const HostArithmetic host(mode);
    EXPECT_EQ(Pose::from_quaternion(0.8, 0.36, 0.48, 0, {1, 2, 3}), plain) << mode.name;
    EXPECT_EQ(Pose::about_z(0.1), turned) << mode.name;
    EXPECT_NO_THROW(check(plain)) << mode.name;
  }
}

}  // namespace
}  // namespace soms
