#include "soms/base/text.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace soms {
namespace {

TEST(Text, EscapesMarkupAndQuotes) {
  EXPECT_EQ(xml_text("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
}

TEST(Text, WritesSizesInTheirUnit) {
  EXPECT_EQ(readable_bytes(0), "0 bytes");
  EXPECT_EQ(readable_bytes(1), "1 byte");
  EXPECT_EQ(readable_bytes(1023), "1023 bytes");
  EXPECT_EQ(readable_bytes(1024), "1.0 KiB");
  EXPECT_EQ(readable_bytes(12141912), "11.6 MiB");
  EXPECT_EQ(readable_bytes((1U << 20) - 1), "1.0 MiB") << "never 1024.0 KiB";
  EXPECT_EQ(readable_bytes(~std::uint64_t{0}), "16.0 EiB");
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

TEST(Printable, LeavesATerminalNothingToObey) {
  EXPECT_EQ(printable("a\x1b[1m\nb\x7f\t\r"), "a?[1m?b???");
  EXPECT_EQ(printable("\xc2\x9b"
                      "1m"),
            "?1m")
      << "U+009B begins a command, as ESC [ does";
  EXPECT_EQ(printable("\x9b"
                      "1m"),
            "?1m")
      << "the same as one byte, for a terminal of one byte a character";
  EXPECT_EQ(printable("a\xff\xc3"), "a??");
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b\xe2\x80\xa8"),
            "a?b?")
      << "turned around, and a line break";
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a?b");
}

TEST(Printable, KeepsCharactersOfEveryLanguage) {
  const std::string words =
      "Stra\xc3\x9f"
      "e \xe6\xa0\xbc \xf0\x9f\x90\xb0 \xc2\xa0";
  EXPECT_EQ(printable(words), words);
}

TEST(CsvField, IsQuotedOnlyWhereItMustBe) {
  EXPECT_EQ(csv_field(""), "");
  EXPECT_EQ(csv_field("house 3"), "house 3");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("12\" pipe"), "\"12\"\" pipe\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_field("a-b=c@d+e"), "a-b=c@d+e");
}

TEST(CsvField, BeginsNoFormula) {
  EXPECT_EQ(csv_field("=1+1"), "'=1+1");
  EXPECT_EQ(csv_field("+1"), "'+1");
  EXPECT_EQ(csv_field("-1"), "'-1");
  EXPECT_EQ(csv_field("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_field("\t=1"), "\"'\t'=1\"");
  EXPECT_EQ(csv_field("\r=1"), "\"'\r'=1\"");
  EXPECT_EQ(csv_field("x;=1"), "\"x;'=1\"") << "for a spreadsheet that separates by semicolons";
  EXPECT_EQ(csv_field("'tis"), "''tis");
}

TEST(CsvField, IsUtf8WithoutControlCharacters) {
  EXPECT_EQ(csv_field("a\xff"
                      "b\x1b[1m"),
            "a\xef\xbf\xbd"
            "b\xef\xbf\xbd[1m");
  EXPECT_EQ(csv_field(std::string_view("\0=1", 3)), "\xef\xbf\xbd=1");
}

/// A field as a CSV reader returns it.
std::string read_field(std::string_view field) {
  if (field.empty() || field.front() != '"') {
    return std::string(field);
  }
  std::string text;
  for (std::size_t k = 1; k + 1 < field.size(); ++k) {
    text += field[k];
    k += field[k] == '"' ? 1U : 0U;
  }
  return text;
}

TEST(CsvWords, UndoesWhatCsvFieldDid) {
  test::for_each_case("csv-words", 5000, [](Rng& rng) {
    constexpr std::string_view kLetters = "=+-@';,\t\r\n\"ab ";
    std::string words;
    for (auto n = rng.below(7); n > 0; --n) {
      words += kLetters[static_cast<std::size_t>(rng.below(kLetters.size()))];
    }
    const std::string field = csv_field(words);
    EXPECT_EQ(csv_words(read_field(field)), words) << field;
    const std::string read = read_field(field);
    EXPECT_TRUE(read.empty() ||
                std::string_view("=+-@\t\r\n").find(read.front()) == std::string_view::npos)
        << field;
  });
}

}  // namespace
}  // namespace soms
