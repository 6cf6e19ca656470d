#include "apps/draw/stroke_font.h"

#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace soms::look {
namespace {

constexpr std::string_view kLetters =
    "0123456789.-+ ecmkinftabdghjlopqrsuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ,:;!?=/_'\"()[]#%";

using StrokeShape = std::multiset<std::pair<std::pair<double, double>, std::pair<double, double>>>;

StrokeShape shape_of(std::string_view text) {
  StrokeShape shape;
  for (const TextStroke& s : strokes_of(text, 10)) {
    shape.insert({{s.from.x, s.from.y}, {s.to.x, s.to.y}});
  }
  return shape;
}

TEST(StrokeFont, LettersDifferAndOthersAreBoxes) {
  std::set<StrokeShape> shapes;
  for (const char c : kLetters) {
    shapes.insert(shape_of({&c, 1}));
  }
  EXPECT_EQ(shapes.size(), kLetters.size());
  EXPECT_EQ(shapes.count(shape_of("\x7f")), 0U) << "a box is no letter";
  EXPECT_EQ(shape_of("\x7f"), shape_of("\xff"));
  EXPECT_EQ(strokes_of("\x7f", 10).size(), 4U);
}

TEST(StrokeFont, StrokesStayWithinTheirLine) {
  for (const char c : kLetters) {
    const double width = width_of({&c, 1}, 20);
    for (const TextStroke& s : strokes_of({&c, 1}, 20)) {
      for (const TextPoint& p : {s.from, s.to}) {
        EXPECT_TRUE(p.x >= -0.7 && p.x <= width + 0.7) << c << ' ' << p.x;
        EXPECT_TRUE(p.y >= -6 && p.y <= 23) << c << ' ' << p.y;
      }
    }
  }
}

TEST(StrokeFont, DigitsAreOneWidthAndAsHighAsRequested) {
  for (const char c : std::string_view("0123456789")) {
    EXPECT_EQ(width_of({&c, 1}, 13), width_of("0", 13));
    double least = 13;
    double greatest = 0;
    for (const TextStroke& s : strokes_of({&c, 1}, 13)) {
      least = std::min({least, s.from.y, s.to.y});
      greatest = std::max({greatest, s.from.y, s.to.y});
    }
    EXPECT_NEAR(least, 0, 0.2) << c;
    EXPECT_NEAR(greatest, 13, 0.2) << c;
  }
  EXPECT_EQ(width_of("", 13), 0);
  EXPECT_TRUE(strokes_of("", 13).empty());
  EXPECT_DOUBLE_EQ(width_of("1.25", 26), 2 * width_of("1.25", 13));
}

TEST(StrokeFont, ALetterStandsBehindThoseBeforeIt) {
  const auto both = strokes_of("17", 10);
  const auto one = strokes_of("1", 10);
  const auto seven = strokes_of("7", 10);
  ASSERT_EQ(both.size(), one.size() + seven.size());
  const double shift = width_of("17", 10) - width_of("7", 10);
  for (std::size_t k = 0; k < seven.size(); ++k) {
    EXPECT_DOUBLE_EQ(both[one.size() + k].from.x, seven[k].from.x + shift);
    EXPECT_DOUBLE_EQ(both[one.size() + k].to.y, seven[k].to.y);
  }
}

}  // namespace
}  // namespace soms::look
