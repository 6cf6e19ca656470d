#include "soms/base/text.h"

#include <gtest/gtest.h>

#include <string>

namespace soms {
namespace {

TEST(Text, EscapesMarkupAndQuotes) {
  EXPECT_EQ(xml_text("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
}

TEST(Text, KeepsCharactersOfEveryLength) {
  const std::string words = "a\xc3\xa9\xe2\x82\xac\xf0\x9f\x90\xb0";
  EXPECT_EQ(xml_text(words), words);
  EXPECT_EQ(utf8_character(words, 0), 1U);
  EXPECT_EQ(utf8_character(words, 1), 2U);
  EXPECT_EQ(utf8_character(words, 3), 3U);
  EXPECT_EQ(utf8_character(words, 6), 4U);
}

TEST(Text, ReplacesWhatIsNoCharacter) {
  EXPECT_EQ(xml_text("a\xff\xc3"), "a??");
  EXPECT_EQ(xml_text("\x01\t\x7f"), "???");
  EXPECT_EQ(utf8_character("\xe2\x82", 0), 0U);
  EXPECT_EQ(utf8_character("\x80", 0), 0U);
}

}  // namespace
}  // namespace soms
