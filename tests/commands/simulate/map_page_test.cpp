// What every map has: its coordinates, the north, and words for those who do not see it.
#include "apps/world/map_page.h"

#include "apps/soms/simulate/map_marks.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace soms::command {
namespace {

std::vector<std::string> texts_of(const std::vector<GridLine>& lines) {
  std::vector<std::string> texts;
  for (const GridLine& line : lines) {
    texts.push_back(line.text);
  }
  return texts;
}

using Texts = std::vector<std::string>;

TEST(MapGrid, HasRoundNumbersBetweenItsEnds) {
  EXPECT_EQ(texts_of(grid_lines(-0.1, 1000, 500)), (Texts{"0", "500", "1000"}));
  EXPECT_EQ(texts_of(grid_lines(-0.25, 0.3, 0.2)), (Texts{"-0.2", "0.0", "0.2"}));
  EXPECT_EQ(texts_of(grid_lines(5'000'010, 5'000'250, 100)), (Texts{"5000100", "5000200"}));
  EXPECT_EQ(texts_of(grid_lines(1, 1.5, 1)), Texts{"1"});
  EXPECT_EQ(texts_of(grid_lines(1.1, 1.5, 1)), Texts{});
}

TEST(MapGrid, HasNoLinesWhereNumbersCannotTellThemApart) {
  EXPECT_TRUE(grid_lines(1e17, 1e17 + 64, 1).empty());
}

TEST(MapPage, HasAFrameOfCoordinatesAndTheNorth) {
  const MapPage page = make_map_page({{0, 0, 0}, {1000, 500, 10}}, 1);
  std::ostringstream out;
  open_map(out, page, "a town", "two & three");
  draw_grid(out, page);
  close_map(out, page);
  const std::string text = out.str();
  EXPECT_NE(text.find(" role=\"img\" aria-labelledby=\"map-title map-about\""), std::string::npos);
  EXPECT_NE(text.find("<title id=\"map-title\">a town</title>"), std::string::npos);
  EXPECT_NE(text.find("<desc id=\"map-about\">two &amp; three</desc>"), std::string::npos);
  EXPECT_NE(text.find(">N</text>"), std::string::npos);
  // 0 to 1000 by 200 along x, 0 to 500 along y.
  for (const char* const number : {">0<", ">200<", ">1000<"}) {
    EXPECT_NE(text.find(number), std::string::npos) << number;
  }
  EXPECT_EQ(text.find(">1200<"), std::string::npos);
}

std::vector<std::string> numbers_of(const std::vector<Label>& places) {
  std::vector<std::string> numbers;
  for (const NumberedPlace& place : numbered_places(places, 18)) {
    numbers.push_back(place.numbers);
  }
  return numbers;
}

TEST(MapMarks, PlacesThatCoincideShareOneMarkWithAllTheirNumbers) {
  EXPECT_EQ(numbers_of({{0, 0}, {100, 0}, {200, 0}}), (Texts{"1", "2", "3"}));
  EXPECT_EQ(numbers_of({{0, 0}, {1, 0}, {2, 0}, {100, 0}, {3, 0}}), (Texts{"1-3, 5", "4"}));
  EXPECT_EQ(numbers_of({{0, 0}, {5, 5}}), Texts{"1, 2"});
  EXPECT_EQ(numbers_of({}), Texts{});
}

}  // namespace
}  // namespace soms::command
