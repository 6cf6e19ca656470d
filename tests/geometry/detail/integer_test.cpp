#include "soms/geometry/detail/exact/integer.h"

#include "soms/geometry/detail/exact/leading_part.h"
#include "soms/geometry/detail/parts/odd.h"

#include "tests/support/integer.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace soms::detail {
namespace {

__extension__ using Int128 = __int128;

Int128 value(const Integer& n) {
  const auto low = static_cast<Int128>(n.word(0));
  const auto high = static_cast<Int128>(n.word(1) & ~(std::uint64_t{1} << 63)) << 64;
  return n.sign() < 0 ? -(high + low) : high + low;
}

/// Any number of up to 62 bits; often short, and often 0.
std::int64_t any_integer(Rng& rng) {
  const auto bits = static_cast<std::int64_t>(rng.next() >> (2 + rng.below(62)));
  return rng.below(2) == 0 ? bits : -bits;
}

TEST(Integer, CalculatesAsTheProcessorDoes) {
  test::for_each_case("integer/int128", 20000, [](Rng& rng) {
    const std::int64_t x = any_integer(rng);
    const std::int64_t y = any_integer(rng);
    const Integer a(x);
    const Integer b(y);
    EXPECT_EQ(value(a + b), static_cast<Int128>(x) + y);
    EXPECT_EQ(value(a - b), static_cast<Int128>(x) - y);
    EXPECT_EQ(value(a * b), static_cast<Int128>(x) * y);
    EXPECT_EQ(value(-a), -static_cast<Int128>(x));
    EXPECT_EQ(a <=> b, x <=> y);
    EXPECT_EQ(a == b, x == y);
    EXPECT_EQ(a.sign(), x < 0 ? -1 : x > 0 ? 1 : 0);
    const auto magnitude = static_cast<std::uint64_t>(x < 0 ? -x : x);
    EXPECT_EQ(a.bit_length(), static_cast<std::size_t>(std::bit_width(magnitude)));
    const std::size_t shift = rng.below(65);
    EXPECT_EQ(value(a << shift), static_cast<Int128>(x) * (static_cast<Int128>(1) << shift));
    EXPECT_EQ(value(Integer(x, shift)), value(a << shift));
  });
}

/// The same number twice: here, and as the twin that tests count with.
struct Both {
  Integer number;
  test::Integer twin;

  static Both random(Rng& rng, std::size_t words) {
    Both result;
    for (std::size_t i = 0; i < words; ++i) {
      // Words of zeros and ones make carries run on.
      const std::uint64_t kind = rng.below(4);
      const std::uint64_t word = kind == 0   ? 0
                                 : kind == 1 ? std::numeric_limits<std::uint64_t>::max()
                                             : rng.next();
      for (const std::uint64_t half : {word >> 32, word & 0xffffffffU}) {
        const auto part = static_cast<std::int64_t>(half);
        result.number = (result.number << 32) + Integer(part);
        result.twin = result.twin * test::Integer(1, 32) + test::Integer(part, 0);
      }
    }
    if (rng.below(2) == 0) {
      result.number = -result.number;
      result.twin = -result.twin;
    }
    return result;
  }

  [[nodiscard]] bool agrees() const {
    test::Integer sum;
    for (std::size_t i = number.size(); i-- > 0;) {
      for (const std::uint64_t half : {number.word(i) >> 32, number.word(i) & 0xffffffffU}) {
        sum = sum * test::Integer(1, 32) + test::Integer(static_cast<std::int64_t>(half), 0);
      }
    }
    return ((number.sign() < 0 ? -sum : sum) - twin).sign() == 0 && number.sign() == twin.sign();
  }
};

TEST(Integer, AgreesWithItsTwinAtAllLengths) {
  test::for_each_case("integer/twin", 600, [](Rng& rng) {
    const Both a = Both::random(rng, rng.below(60));
    const Both b = Both::random(rng, rng.below(60));
    EXPECT_TRUE(a.agrees());
    EXPECT_TRUE((Both{a.number + b.number, a.twin + b.twin}.agrees()));
    EXPECT_TRUE((Both{a.number - b.number, a.twin - b.twin}.agrees()));
    EXPECT_TRUE((Both{a.number * b.number, a.twin * b.twin}.agrees()));
    const std::size_t shift = rng.below(300);
    EXPECT_TRUE((Both{a.number << shift, a.twin * test::Integer(1, shift)}.agrees()));
    EXPECT_EQ(a.number < b.number, a.twin < b.twin);
    EXPECT_EQ((a.number - b.number).sign(), (a.twin - b.twin).sign());
    EXPECT_EQ((a.number - a.number).sign(), 0);
    EXPECT_EQ(a.number + b.number - b.number, a.number);
  });
}

TEST(Integer, IsAValue) {
  Rng rng(5);
  for (const std::size_t words : {0U, 1U, 23U, 24U, 25U, 60U}) {
    for (const std::size_t others : {0U, 2U, 24U, 26U, 63U}) {
      const Both a = Both::random(rng, words);
      Both b = Both::random(rng, others);
      Integer copy = a.number;
      Integer assigned = b.number;
      assigned = copy;
      EXPECT_EQ(assigned, a.number);
      Integer moved = std::move(copy);
      EXPECT_EQ(moved, a.number);
      b.number = std::move(moved);
      EXPECT_EQ(b.number, a.number);
      // What was moved from can be used again.
      moved = a.number;
      EXPECT_EQ(moved, a.number);
      moved = moved * moved;
      EXPECT_TRUE((Both{moved, a.twin * a.twin}.agrees()));
    }
  }
}

TEST(Odd, IsTheDouble) {
  test::for_each_case("odd", 20000, [](Rng& rng) {
    const double x = std::bit_cast<double>(rng.next() & ~(std::uint64_t{1} << 62));
    const Odd odd(x);
    EXPECT_EQ(std::ldexp(static_cast<double>(odd.number), odd.exponent), x);
    EXPECT_NE(odd.number % 2, 0);
  });
  EXPECT_EQ(Odd(0.0).number, 0);
  EXPECT_EQ(Odd(-0.0).number, 0);
  EXPECT_EQ(Odd(-0x1p-1074).number, -1);
  EXPECT_EQ(Odd(-0x1p-1074).exponent, -1074);
}

TEST(LeadingPart, HasMoreThanAHundredBits) {
  test::for_each_case("leading-part", 2000, [](Rng& rng) {
    const Integer n = Both::random(rng, rng.below(8)).number;
    const LeadingPart part = leading_part(n);
    const Odd high(part.value.high);
    const Odd low(part.value.low);
    const auto whole = [&](const Odd& x) {
      const int shift = x.exponent + part.exponent + 200;
      return x.number == 0 ? Integer() : Integer(x.number, static_cast<std::size_t>(shift));
    };
    const Integer rest = (n << 200) - whole(high) - whole(low);
    if (n.sign() == 0) {
      EXPECT_EQ(rest.sign(), 0);
    } else {
      EXPECT_LT(rest.bit_length() + 102, (n << 200).bit_length() + 1);
    }
  });
}

}  // namespace
}  // namespace soms::detail
