#include "apps/view/drawing/ground_colors.h"

#include "soms/generate/city.h"

#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <string_view>
#include <vector>

namespace soms::view {
namespace {

constexpr Color kBefore{10, 20, 30, 255};

Mesh town(CityStreets streets) {
  return generate_city({20'000, 245, 1, streets}).mesh;
}

/// Connected pieces by the places of corners.
std::vector<std::uint32_t> pieces_of(const Mesh& mesh) {
  std::map<std::array<double, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) {
      v = parent[v] = parent[parent[v]];
    }
    return v;
  };
  for (std::uint32_t v = 0; v < parent.size(); ++v) {
    const Vec3& p = mesh.vertices[v];
    parent[v] = places.try_emplace({p.x, p.y, p.z}, v).first->second;
  }
  for (const auto& t : mesh.triangles) {
    parent[root(t[1])] = root(t[0]);
    parent[root(t[2])] = root(t[0]);
  }
  std::map<std::uint32_t, std::uint32_t> numbers;
  std::vector<std::uint32_t> pieces;
  for (const auto& t : mesh.triangles) {
    pieces.push_back(
        numbers.try_emplace(root(t[0]), static_cast<std::uint32_t>(numbers.size())).first->second);
  }
  return pieces;
}

/// Share of a part's triangles that have a color other than before.
double share_colored(const Mesh& mesh, const std::vector<Color>& colors, std::string_view name) {
  for (const Part& part : mesh.parts) {
    if (part.name == name) {
      const auto begin = colors.begin() + static_cast<std::ptrdiff_t>(part.first);
      const auto other = part.count - std::count(begin, begin + part.count, kBefore);
      return static_cast<double>(other) / part.count;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(GroundColors, OfAFileWithoutNamesAreThoseOfItsStreetsAndWhatLiesOnThem) {
  const Mesh mesh = town(CityStreets::paved);
  std::vector<Color> colors(mesh.triangles.size(), kBefore);
  color_ground(mesh, pieces_of(mesh), colors);
  for (const char* name : {"terrain", "roads", "sidewalks", "lane marks"}) {
    EXPECT_EQ(share_colored(mesh, colors, name), 1) << name;
  }
  EXPECT_EQ(share_colored(mesh, colors, "buildings"), 0);
  EXPECT_LT(share_colored(mesh, colors, "furniture"), 0.02);
}

TEST(GroundColors, MarksAreLighterThanSidewalksAndThoseThanStreets) {
  const Mesh mesh = town(CityStreets::paved);
  std::vector<Color> colors(mesh.triangles.size(), kBefore);
  color_named_ground(mesh, colors);
  std::vector<int> grays;
  for (const char* name : {"roads", "sidewalks", "lane marks"}) {
    const auto part = std::find_if(mesh.parts.begin(), mesh.parts.end(),
                                   [&](const Part& p) { return p.name == name; });
    ASSERT_NE(part, mesh.parts.end());
    grays.push_back(colors[part->first].g);
  }
  EXPECT_GT(grays[1], grays[0] + 15);
  EXPECT_GT(grays[2], grays[1] + 15);
  EXPECT_EQ(share_colored(mesh, colors, "buildings"), 0);
}

TEST(GroundColors, LeaveBodiesAloneThatStandOnNothing) {
  const Mesh plate = test::box_body({0, 0, 0}, {10, 10, 0.5});
  const Mesh roof = test::joined(test::box_body({0, 0, 5}, {10, 10, 5.5}),
                                 test::box_body({4, 4, 0}, {6, 6, 4.9}));
  for (const Mesh& mesh : {plate, roof}) {
    std::vector<Color> colors(mesh.triangles.size(), kBefore);
    color_ground(mesh, pieces_of(mesh), colors);
    EXPECT_EQ(std::count(colors.begin(), colors.end(), kBefore),
              static_cast<std::ptrdiff_t>(colors.size()));
  }
}

}  // namespace
}  // namespace soms::view
