#include "apps/view/drawing/tiles.h"

#include "tests/support/support.h"
#include "tests/view/drawing/gl_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace soms::view {
namespace {

using test_drawing::blocks;

Vec3 place(const Tile& tile, const TileVertex& v) {
  return tile.origin + Vec3{v.x, v.y, v.z} * tile.scale;
}

double longest_side(const Triangle& t) {
  const Vec3 e = bounds(t).extent();
  return std::max({e.x, e.y, e.z});
}

using Corners = std::array<std::array<double, 3>, 3>;

Corners rounded(const Triangle& t, const Vec3& origin) {
  const auto round = [&](const Vec3& p) {
    return std::array<double, 3>{std::round((p.x - origin.x) * 256),
                                 std::round((p.y - origin.y) * 256),
                                 std::round((p.z - origin.z) * 256)};
  };
  return {round(t.a), round(t.b), round(t.c)};
}

TEST(Tiles, HoldEachTriangleOnceAndWhereItWas) {
  for (const double shift : {0.0, 1e6}) {
    const Vec3 center{shift, 2 * shift, 0};
    const Mesh mesh = blocks(20, center);
    const TiledMesh cut = cut_in_tiles(mesh, {}, {.triangles = 300});
    std::vector<Corners> there;
    std::uint32_t next = 0;
    for (const Tile& tile : cut.tiles) {
      EXPECT_EQ(tile.first, next);
      EXPECT_LE(tile.count, 300U);
      next += tile.count;
      for (std::size_t t = tile.first; t < tile.first + tile.count; ++t) {
        const auto corner = [&](std::size_t k) {
          return place(tile, cut.vertices[cut.indices[3 * t + k]]);
        };
        const Triangle triangle{corner(0), corner(1), corner(2)};
        EXPECT_LE(longest_side(triangle), 2 * tile.scale * 1.001);
        there.push_back(rounded(triangle, center));
      }
    }
    EXPECT_EQ(next, mesh.triangles.size());
    std::vector<Corners> wanted;
    for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
      wanted.push_back(rounded(mesh.triangle(i), center));
    }
    std::sort(there.begin(), there.end());
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(there, wanted);
  }
}

TEST(Tiles, AreBoundedInNumberAndShareVertices) {
  const Mesh mesh = blocks(30);
  const TiledMesh many = cut_in_tiles(mesh, {}, {.triangles = 10, .most_tiles = 16});
  EXPECT_EQ(many.tiles.size(), 16U);
  const TiledMesh one = cut_in_tiles(mesh, {}, {.triangles = 1 << 20, .stand_in_of = 0});
  EXPECT_EQ(one.tiles.size(), 1U);
  EXPECT_EQ(one.vertices.size(), mesh.vertices.size());
}

TEST(Tiles, ShowLargeTrianglesFirst) {
  Mesh mesh;
  test::for_each_case("tiles/large", 1, [&](Rng& rng) {
    for (int i = 0; i < 500; ++i) {
      const Vec3 at{rng.uniform(0, 100), rng.uniform(0, 100), 0};
      const double side = std::exp(rng.uniform(-5, 3));
      test_drawing::add_block(mesh, at, at + Vec3{side, side, side});
    }
  });
  const TiledMesh cut = cut_in_tiles(mesh, {}, {.triangles = 1000});
  for (const Tile& tile : cut.tiles) {
    double least = 1e300;
    for (std::size_t t = tile.first; t < tile.first + tile.count; ++t) {
      Triangle triangle;
      triangle.a = place(tile, cut.vertices[cut.indices[3 * t]]);
      triangle.b = place(tile, cut.vertices[cut.indices[3 * t + 1]]);
      triangle.c = place(tile, cut.vertices[cut.indices[3 * t + 2]]);
      EXPECT_LE(longest_side(triangle), 4.01 * least);
      least = std::min(least, longest_side(triangle));
    }
  }
}

TEST(Tiles, KeepTheColorOfEachTriangle) {
  const Mesh mesh = test_drawing::wall(0, 0, 0, 1, 1);
  const std::vector<Color> colors{{255, 0, 0, 255}, {0, 255, 0, 255}};
  const TiledMesh cut = cut_in_tiles(mesh, colors);
  ASSERT_EQ(cut.indices.size(), 6U);
  EXPECT_EQ(cut.vertices.size(), 6U) << "corners of two colors are two vertices";
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(cut.vertices[cut.indices[i]].color, colors[i / 3]);
  }
}

TEST(Tiles, OfNothingAreNoneAndOfPointsAreOne) {
  EXPECT_TRUE(cut_in_tiles(Mesh{}, {}).tiles.empty());
  Mesh point;
  point.vertices = {{3, 4, 5}};
  point.triangles = {{0, 0, 0}};
  const TiledMesh cut = cut_in_tiles(point, {});
  ASSERT_EQ(cut.tiles.size(), 1U);
  EXPECT_EQ(place(cut.tiles[0], cut.vertices[0]), (Vec3{3, 4, 5}));
}

}  // namespace
}  // namespace soms::view
