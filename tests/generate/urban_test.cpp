#include "soms/generate/urban.h"

#include "tests/support/support.h"

#include <array>

namespace soms {
namespace {

struct Expected {
  UrbanScene scene;
  std::uint64_t corners;  ///< corner_hash of the scene that the golden counts were made with
  Box box;
};

const std::array<Expected, 3> kScenes{{
    {UrbanScene::mixed, 0x5e44b5637f4cb56cULL, {{0, 0, -30}, {4000, 4000, 197}}},
    {UrbanScene::boxes, 0x57cb92e64471a071ULL, {{0, 0, 0}, {4000, 4000, 175}}},
    {UrbanScene::plain, 0xb2dc50f5a09a47cdULL, {{0, 0, -1}, {4000, 4000, 179}}},
}};

TEST(Urban, ScenesAreTheOnesThatTheGoldenCountsWereMadeWith) {
  for (const Expected& expected : kScenes) {
    const Mesh mesh = generate_urban(expected.scene);
    EXPECT_EQ(mesh.triangles.size(), 5672U);
    EXPECT_EQ(corner_hash(mesh), expected.corners) << mesh.source;
    EXPECT_NO_THROW(check(mesh));
    EXPECT_EQ(mesh.up, UpAxis::z);
    EXPECT_EQ(mesh.unit, 1);
  }
}

TEST(Urban, CoordinatesAreWholeOrHalfMetersWithinFourKilometers) {
  for (const Expected& expected : kScenes) {
    const Mesh mesh = generate_urban(expected.scene);
    EXPECT_EQ(bounds(mesh), expected.box) << mesh.source;
    for (const Vec3& v : mesh.vertices) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(2 * v[axis], static_cast<int>(2 * v[axis]));
      }
    }
  }
}

TEST(Urban, MixedSceneNamesItsPartsInOrder) {
  const Mesh mesh = generate_urban(UrbanScene::mixed);
  const std::array<std::pair<const char*, std::uint32_t>, 4> parts{
      {{"terrain", 512}, {"roads", 68}, {"blocks", 3868}, {"signs", 1224}}};
  ASSERT_EQ(mesh.parts.size(), parts.size());
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(mesh.parts[i].name, parts[i].first);
    EXPECT_EQ(mesh.parts[i].first, first);
    EXPECT_EQ(mesh.parts[i].count, parts[i].second);
    first += parts[i].second;
  }
}

TEST(Urban, EachPositionIsOneVertex) {
  const Mesh mesh = generate_urban(UrbanScene::boxes);
  EXPECT_EQ(mesh.vertices.size(), 4 * (4 + 118 * 8) - 7U);  // quarters share 7 ground corners
}

}  // namespace
}  // namespace soms
