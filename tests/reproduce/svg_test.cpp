#include "apps/draw/svg.h"

#include "tests/reproduce/well_formed.h"

#include <gtest/gtest.h>

namespace soms::reproduce {
namespace {

TEST(Svg, IsWellFormedAndEscapesWords) {
  Svg svg(100, 50, "a < b & \"c\"");
  svg.text({1, 2}, "<script>alert('&')</script>", {.haloed = true});
  svg.rect({0, 0}, -3, 4, "fill=\"none\"");
  svg.line({0, 0}, {1, 1}, "stroke=\"#000\"");
  const std::string document = svg.document();
  EXPECT_EQ(test::markup_fault(document), "");
  EXPECT_EQ(test::count_of(document, "<script"), 0U);
  EXPECT_EQ(test::count_of(document, "<title>a &lt; b &amp; &quot;c&quot;</title>"), 1U);
  EXPECT_TRUE(test::values_of(document, "id").empty());
}

TEST(Svg, WritesCoordinatesWithoutExponentOrNegativeZero) {
  EXPECT_EQ(pixels(-0.001), "0");
  EXPECT_EQ(pixels(12.5), "12.5");
  EXPECT_EQ(pixels(1e-9), "0");
  EXPECT_EQ(pixels(123456.789), "123456.79");
}

TEST(Svg, WrapsAtSpacesAndKeepsEveryWord) {
  const std::string words = "spatial median stops where all midpoints lie on one side";
  std::string joined;
  for (const std::string& line : wrapped(words, 14, 120)) {
    EXPECT_LE(text_width(line, 14), 120);
    joined += (joined.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(joined, words);
  EXPECT_EQ(wrapped("unbreakable", 14, 5), std::vector<std::string>{"unbreakable"});
}

TEST(Svg, CountsWideCharactersOnce) {
  EXPECT_DOUBLE_EQ(text_width("\xc3\xa9", 10), text_width("\xe2\x82\xac", 10));
  EXPECT_GT(text_width("mm", 10), text_width("ii", 10));
}

}  // namespace
}  // namespace soms::reproduce
