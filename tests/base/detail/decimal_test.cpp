// The fallbacks for standard libraries without decimal digits, beside the standard's functions.
#include "soms/base/detail/decimal.h"

#include "soms/base/random.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {
namespace {

template <class Real>
void expect_same_text(Real value) {
  std::array<char, 40> expected;
  std::array<char, 40> found;
  const char* const end =
      std::to_chars(expected.data(), expected.data() + expected.size(), value).ptr;
  const char* const stop = write_shortest(found.data(), found.data() + found.size(), value);
  EXPECT_EQ(std::string_view(found.data(), static_cast<std::size_t>(stop - found.data())),
            std::string_view(expected.data(), static_cast<std::size_t>(end - expected.data())));
}

template <class Real>
void expect_same_number(std::string_view text) {
  Real expected = 7;
  Real found = 7;
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const auto [stop, error] = std::from_chars(begin, end, expected);
  const auto [found_stop, found_error] = read_decimal(begin, end, found);
  EXPECT_EQ(found_error, error) << text;
  EXPECT_EQ(found_stop - begin, stop - begin) << text;
  EXPECT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected))) << text;
  EXPECT_EQ(std::signbit(found), std::signbit(expected)) << text;
}

TEST(Decimal, WritesNumbersAsTheStandardDoes) {
  Rng random(57);
  for (int k = 0; k < 2000; ++k) {
    const std::uint64_t bits = random.next();
    expect_same_text(std::bit_cast<double>(bits));
    expect_same_text(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    expect_same_text(static_cast<double>(static_cast<std::int64_t>(bits)));
    expect_same_text(std::ldexp(static_cast<double>(bits % 1000000), -10));
  }
}

TEST(Decimal, WritesPowersAndEndsOfRanges) {
  for (int power = -1074; power < 1024; ++power) {
    expect_same_text(std::ldexp(1.0, power));
    expect_same_text(std::nextafter(std::ldexp(1.0, power), 0.0));
  }
  for (int power = -149; power < 128; ++power) {
    expect_same_text(std::ldexp(1.0F, power));
  }
  for (int power = -320; power < 309; ++power) {
    expect_same_text(std::strtod(("1e" + std::to_string(power)).c_str(), nullptr));
  }
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0, -0.0, Limits::max(), Limits::infinity(), -Limits::infinity(),
                             Limits::quiet_NaN(), 0.1, 123456789012345680000.0, 99999.0, 1e5}) {
    expect_same_text(value);
  }
}

TEST(Decimal, WritesAsManyDigitsAsWanted) {
  std::array<char, 40> text;
  char* const end = text.data() + text.size();
  EXPECT_EQ(std::string(text.data(), write_fixed(text.data(), end, 11.58, 1)), "11.6");
  EXPECT_EQ(std::string(text.data(), write_significant(text.data(), end, 25.4, 6)), "25.4");
  EXPECT_EQ(std::string(text.data(), write_significant(text.data(), end, 1e-7, 6)), "1e-07");
}

TEST(Decimal, ReadsWhatTheStandardReads) {
  for (const char* text : {"0",
                           "-0",
                           "1",
                           "+1",
                           " 1",
                           "1.",
                           ".5",
                           ".",
                           "-.5e1",
                           "1e",
                           "1e+",
                           "1e5",
                           "1E-5",
                           "1e5x",
                           "1.5.2",
                           "--1",
                           "inf",
                           "-INF",
                           "infinity",
                           "infinit",
                           "nan",
                           "-nan",
                           "0x10",
                           "",
                           "1e999",
                           "-1e999",
                           "1e-999",
                           "0e999",
                           "4.9e-324",
                           "2.4703282292062327e-324",
                           "2.4703282292062328e-324",
                           "2.2250738585072011e-308",
                           "1.7976931348623159e308",
                           "0.30000000000000004",
                           "9007199254740993",
                           "1.00000000000000011102230246251565404e0",
                           "3.4028235677973366e38",
                           "1.1754943508222875e-38",
                           "16777217",
                           "123456789,5"}) {
    expect_same_number<double>(text);
    expect_same_number<float>(text);
  }
  Rng random(58);
  for (int k = 0; k < 2000; ++k) {
    const std::string text = std::to_string(random.next()) + "." + std::to_string(random.next()) +
                             "e" + std::to_string(static_cast<int>(random.next() % 700) - 350);
    expect_same_number<double>(text);
    expect_same_number<float>(text);
  }
}

}  // namespace
}  // namespace soms::detail
