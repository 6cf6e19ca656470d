#include "apps/report/script_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace soms::report {

namespace {

TEST(ScriptText, LetsNothingEndTheScript) {
  const std::string text = script_text("</script><!-- & <script>");
  EXPECT_EQ(text.find_first_of("<>&"), std::string::npos) << text;
  EXPECT_EQ(nlohmann::json::parse(text), "</script><!-- & <script>");
}

TEST(ScriptText, GivesBackWhatItWasGiven) {
  for (const std::string words :
       {"", "a\"b'c\\d", "line\nbreak\ttab", "\xc3\xa9\xe2\x82\xac", "\xe2\x80\xa8", "\x01\x1f"}) {
    EXPECT_EQ(nlohmann::json::parse(script_text(words)), words);
  }
}

TEST(ScriptText, ReplacesWhatIsNoUtf8) {
  const std::string text = script_text("a\xff\xfe z");
  EXPECT_EQ(nlohmann::json::parse(text), "a\xef\xbf\xbd\xef\xbf\xbd z");
}

TEST(ScriptText, IsAscii) {
  for (const char c : script_text("\xe2\x80\xa9 caf\xc3\xa9")) {
    EXPECT_GT(c, 0);
  }
}

TEST(Shortened, CutsBetweenCharacters) {
  EXPECT_EQ(shortened("short", 5), "short");
  EXPECT_EQ(shortened("longer", 4), "long...");
  EXPECT_EQ(shortened("ab\xc3\xa9z", 3), "ab...");
  EXPECT_EQ(shortened("ab\xc3\xa9z", 4), "ab\xc3\xa9...");
  EXPECT_EQ(shortened("\xff\xff\xff", 2), "\xff\xff...");
  EXPECT_EQ(shortened_front("short", 5), "short");
  EXPECT_EQ(shortened_front("longer", 4), "...nger");
  EXPECT_EQ(shortened_front("ab\xc3\xa9z", 2), "...z");
  EXPECT_EQ(shortened_front("ab\xc3\xa9z", 3), "...\xc3\xa9z");
}

}  // namespace

}  // namespace soms::report
