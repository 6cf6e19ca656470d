#include "apps/report/base64.h"

#include "tests/report/reading.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <sstream>
#include <vector>

namespace soms::report {

namespace {

template <typename... Values>
std::string encoded(const Values&... values) {
  std::ostringstream out;
  Base64Writer writer(out);
  (writer.put(values), ...);
  writer.finish();
  return out.str();
}

TEST(Base64, WritesLittleEndianNumbersWithPadding) {
  EXPECT_EQ(encoded(), "");
  EXPECT_EQ(encoded(std::uint32_t{0}), "AAAAAA==");
  EXPECT_EQ(encoded(1.0F), "AACAPw==");
  EXPECT_EQ(encoded(std::uint32_t{0x64636261}, std::uint32_t{0x68676665}), "YWJjZGVmZ2g=");
  EXPECT_EQ(
      encoded(std::uint32_t{0xffffffff}, std::uint32_t{0xffffffff}, std::uint32_t{0xffffffff}),
      "////////////////");
}

TEST(Base64, GivesBackALongBlock) {
  std::ostringstream out;
  Base64Writer writer(out);
  std::vector<float> numbers;
  for (int k = 0; k < 100'000; ++k) {
    numbers.push_back(static_cast<float>(std::sin(k) * 1e3));
    writer.put(numbers.back());
  }
  writer.finish();
  EXPECT_EQ(writer.bytes(), 400'000U);
  EXPECT_EQ(test::floats_of(out.str()), numbers);
}

}  // namespace

}  // namespace soms::report
