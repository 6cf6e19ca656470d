#include "apps/view/scene/scene_colors.h"

#include "soms/generate/city.h"

#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soms::view {
namespace {

TEST(SceneColors, PartsAreTheInnermostOnes) {
  CityOptions options;
  options.triangles = 6000;
  const Mesh city = generate_city(options).mesh;
  ASSERT_GT(city.parts.size(), 10U);
  const std::vector<std::uint32_t> parts = parts_of_triangles(city);
  for (TriangleId i = 0; i < city.triangles.size(); ++i) {
    ASSERT_EQ(parts[i], part_of(city, i));
  }
  EXPECT_EQ(parts_of_triangles(test::box_body({0, 0, 0}, {1, 1, 1}))[3], Part::kNoParent);
}

TEST(SceneColors, PiecesAreWhatSharesVertices) {
  const Mesh two = test::joined(test::box_body({0, 0, 0}, {1, 1, 1}, 3),
                                test::box_body({5, 0, 0}, {6, 1, 1}, 2));
  const std::vector<std::uint32_t> pieces = pieces_of_triangles(two);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_EQ(pieces[i], i < 108 ? 0U : 1U);
  }
}

TEST(SceneColors, OfABuildingAreOneColor) {
  Mesh two = test::joined(test::box_body({0, 0, 0}, {1, 1, 1}, 3),
                          test::box_body({5, 0, 0}, {6, 1, 1}, 2));
  two.parts.clear();
  const std::vector<Color> colors = colors_by_building(two);
  ASSERT_EQ(colors.size(), two.triangles.size());
  EXPECT_EQ(std::count(colors.begin(), colors.begin() + 108, colors[0]), 108);
  EXPECT_EQ(std::count(colors.begin() + 108, colors.end(), colors[108]), 48);
  EXPECT_NE(colors[0], colors[108]);
}

TEST(SceneColors, OfTrianglesThatShareNothingGoByPlace) {
  std::vector<Triangle> soup;
  for (int k = 0; k < 400; ++k) {
    const double x = k % 20;
    const int row = k / 20;
    const double y = row;
    soup.push_back({{x, y, 0}, {x + 0.5, y, 0}, {x, y + 0.5, 1}});
    soup.push_back({{x, y, 0}, {x + 0.5, y, 1}, {x, y + 0.5, 0}});
  }
  const std::vector<Color> colors = colors_by_building(test::soup_body(soup));
  for (std::size_t i = 0; i < colors.size(); i += 2) {
    EXPECT_EQ(colors[i], colors[i + 1]);  // neighbors
  }
  EXPECT_NE(
      *std::max_element(colors.begin(), colors.end(), [](Color a, Color b) { return a.r < b.r; }),
      colors[0]);
  EXPECT_TRUE(colors_by_building(Mesh{}).empty());
}

}  // namespace
}  // namespace soms::view
