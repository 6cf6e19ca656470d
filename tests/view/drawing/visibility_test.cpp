#include "apps/view/drawing/visibility.h"

#include "apps/view/drawing/renderer.h"
#include "tests/support/support.h"
#include "tests/view/drawing/gl_support.h"

#include <algorithm>
#include <cmath>

namespace soms::view {
namespace {

using test_drawing::before_origin;

Box box_at(const Vec3& p, double half) {
  return {p - Vec3{half, half, half}, p + Vec3{half, half, half}};
}

TEST(Frustum, SeesEveryBoxWithAPointInThePicture) {
  test::for_each_case("visibility/sees", 1000, [](Rng& rng) {
    const auto point = [&] {
      return Vec3{rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9)};
    };
    const Camera camera{point(), point(), {0, 0, 1}, rng.uniform(0.3, 1.5)};
    const Size size{320, 200};
    const Vec3 p = point();
    const auto seen = project(camera, size, p);
    if (seen && seen->pixel.x >= 0 && seen->pixel.x <= size.width && seen->pixel.y >= 0 &&
        seen->pixel.y <= size.height) {
      EXPECT_TRUE(sees(frustum(camera, size), box_at(p, rng.uniform(0, 3))));
    }
  });
}

TEST(Frustum, DoesNotSeeWhatIsBehindOrBeside) {
  const Frustum view = frustum(before_origin(), {100, 100});
  EXPECT_TRUE(sees(view, box_at({0, 0, 0}, 1)));
  EXPECT_FALSE(sees(view, box_at({0, -20, 0}, 1)));
  EXPECT_FALSE(sees(view, box_at({50, 0, 0}, 1)));
  EXPECT_FALSE(sees(view, box_at({0, 0, -50}, 1)));
  EXPECT_FALSE(sees(view, Box{}));
  EXPECT_TRUE(sees(view, box_at({0, -10, 0}, 1))) << "the eye is inside";
}

DrawList instances(std::size_t n, double apart) {
  DrawList list = test_drawing::list_of(test_drawing::wall(0, -1, -1, 1, 1));
  for (std::size_t i = 1; i < n; ++i) {
    list.instances.push_back(
        {.mesh = 0, .pose = Pose::translation(0, apart * static_cast<double>(i), 0)});
  }
  return list;
}

TEST(ChooseTiles, GathersInstancesOfAMeshInOneCall) {
  const DrawList list = instances(50, 1);
  const TiledMesh cut = cut_in_tiles(*list.meshes[0].mesh, {});
  const std::vector<std::span<const Tile>> tiles{cut.tiles};
  const Visible all = choose_tiles(list, tiles, before_origin(), {64, 64}, 1000);
  ASSERT_EQ(all.groups.size(), 1U);
  EXPECT_EQ(all.groups[0].instances.size(), 50U);
  EXPECT_EQ(all.triangles, 100U);
  EXPECT_EQ(all.triangles_left, 0U);
  EXPECT_EQ(all.tiles_drawn, 50U);
  const Visible behind = choose_tiles(instances(50, -100), tiles, before_origin(), {64, 64}, 1000);
  EXPECT_EQ(behind.tiles, 50U);
  EXPECT_EQ(behind.tiles_drawn, 1U);
}

TEST(ChooseTiles, KeepsTheBudgetAndGivesMoreToWhatLooksLarge) {
  const Mesh mesh = test_drawing::blocks(40);
  const TiledMesh cut = cut_in_tiles(mesh, {}, {.triangles = 1000, .stand_in_of = 0});
  const std::vector<std::span<const Tile>> tiles{cut.tiles};
  const DrawList list = test_drawing::list_of(mesh);
  const Camera camera{{0, -450, 60}, {0, 0, 0}, {0, 0, 1}, 0.9};
  const std::uint64_t whole =
      choose_tiles(list, tiles, camera, {640, 360}, DrawOptions::kAll).triangles;
  for (const std::uint64_t budget : {std::uint64_t{0}, std::uint64_t{100}, whole / 3, whole}) {
    const Visible some = choose_tiles(list, tiles, camera, {640, 360}, budget);
    EXPECT_LE(some.triangles, budget);
    EXPECT_GE(some.triangles + 2 * cut.tiles.size(), std::min(budget, whole));
    EXPECT_EQ(some.triangles + some.triangles_left, whole);
  }
  const Visible third = choose_tiles(list, tiles, camera, {640, 360}, whole / 3);
  ASSERT_GT(third.groups.size(), 2U);
  EXPECT_GT(third.groups.front().triangles, third.groups.back().triangles)
      << "groups come from near to far";
}

TEST(ChooseTiles, DrawsStandInsWhereAllIsTooMuchAndTilesThatLookLargeWhole) {
  const Mesh mesh = test_drawing::blocks(40);
  const TiledMesh cut = cut_in_tiles(mesh, {}, {.triangles = 1000});
  const std::vector<std::span<const Tile>> tiles{cut.tiles};
  const DrawList list = test_drawing::list_of(mesh);
  const Camera camera{{0, -450, 60}, {0, 0, 0}, {0, 0, 1}, 0.9};
  const auto choose = [&](std::uint64_t most) {
    return choose_tiles(list, tiles, camera, {640, 360}, most);
  };
  const Visible whole = choose(DrawOptions::kAll);
  std::uint64_t stand_ins = 0;
  for (const TileGroup& group : whole.groups) {
    EXPECT_EQ(group.form, TileForm::whole);
    stand_ins += cut.tiles[group.tile].stand_in_count;
  }
  ASSERT_GT(stand_ins, 0U);
  const Visible coarse = choose(stand_ins);
  EXPECT_EQ(coarse.groups.size(), whole.groups.size());  // no tile is missing
  EXPECT_EQ(coarse.triangles, stand_ins);
  EXPECT_EQ(coarse.triangles_left, whole.triangles - stand_ins);
  const Visible some = choose(whole.triangles / 3);
  EXPECT_EQ(some.groups.size(), whole.groups.size());
  EXPECT_LE(some.triangles, whole.triangles / 3);
  EXPECT_EQ(some.groups.front().form, TileForm::whole);  // from near to far
  EXPECT_NE(some.groups.back().form, TileForm::whole);
  for (const TileGroup& group : some.groups) {
    EXPECT_EQ(group.triangles, run_of(cut.tiles[group.tile], group.form).count);
  }
  for (const TileGroup& group : choose(whole.triangles / 2).groups) {
    EXPECT_EQ(group.form, TileForm::whole);  // only small triangles are missing
  }
}

TEST(ChooseTiles, LeavesOutNoTileThatHasACopyHoweverFewTrianglesAreGranted) {
  const Mesh mesh = test_drawing::blocks(40);
  const TiledMesh cut = cut_in_tiles(mesh, {}, {.triangles = 8192});
  const std::vector<std::span<const Tile>> tiles{cut.tiles};
  const DrawList list = test_drawing::list_of(mesh);
  const Camera camera{{0, -450, 60}, {0, 0, 0}, {0, 0, 1}, 0.9};
  const Visible whole = choose_tiles(list, tiles, camera, {640, 360}, DrawOptions::kAll);
  std::uint64_t least = 0;
  for (const TileGroup& group : whole.groups) {
    const Tile& tile = cut.tiles[group.tile];
    ASSERT_GT(tile.least_count, 0U);
    EXPECT_LT(tile.least_count, tile.stand_in_count);
    EXPECT_LE(tile.least_count, 160U);
    least += tile.least_count;
  }
  for (const std::uint64_t most : {std::uint64_t{0}, least / 2, least}) {
    const Visible few = choose_tiles(list, tiles, camera, {640, 360}, most);
    EXPECT_EQ(few.groups.size(), whole.groups.size());
    EXPECT_EQ(few.triangles, least);
  }
}

TEST(ChooseTiles, DrawsWhatIsNearWholeThoughFarTilesTakeAllThatIsGranted) {
  const Mesh mesh = test_drawing::blocks(60);
  const TiledMesh cut = cut_in_tiles(mesh, {}, {.triangles = 1500});
  const std::vector<std::span<const Tile>> tiles{cut.tiles};
  const DrawList list = test_drawing::list_of(mesh);
  const Camera camera{{0, -590, 20}, {0, 0, 0}, {0, 0, 1}, 0.9};  // in the first row of houses
  const Visible few = choose_tiles(list, tiles, camera, {640, 360}, 3'200);
  ASSERT_GT(few.groups.size(), 10U);
  const auto nearest = std::min_element(
      few.groups.begin(), few.groups.end(),
      [](const TileGroup& a, const TileGroup& b) { return std::abs(a.depth) < std::abs(b.depth); });
  EXPECT_EQ(nearest->form, TileForm::whole);
  EXPECT_EQ(few.groups.back().form, TileForm::least);
}

TEST(ChooseTiles, NearCopiesOfAMeshStayWholeBesideFarOnes) {
  const Mesh mesh = test_drawing::blocks(10);
  const TiledMesh cut = cut_in_tiles(mesh, {});
  ASSERT_EQ(cut.tiles.size(), 1U);
  const std::vector<std::span<const Tile>> tiles{cut.tiles};
  DrawList list = test_drawing::list_of(mesh);
  for (int k = 1; k < 40; ++k) {
    list.instances.push_back(list.instances[0]);
    list.instances.back().pose = Pose::translation(300.0 * (k - 20), 8000, 0);
  }
  const Camera camera{{0, -450, 60}, {0, 0, 60}, {0, 0, 1}, 0.9};
  const std::uint64_t one = mesh.triangles.size();
  const Visible some = choose_tiles(list, tiles, camera, {640, 360}, 8 * one);
  ASSERT_EQ(some.groups.size(), 2U);
  EXPECT_EQ(some.groups[0].form, TileForm::whole);
  EXPECT_EQ(some.groups[0].instances, std::vector<std::uint32_t>{0});
  EXPECT_NE(some.groups[1].form, TileForm::whole);
}

TEST(ChooseTiles, DrawsWhatIsSmallerThanTwoPixelsByItsCoarsestCopy) {
  const Mesh mesh = test_drawing::blocks(10);  // some 200 across
  const TiledMesh cut = cut_in_tiles(mesh, {});
  ASSERT_EQ(cut.tiles.size(), 1U);
  ASSERT_GT(cut.tiles[0].stand_in_count, 0U);
  const std::vector<std::span<const Tile>> tiles{cut.tiles};
  DrawList list = test_drawing::list_of(mesh);
  list.instances.push_back(list.instances[0]);
  list.instances[1].pose = Pose::translation(0, 1e6, 0);
  const Camera camera{{0, -450, 60}, {0, 0, 60}, {0, 0, 1}, 0.9};
  const Visible all = choose_tiles(list, tiles, camera, {640, 360}, DrawOptions::kAll);
  ASSERT_EQ(all.groups.size(), 2U);  // from near to far
  EXPECT_EQ(all.groups[0].form, TileForm::whole);
  EXPECT_EQ(all.groups[1].form, TileForm::least);
  EXPECT_EQ(all.groups[1].triangles, run_of(cut.tiles[0], TileForm::least).count);
  EXPECT_EQ(all.triangles_left, 0U);
  const auto everywhere = [](const Box&) { return true; };
  EXPECT_EQ(choose_casters(list, tiles, everywhere, 1)[0].form, TileForm::whole);
  EXPECT_EQ(choose_casters(list, tiles, everywhere, 1000)[0].form, TileForm::stand_in);
}

TEST(ChooseTiles, DrawsEdgesOfThoseAloneThatShowThem) {
  DrawList list = instances(5, 1);
  list.instances[1].style = SurfaceStyle::both;
  list.instances[3].style = SurfaceStyle::both;
  const TiledMesh cut = cut_in_tiles(*list.meshes[0].mesh, {});
  const std::vector<std::span<const Tile>> tiles{cut.tiles};
  const Visible all = choose_tiles(list, tiles, before_origin(), {64, 64}, 1000);
  ASSERT_EQ(all.groups.size(), 2U);
  for (const TileGroup& group : all.groups) {
    EXPECT_EQ(group.pass, Pass::solid);
    EXPECT_EQ(group.instances, group.edges ? (std::vector<std::uint32_t>{1, 3})
                                           : (std::vector<std::uint32_t>{0, 2, 4}));
  }
  EXPECT_EQ(all.triangles, 10U);
}

TEST(ChooseTiles, PutsEachInstanceInItsPass) {
  DrawList list = instances(3, 1);
  list.instances[1].color.a = 100;
  list.instances[2].style = SurfaceStyle::wire;
  const TiledMesh cut = cut_in_tiles(*list.meshes[0].mesh, {});
  const std::vector<std::span<const Tile>> tiles{cut.tiles};
  const Visible all = choose_tiles(list, tiles, before_origin(), {64, 64}, 1000);
  ASSERT_EQ(all.groups.size(), 3U);
  EXPECT_EQ(all.groups[0].pass, Pass::solid);
  EXPECT_EQ(all.groups[1].pass, Pass::wire);
  EXPECT_EQ(all.groups[2].pass, Pass::translucent);
}

}  // namespace
}  // namespace soms::view
