#include "apps/view/drawing/stand_in.h"

#include "soms/generate/shapes.h"

#include "apps/view/drawing/tiles.h"
#include "tests/support/bodies.h"
#include "tests/view/drawing/gl_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

namespace soms::view {
namespace {

std::vector<TriangleId> all_of(const Mesh& mesh) {
  std::vector<TriangleId> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

std::vector<StandInTriangle> stand_in(const Mesh& mesh, const std::vector<TriangleId>& triangles,
                                      const Box& box, std::size_t most) {
  return StandInMaker(mesh, triangles, box).at_most(most);
}

using Edge = std::array<std::array<double, 3>, 2>;

/// True if each edge belongs to two triangles at least.
bool every_edge_is_shared(const std::vector<StandInTriangle>& triangles) {
  const auto numbers = [](const Vec3& p) { return std::array<double, 3>{p.x, p.y, p.z}; };
  std::multiset<Edge> edges;
  for (const StandInTriangle& t : triangles) {
    const std::array<Vec3, 3> corners{t.corners.a, t.corners.b, t.corners.c};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(numbers(corners[k]), numbers(corners[(k + 1) % 3]));
      edges.insert({a, b});
    }
  }
  return std::all_of(edges.begin(), edges.end(),
                     [&](const auto& edge) { return edges.count(edge) > 1; });
}

Box box_of(const std::vector<StandInTriangle>& triangles) {
  Box box;
  for (const StandInTriangle& t : triangles) {
    box.grow(bounds(t.corners));
  }
  return box;
}

TEST(StandIn, OfAClosedSurfaceIsFewTrianglesWithoutAHole) {
  const Mesh mesh = generate_sphere(6'000);
  Box box;
  for (const Vec3& v : mesh.vertices) {
    box.grow(v);
  }
  for (const std::size_t most : {1500U, 100U}) {
    const auto few = stand_in(mesh, all_of(mesh), box, most);
    EXPECT_LE(few.size(), most);
    EXPECT_GT(few.size(), most / 5) << "as fine as allowed";
    EXPECT_TRUE(every_edge_is_shared(few));
    EXPECT_GT(box_of(few).extent().x, 0.8 * box.extent().x);
    EXPECT_TRUE(box.contains(box_of(few)));
  }
}

TEST(StandIn, OfHousesOnAGroundAreBoxesTheLargestFirst) {
  Mesh mesh = test::box_body({0, 0, -1}, {100, 100, 0}, 8);
  const std::size_t ground = mesh.triangles.size();
  append(mesh, test::box_body({10.5, 10.5, 0}, {20.5, 20.5, 30}, 3));
  append(mesh, test::box_body({51, 51, 0}, {71, 71, 25}, 3));
  append(mesh, test::box_body({90.5, 90.5, 0}, {91.5, 91.5, 1}, 3));
  const auto of = [&](std::size_t most) {
    return stand_in(mesh, all_of(mesh), {{0, 0, -1}, {100, 100, 30}}, most);
  };
  const auto all = of(120);
  ASSERT_GT(all.size(), 30U);
  ASSERT_LE(all.size(), 120U);
  const auto boxes = all.end() - 30;
  const std::vector<StandInTriangle> rest(all.begin(), boxes);
  const Box there = box_of(rest);  // the ground, up to its ends
  EXPECT_EQ(there.lower.x, 0);
  EXPECT_EQ(there.upper.y, 100);
  EXPECT_LE(there.upper.z, 0);
  const std::vector<StandInTriangle> first(boxes, boxes + 10);
  EXPECT_EQ(box_of(first), (Box{{51, 51, 0}, {71, 71, 25}}));
  EXPECT_EQ(box_of({boxes + 10, boxes + 20}), (Box{{10.5, 10.5, 0}, {20.5, 20.5, 30}}));
  for (const StandInTriangle& t : first) {
    EXPECT_GE(t.of, ground + 108);  // a color of its own
    EXPECT_LT(t.of, ground + 216);
  }
}

TEST(StandIn, OfManyHousesLeavesOutNoneButJoinsNeighbors) {
  Mesh mesh = test::box_body({0, 0, -1}, {100, 100, 0}, 8);
  const std::size_t ground = mesh.triangles.size();
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 10; ++y) {
      const double at_x = 10 * x + 3;
      const double at_y = 10 * y + 3;
      append(mesh, test::box_body({at_x, at_y, 0}, {at_x + 5, at_y + 5, x == 9 ? 20.0 : 6.0}, 1));
    }
  }
  const auto few = stand_in(mesh, all_of(mesh), {{0, 0, -1}, {100, 100, 20}}, 200);
  EXPECT_LE(few.size(), 200U);
  std::vector<Box> boxes;
  for (std::size_t k = few.size() % 10; k < few.size(); k += 10) {
    if (few[k].of >= ground) {
      boxes.push_back(box_of({few.begin() + static_cast<std::ptrdiff_t>(k),
                              few.begin() + static_cast<std::ptrdiff_t>(k + 10)}));
    }
  }
  ASSERT_GE(boxes.size(), 4U);
  double footprint = 0;
  Box all;
  for (const Box& box : boxes) {
    footprint += box.extent().x * box.extent().y;
    all.grow(box);
  }
  EXPECT_NEAR(footprint, 100 * 25, 1) << "what was free stays free";
  EXPECT_LT(all.lower.x, 20);
  EXPECT_GT(all.upper.x, 80);
  EXPECT_LT(all.lower.y, 20);
  EXPECT_GT(all.upper.y, 80);
  EXPECT_GT(all.upper.z, 6) << "where the high ones are";
  EXPECT_LE(all.upper.z, 20);
}

TEST(StandIn, KeepsTheFirstOfEqualTrianglesAndItsColor) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0.01, 0, 0}, {8, 0.01, 0}, {0, 7.99, 0}};
  mesh.triangles = {{3, 4, 5}, {0, 1, 2}, {0, 3, 1}};  // almost the same, and a sliver
  const auto few = stand_in(mesh, std::vector<TriangleId>{1, 0, 2}, {{0, 0, 0}, {8, 8, 0}}, 10);
  ASSERT_EQ(few.size(), 1U);
  EXPECT_EQ(few[0].of, 1U);
}

