#include "soms/io/detail/text.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace soms::detail {
namespace {

ParsedNumber parse(const std::string& text, Precision precision = Precision::as_double) {
  return parse_number(text.data(), text.data() + text.size(), precision);
}

TEST(ParseNumber, AgreesWithStrtodOnRandomNumbers) {
  test::for_each_case("io/parse-number", 5000, [](Rng& rng) {
    std::string text;
    const std::uint64_t digits = 1 + rng.below(25);
    for (std::uint64_t i = 0; i < digits; ++i) {
      text += static_cast<char>('0' + rng.below(10));
    }
    text.insert(rng.below(text.size() + 1), 1, '.');
    text += 'e';
    text += std::to_string(static_cast<int>(rng.below(760)) - 400);
    const double expected = std::strtod(text.c_str(), nullptr);
    const ParsedNumber found = parse(text);
    SCOPED_TRACE(text);
    if (std::isinf(expected)) {
      EXPECT_EQ(found.status, NumberStatus::too_large);
    } else {
      EXPECT_EQ(found.status, NumberStatus::good);
      EXPECT_EQ(found.value, expected);
    }
    const float narrow = std::strtof(text.c_str(), nullptr);
    const ParsedNumber single = parse(text, Precision::as_float);
    EXPECT_EQ(single.status, std::isinf(narrow) ? NumberStatus::too_large : NumberStatus::good);
    if (!std::isinf(narrow)) {
      EXPECT_EQ(single.value, static_cast<double>(narrow));
    }
  });
}

TEST(ParseNumber, TakesTooSmallForZeroAndTooLargeForAnError) {
  for (const std::string text :
       {"1e-400", "0.0000001e-320", "1e-999999999999999999999", "2e-324"}) {
    EXPECT_EQ(parse(text).status, NumberStatus::good) << text;
    EXPECT_EQ(parse(text).value, 0.0) << text;
    EXPECT_TRUE(std::signbit(parse(std::string("-").append(text)).value)) << text;
  }
  for (const std::string text :
       {"1e309", "-1e400", "0.001e999", "1e999999999999999999999", "123456789e301"}) {
    EXPECT_EQ(parse(text).status, NumberStatus::too_large) << text;
  }
  EXPECT_EQ(parse(std::string(400, '9')).status, NumberStatus::too_large);
  EXPECT_EQ(parse(std::string("0.").append(400, '0').append(1, '1')).value, 0.0);
}

TEST(ParseNumber, KnowsWhatIsNoNumber) {
  for (const std::string text : {"", "+", "-", ".", "e5", "+-1", "--1", "x"}) {
    EXPECT_EQ(parse(text).status, NumberStatus::not_a_number) << text;
  }
  EXPECT_EQ(parse("+1.5").value, 1.5);
  EXPECT_TRUE(std::isnan(parse("nan").value));
  EXPECT_TRUE(std::isinf(parse("inf").value));
}

TEST(CountLineEnds, CountsEveryKindOfLineEndOnce) {
  EXPECT_EQ(count_line_ends("a\nb\nc", 0, 4), 2U);
  EXPECT_EQ(count_line_ends("a\r\nb\r\nc", 0, 6), 2U);
  EXPECT_EQ(count_line_ends("a\r\nb\r\nc", 0, 5), 1U);
  EXPECT_EQ(count_line_ends("a\r\nb\r\nc", 2, 6), 2U);
  EXPECT_EQ(count_line_ends("a\rb\rc", 0, 4), 2U);
  EXPECT_EQ(count_line_ends("a\r", 0, 2), 1U);
  EXPECT_EQ(count_line_ends("", 0, 0), 0U);
}

TEST(Forget, GivesBackPagesThatWerePassedAndNoOthers) {
  constexpr std::size_t kSize = std::size_t{4} << 20;
  constexpr std::size_t kHeader = 10000;
  std::string bytes(kSize, 'x');
  for (std::size_t i = 99; i < kSize; i += 100) {
    bytes[i] = '\n';
  }
  const std::string whole = bytes;
  const Limits limits;
  Source source{.bytes = bytes, .name = "text", .limits = limits, .forgettable = true};
  source.kept = kHeader;
  source.forget(1000);  // too little to be worth a call
  EXPECT_EQ(bytes, whole);
  for (const std::size_t position : {kSize / 2 + 12345, kSize - 321}) {
    source.forget(position);
    EXPECT_EQ(source.forgotten_line_ends, position / 100);
    EXPECT_EQ(bytes.substr(0, kHeader), whole.substr(0, kHeader));
    EXPECT_EQ(bytes.substr(position), whole.substr(position));
    const auto lost = std::count(bytes.begin(), bytes.end(), '\0');
    EXPECT_GT(static_cast<std::size_t>(lost), position - kHeader - 20000);
  }
  test::expect_refused([&] { source.fail_line(kSize - 1, ErrorKind::bad_file, "bad", "mend"); },
                       ErrorKind::bad_file, "text, line 41944: bad");
}

TEST(InQuotes, ShowsNothingUnprintableAndNothingLong) {
  EXPECT_EQ(in_quotes("a b"), "\"a b\"");
  EXPECT_EQ(in_quotes(std::string("\0\x1b\xff", 3)), "\"???\"");
  EXPECT_EQ(in_quotes(std::string(100, 'a')).size(), 45U);
}

}  // namespace
}  // namespace soms::detail
