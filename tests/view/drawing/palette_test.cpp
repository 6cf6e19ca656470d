#include "apps/view/drawing/palette.h"

#include "tests/support/support.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <tuple>

namespace soms::view {
namespace {

int spread(Color c) {
  return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b});
}

int lightness(Color c) {
  return (2 * c.r + 5 * c.g + c.b) / 8;
}

TEST(Palette, PartsAreMutedSoThatMarksStandOut) {
  std::set<std::tuple<int, int, int>> seen;
  for (std::size_t i = 0; i < 1000; ++i) {
    const Color c = part_color(i);
    EXPECT_LE(spread(c), 60);
    EXPECT_GE(lightness(c), 140);
    seen.insert({c.r, c.g, c.b});
  }
  EXPECT_GE(seen.size(), 8U);
  EXPECT_GE(spread(palette::kContact), 150);
}

TEST(Palette, MoversOfNearNumbersDiffer) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_NE(mover_color(i), mover_color(k));
    }
    EXPECT_NE(mover_color(i), palette::kContact);
  }
}

TEST(Palette, OrderedColorsGrowLighter) {
  int last = -1;
  for (int i = 0; i <= 20; ++i) {
    const int now = lightness(ordered_color(i / 20.0));
    EXPECT_GT(now, last);
    last = now;
  }
  EXPECT_EQ(ordered_color(-1), ordered_color(0));
  EXPECT_EQ(ordered_color(2), ordered_color(1));
}

TEST(Palette, TrianglesTakeTheColorOfTheirPart) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}};
  EXPECT_EQ(colors_by_part(mesh), (std::vector<Color>(3, part_color(0))));
  mesh.parts = {{"a", Part::kNoParent, 0, 1}, {"b", Part::kNoParent, 1, 2}};
  EXPECT_EQ(colors_by_part(mesh),
            (std::vector<Color>{part_color(0), part_color(1), part_color(1)}));
}

}  // namespace
}  // namespace soms::view