TEST(StandIn, OfNothingIsNothing) {
  EXPECT_TRUE(StandInMaker(Mesh{}, {}, {}).at_most(10).empty());
}

TEST(StandIn, OfTilesComeBehindAllTrianglesInTheColorsOfTheirOwn) {
  const Mesh mesh = test_drawing::blocks(40);
  std::vector<Color> colors;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    colors.push_back({static_cast<std::uint8_t>(i / 64 % 200), 7, 9, 255});
  }
  const TiledMesh cut = cut_in_tiles(mesh, colors, {.triangles = 4000});
  const TiledMesh bare = cut_in_tiles(mesh, colors, {.triangles = 4000, .stand_in_of = 0});
  std::uint32_t next = static_cast<std::uint32_t>(mesh.triangles.size());
  ASSERT_EQ(cut.tiles.size(), bare.tiles.size());
  ASSERT_GT(cut.tiles.size(), 2U);
  for (std::size_t i = 0; i < cut.tiles.size(); ++i) {
    const Tile& tile = cut.tiles[i];
    EXPECT_EQ(tile.first, bare.tiles[i].first);
    EXPECT_EQ(bare.tiles[i].stand_in_count, 0U);
    EXPECT_EQ(tile.stand_in_first, next);
    EXPECT_GT(tile.stand_in_count, 0U);
    EXPECT_LE(tile.stand_in_count, tile.count / 12);
    EXPECT_EQ(tile.least_first, next + tile.stand_in_count);
    EXPECT_LT(tile.least_count, tile.stand_in_count);
    next += tile.stand_in_count + tile.least_count;
    for (std::size_t k = 3 * tile.stand_in_first; k < 3 * std::size_t{next}; ++k) {
      const TileVertex& v = cut.vertices.at(cut.indices.at(k));
      EXPECT_LE(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}), 1.001F);
      EXPECT_EQ(v.color.g, 7);
    }
  }
  EXPECT_EQ(cut.indices.size(), 3 * std::size_t{next});
  EXPECT_EQ(bare.indices.size(), 3 * mesh.triangles.size());
}

}  // namespace
}  // namespace soms::view
