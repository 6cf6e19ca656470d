#include "soms/io/rows.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace soms::test {
namespace {

using Rows = std::vector<std::vector<double>>;

const std::vector<std::vector<Column>> kHeaders{{{"a"}, {"b"}}, {{"a"}, {"b"}, {"c", true}}};

/// All rows of a file of this content.
Rows rows_of(const std::string& content) {
  const TemporaryFolder folder;
  write_content(folder.path() / "rows.csv", content);
  RowReader reader(folder.path() / "rows.csv", "things", kHeaders);
  Rows rows;
  while (const auto row = reader.next()) {
    rows.emplace_back(row->begin(), row->end());
  }
  return rows;
}

void expect_refused_rows(const std::string& content, ErrorKind kind, const std::string& words) {
  SCOPED_TRACE(content);
  expect_refused([&] { static_cast<void>(rows_of(content)); }, kind, "rows.csv");
  expect_refused([&] { static_cast<void>(rows_of(content)); }, kind, words);
}

TEST(RowReader, GivesNumbersInTheOrderOfItsHeader) {
  EXPECT_EQ(rows_of("a,b\n1,2\n\n# why\n 3 ,+4e0\r\n"), (Rows{{1, 2}, {3, 4}}));
  EXPECT_EQ(rows_of("b,a\n1,2\n"), (Rows{{2, 1}}));
  EXPECT_EQ(rows_of("c,b,a\n1,2,3\n"), (Rows{{3, 2, 1}}));
  EXPECT_TRUE(rows_of("a,b\n").empty());
}

TEST(RowReader, NamesTheColumnsOfTheFile) {
  const TemporaryFolder folder;
  write_content(folder.path() / "rows.csv", "c,a,b\n");
  const RowReader reader(folder.path() / "rows.csv", "things", kHeaders);
  EXPECT_EQ(reader.columns(), kHeaders[1]);
}

TEST(RowReader, TakesInfinityWhereAColumnMayBeInfinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(rows_of("a,b,c\n1,2,inf\n1,2,-inf\n"), (Rows{{1, 2, kInfinity}, {1, 2, -kInfinity}}));
  expect_refused_rows("a,b,c\n1,inf,2\n", ErrorKind::not_finite, "line 2: b is \"inf\"");
  expect_refused_rows("a,b,c\n1,2,nan\n", ErrorKind::not_finite, "line 2: c is \"nan\"");
  expect_refused_rows("a,b,c\n1,2,1e999\n", ErrorKind::not_finite, "line 2: c is \"1e999\"");
}

TEST(RowReader, NamesWhatIsWrong) {
  expect_refused_rows("", ErrorKind::bad_file, "no header and no things; begin with a,b or a,b,c");
  expect_refused_rows("a\n", ErrorKind::bad_file,
                      "line 1: the header \"a\" is not known; begin with a,b or a,b,c");
  expect_refused_rows("a,b,d\n", ErrorKind::bad_file, "remove the column \"d\", or begin with a,b");
  expect_refused_rows("a,b,b\n", ErrorKind::bad_file, "line 1: the header");
  expect_refused_rows("a,b\n1\n", ErrorKind::bad_file, "line 2: 1 number, but the header has 2");
  expect_refused_rows("a,b\n1,x\n", ErrorKind::bad_file, "line 2: b is \"x\", not a number");
}

TEST(RowReader, PutsFileAndLineBeforeAFault) {
  const TemporaryFolder folder;
  write_content(folder.path() / "rows.csv", "a,b\n1,2\n3,4\n");
  RowReader reader(folder.path() / "rows.csv", "things", kHeaders);
  static_cast<void>(reader.next());
  static_cast<void>(reader.next());
  const Error fault = reader.fault(Error(ErrorKind::usage, "a is odd", "give another"));
  EXPECT_EQ(fault.kind(), ErrorKind::usage);
  EXPECT_NE(fault.place().find("rows.csv, line 3: a is odd"), std::string::npos);
  EXPECT_EQ(fault.remedy(), "give another");
}

TEST(RowReader, TakesSemicolonsBetweenCells) {
  EXPECT_EQ(rows_of("a;b\n1;2.5\n 3 ; 4 \n"), (Rows{{1, 2.5}, {3, 4}}));
  EXPECT_EQ(rows_of("\xef\xbb\xbf"
                    "b;a\r\n1;2\r\n"),
            (Rows{{2, 1}}));
  expect_refused_rows("a;b\n1;2;3\n", ErrorKind::bad_file, "line 2: 3 numbers");
  expect_refused_rows("a;b\n1,2\n", ErrorKind::bad_file, "line 2: 1 number, but the header has 2");
  expect_refused_rows("a,b\n1;2\n", ErrorKind::bad_file, "line 2: 1 number, but the header has 2");
}

// Whether 1,234 is a little more than one or a thousand, no file says.
TEST(RowReader, NamesADecimalComma) {
  expect_refused_rows("a;b\n0,5;1\n", ErrorKind::bad_file,
                      "line 2: a is \"0,5\", not a number; write a decimal point in place of the "
                      "comma: 1.5");
  expect_refused_rows("a;b\n1;1,234\n", ErrorKind::bad_file, "b is \"1,234\"");
}

TEST(RowReader, NamesTextInUtf16) {
  const auto utf16 = [](bool big) {
    std::string text = big ? "\xfe\xff" : "\xff\xfe";
    for (const char c : std::string("a,b\n1,2\n")) {
      text += big ? std::string(1, '\0') + c : c + std::string(1, '\0');
    }
    return text;
  };
  for (const bool big : {false, true}) {
    expect_refused_rows(utf16(big), ErrorKind::unsupported,
                        "text in UTF-16; save it as ASCII or UTF-8");
  }
}

}  // namespace
}  // namespace soms::test
