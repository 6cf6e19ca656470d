// Real cities and a terrain, cut into tiles of several sizes.
#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/io/read_mesh.h"

#include "tests/support/support.h"
#include "tests/tiles/tiled_twin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace soms {
namespace {

void expect_union(const Mesh& mesh, std::uint64_t seed) {
  Rng rng(seed);
  const Body whole{Shape(mesh)};
  const auto questions =
      test::random_questions(rng, Shape(generate_mover(MoverKind::car)), whole.shape.bounds(), 400);
  for (const std::size_t most : {10'000UL, 40'000UL, 300'000UL, mesh.triangles.size()}) {
    const test::TemporaryFolder folder;
    const TileSet tiles = test::tiles_of(folder.path(), std::vector<Mesh>{mesh}, {.most = most});
    EXPECT_EQ(difference(questions, {tiles}, whole), "") << "tiles of " << most;
  }
}

class TiledCities : public testing::TestWithParam<const char*> {};

TEST_P(TiledCities, AnswerAsTheWhole) {
  const auto path = test::outside_data(std::string("cities/") + GetParam());
  SOMS_NEEDS_OUTSIDE_DATA(std::string("the city ") + GetParam() + ", cut into tiles");
  expect_union(read_mesh(*path), 11);
}

INSTANTIATE_TEST_SUITE_P(Cities, TiledCities,
                         testing::Values("denhaag_01.ply", "zurich_far_origin.ply",
                                         "rotterdam_delfshaven.ply"));

TEST(TiledTerrain, AnswersAsTheWhole) {
  Mesh terrain;
  constexpr std::uint32_t kSide = 150;
  for (std::uint32_t y = 0; y <= kSide; ++y) {
    for (std::uint32_t x = 0; x <= kSide; ++x) {
      terrain.vertices.push_back({static_cast<double>(x), static_cast<double>(y),
                                  3 * std::sin(0.1 * x) * std::cos(0.13 * y)});
    }
  }
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const std::uint32_t at = y * (kSide + 1) + x;
      terrain.triangles.push_back({at, at + 1, at + kSide + 1});
      terrain.triangles.push_back({at + 1, at + kSide + 2, at + kSide + 1});
    }
  }
  expect_union(terrain, 12);
}

}  // namespace
}  // namespace soms
