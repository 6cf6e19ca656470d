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

TEST(Text, TakesNoSurrogatesAndNoLongSpellings) {
  for (const std::string words : {"\xed\xa0\x80", "\xed\xbf\xbf", "\xe0\x80\x80", "\xe0\x9f\xbf",
                                  "\xf0\x80\x80\x80", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80"}) {
    EXPECT_EQ(utf8_character(words, 0), 0U);
    EXPECT_EQ(xml_text(words), std::string(words.size(), '?'));
  }
  for (const std::string words :
       {"\xed\x9f\xbf", "\xee\x80\x80", "\xe0\xa0\x80", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_EQ(xml_text(words), words);
  }
}

TEST(Text, KeepsFromXmlWhatXmlHasNoRoomFor) {
  const std::string words =
      "a\xef\xbf\xbe"
      "b\xef\xbf\xbf"
      "c\xef\xbf\xbd";
  EXPECT_EQ(utf8_character(words, 1), 3U);
  EXPECT_EQ(xml_text(words), "a?b?c\xef\xbf\xbd");
}

}  // namespace
}  // namespace soms
