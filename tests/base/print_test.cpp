#include "soms/base/print.h"

#include "soms/base/box.h"
#include "soms/base/error.h"
#include "soms/base/pose.h"
#include "soms/base/print_fields.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace soms {
namespace {

TEST(Print, ShowsVectorsBoxesAndPosesOnOneLine) {
  EXPECT_EQ(printed(Vec3{1, -2, 0.1}), "Vec3{1, -2, 0.1}");
  EXPECT_EQ(printed(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}),
            "Triangle{(0, 0, 0), (1, 0, 0), (0, 0.5, 0)}");
  EXPECT_EQ(printed(Box{{0, 0, 0}, {1, 2, 3}}), "Box{(0, 0, 0) to (1, 2, 3)}");
  EXPECT_EQ(printed(Box{}), "Box{empty}");
  EXPECT_EQ(printed(Pose::translation(10, 0, 0.2)), "Pose{1 0 0 10, 0 1 0 0, 0 0 1 0.2}");
}

TEST(Print, ShowsErrorsWithTheirKind) {
  EXPECT_EQ(printed(Rotation::nearest), "nearest");
  EXPECT_EQ(printed(ErrorKind::not_rigid), "not_rigid");
  EXPECT_EQ(printed(Error(ErrorKind::usage, "a\tb", "c")), R"(Error{usage, "a\x09b; c"})");
}

TEST(Print, ShowsTheFewestDigitsThatReadBackExactly) {
  EXPECT_EQ(printed(0.1), "0.1");
  EXPECT_EQ(printed(0.30000000000000004), "0.30000000000000004");
  EXPECT_EQ(printed(1e300), "1e+300");
  EXPECT_EQ(printed(-0.0), "-0");
  EXPECT_EQ(printed(std::nan("")), "nan");
  EXPECT_EQ(printed(-std::numeric_limits<double>::infinity()), "-inf");
  test::for_each_case("print/digits", 500, [](Rng& rng) {
    const double value = std::ldexp(rng.uniform(-1, 1), static_cast<int>(rng.below(2000)) - 1000);
    EXPECT_EQ(std::stod(printed(value)), value);
  });
}

/// Thousands in groups, and a comma for the point.
class Grouping : public std::numpunct<char> {
 protected:
  [[nodiscard]] char do_decimal_point() const override { return ','; }

  [[nodiscard]] char do_thousands_sep() const override { return '.'; }

  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

TEST(Print, TakesNothingButTheWidthFromTheStream) {
  const Pose pose = Pose::translation(1234567, 0.1, 255);
  std::ostringstream out;
  out.imbue(std::locale(std::locale::classic(), new Grouping));  // owned by the locale
  out << std::hex << std::showpos << std::scientific << std::setprecision(2) << pose;
  EXPECT_EQ(out.str(), "Pose{1 0 0 1234567, 0 1 0 0.1, 0 0 1 255}");
  out.str("");
  out << std::setw(20) << std::left << std::setfill('.') << Vec3{1, 2, 3} << "|";
  EXPECT_EQ(out.str(), "Vec3{1, 2, 3}.......|");
}

TEST(Print, QuotesWordsFitForATerminal) {
  EXPECT_EQ(quoted_text("pump \"A\" \\ 2"), R"("pump \"A\" \\ 2")");
  EXPECT_EQ(quoted_text("r\xc3\xb6hre"), "\"r\xc3\xb6hre\"");
  EXPECT_EQ(quoted_text("a\nb\x1b[31m\x7f"), R"("a\x0ab\x1b[31m\x7f")");
  EXPECT_EQ(quoted_text("\xff\xc2\x9b\xc2"), R"("\xff\xc2\x9b\xc2")");
  EXPECT_EQ(quoted_text(std::string("\0", 1)), R"("\x00")");
}

TEST(Print, NamesEnumeratorsAndNumbersWhatIsNone) {
  EXPECT_EQ(printed(Rotation::as_given), "as_given");
  EXPECT_EQ(printed(static_cast<Rotation>(2)), "Rotation(2)");
  EXPECT_EQ(printed(static_cast<Rotation>(-1)), "Rotation(-1)");
  EXPECT_EQ(name(ErrorKind::not_rigid), "not_rigid");
  EXPECT_EQ(name(static_cast<ErrorKind>(99)), "");
}

TEST(Error, IsEqualByKindPlaceAndRemedy) {
  const Error error(ErrorKind::usage, "place", "remedy");
  EXPECT_EQ(error, Error(ErrorKind::usage, "place", "remedy"));
  EXPECT_FALSE(error == Error(ErrorKind::bad_file, "place", "remedy"));
  EXPECT_FALSE(error == Error(ErrorKind::usage, "place; remedy", ""));  // what() is the same
  EXPECT_FALSE(error == Error(ErrorKind::usage, "place", "another"));
}

}  // namespace
}  // namespace soms
