#include "soms/geometry/detail/exact/double_double.h"

#include "soms/geometry/detail/exact/integer.h"
#include "soms/geometry/detail/parts/odd.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace soms::detail {
namespace {

/// All numbers here are whole multiples of 2^-kShift.
constexpr int kShift = 700;

Integer whole(double x) {
  const Odd odd(x);
  return odd.number == 0 ? Integer()
                         : Integer(odd.number, static_cast<std::size_t>(odd.exponent + kShift));
}

Integer whole(const DoubleDouble& x) {
  return whole(x.high) + whole(x.low);
}

/// A double of any bits, about 2^-20 to 2^20, of which many are short.
double any(Rng& rng) {
  const double x = std::ldexp(rng.uniform(-1, 1), static_cast<int>(rng.below(40)) - 20);
  return rng.below(3) == 0 ? std::nearbyint(x) : x;
}

DoubleDouble any_pair(Rng& rng) {
  const double high = any(rng);
  return quick_two_sum(high, high * std::ldexp(rng.uniform(-1, 1), -54));
}

/// |error| as a share of |value|, by lengths in bits: below 2^-bits.
void expect_near(const Integer& error, const Integer& value, std::size_t bits) {
  if (error.sign() != 0) {
    EXPECT_LE(error.bit_length() + bits, value.bit_length());
  }
}

TEST(DoubleDouble, SumsAndProductsOfDoublesAreExact) {
  test::for_each_case("double-double/exact", 20000, [](Rng& rng) {
    const double a = any(rng);
    const double b = any(rng);
    EXPECT_EQ(whole(two_sum(a, b)), whole(a) + whole(b));
    EXPECT_EQ(two_sum(a, b).high, a + b);
    EXPECT_EQ(whole(two_product(a, b)) << kShift, whole(a) * whole(b));
    EXPECT_EQ(two_product(a, b).high, a * b);
    const double large = std::max(std::abs(a), std::abs(b));
    const double small = std::min(std::abs(a), std::abs(b));
    EXPECT_EQ(whole(quick_two_sum(large, -small)), whole(large) - whole(small));
  });
}

// By one bit less than the bound, since lengths in bits are coarse.
TEST(DoubleDouble, OperationsAreWithinTheirBound) {
  test::for_each_case("double-double/bounds", 20000, [](Rng& rng) {
    const DoubleDouble a = any_pair(rng);
    const DoubleDouble b = rng.below(4) == 0 ? -(a * DoubleDouble(1 + 0x1p-40)) : any_pair(rng);
    const Integer x = whole(a);
    const Integer y = whole(b);
    expect_near(whole(a + b) - (x + y), x + y, 101);
    expect_near(whole(a - b) - (x - y), x - y, 101);
    expect_near((whole(a * b) << kShift) - x * y, x * y, 101);
    if (y.sign() != 0) {
      expect_near(whole(a / b) * y - (x << kShift), x << kShift, 101);
    }
    if (x.sign() > 0) {
      // (r + e)^2 is off by 2 e r.
      const Integer root = whole(sqrt(a));
      expect_near(root * root - (x << kShift), x << kShift, 100);
    }
    EXPECT_EQ(a < b, x < y);
    EXPECT_EQ(a > b, x > y);
  });
  EXPECT_EQ(sqrt(DoubleDouble(0)), DoubleDouble(0));
  EXPECT_EQ(sqrt(DoubleDouble(-1)), DoubleDouble(0));
}

}  // namespace
}  // namespace soms::detail
