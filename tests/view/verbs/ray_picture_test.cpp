// Pictures and maps made of rays: distances, and what a point sees.
#include "apps/view/verbs/ray_picture.h"

#include "soms/io/write_mesh.h"

#include "apps/view/drawing/palette.h"
#include "apps/view/verbs/sight_map.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"
#include "tests/view/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {
namespace {

/// A plate of 20 x 20 whose top is z = 0, with a wall across it at x = 0, 10 high.
Mesh walled_plate() {
  return test::joined(test::box_body({-10, -10, -1}, {10, 10, 0}),
                      test::box_body({-0.125, -10, 0}, {0.125, 10, 10}));
}

ViewScene scene_of(Mesh mesh) {
  SceneContent content;
  content.city.emplace_back(std::move(mesh));
  content.city.back().name = "plate";
  content.title = "plate";
  return ViewScene(std::move(content));
}

/// Looks down on the plate from far above.
constexpr Camera kAbove{{0, 0, 100}, {0, 0, 0}, {0, 1, 0}, 0.25};

TEST(RayPicture, DepthIsTheDistanceFromTheEye) {
  const ViewScene scene = scene_of(test::box_body({-10, -10, -1}, {10, 10, 0}));
  const DepthPicture drawn = draw_depth(scene, {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 0.8}, {9, 9}, 1);
  EXPECT_EQ(drawn.surface, 81U);
  EXPECT_EQ(drawn.nearest, 10);
  const double corner = std::tan(0.4) * 10 * 8 / 9;  // of the outermost pixel's center, each way
  EXPECT_NEAR(drawn.farthest, std::sqrt(100 + 2 * corner * corner), 1e-12);
  EXPECT_EQ(drawn.picture.at(4, 4), ordered_color(0));
  EXPECT_EQ(drawn.picture.at(0, 0), ordered_color(1));
  EXPECT_EQ(drawn.picture.at(8, 8), ordered_color(1));
}

TEST(RayPicture, DepthOfNothingIsSky) {
  const DepthPicture drawn = draw_depth(ViewScene(SceneContent{}), {}, {8, 6}, 4);
  EXPECT_EQ(drawn.surface, 0U);
  EXPECT_EQ(drawn.nearest, 0);
  EXPECT_EQ(drawn.farthest, 0);
  EXPECT_EQ(drawn.picture, filled({8, 6}, drawn.picture.at(0, 0)));
}

TEST(RayPicture, DepthHasAKeyWhereThereIsRoom) {
  const ViewScene scene = scene_of(walled_plate());
  const Camera slanted{{30, -40, 20}, {0, 0, 0}};
  const Picture large = draw_depth(scene, slanted, {320, 240}, 1).picture;
  const Picture small = draw_depth(scene, slanted, {32, 24}, 1).picture;
  EXPECT_GT(count_near(large, palette::kGap, 40), 20U) << "ink of numbers";
  EXPECT_EQ(count_near(small, palette::kGap, 40), 0U);
}

TEST(RayPicture, TheKeyOfDepthNamesTheUnitOfTheScene) {
  Mesh plate = walled_plate();
  const Camera slanted{{30, -40, 20}, {0, 0, 0}};
  const Picture unknown = draw_depth(scene_of(plate), slanted, {320, 240}, 1).picture;
  plate.unit = 0.001;
  const ViewScene scene = scene_of(plate);
  EXPECT_EQ(scene.unit(), 0.001);
  const Picture millimeters = draw_depth(scene, slanted, {320, 240}, 1).picture;
  EXPECT_GT(count_near(millimeters, palette::kGap, 40), count_near(unknown, palette::kGap, 40));
}

TEST(RayPicture, AWallHidesWhatIsBehindIt) {
  const ViewScene scene = scene_of(walled_plate());
  const Vec3 observer{-5, 0, 2};
  const auto seen = [&](const Vec3& from, const Vec3& toward) {
    const std::vector<Ray> ray{{from, toward - from}};
    const std::vector<SurfaceHit> hit = scene.first_hits(ray);
    EXPECT_TRUE(hit[0].body.has_value());
    return seen_from(scene, observer, hit, ray)[0] != 0;
  };
  EXPECT_TRUE(seen({-5, 5, 50}, {-5, 5, 0})) << "the plate on this side";
  EXPECT_FALSE(seen({5, 5, 50}, {5, 5, 0})) << "the plate behind the wall";
  EXPECT_TRUE(seen({-50, 1, 5}, {0, 1, 5})) << "the wall";
  EXPECT_FALSE(seen({50, 1, 5}, {0, 1, 5})) << "the wall's back";
  EXPECT_FALSE(seen({0, 1, 50}, {0, 1, 9})) << "the wall's top";
  EXPECT_FALSE(seen({-5, 0, -50}, {-5, 0, 0})) << "the plate's underside";
}

TEST(RayPicture, APointInThePlaneOfASurfaceDoesNotSeeIt) {
  const ViewScene scene = scene_of(test::soup_body(
      {{{0, 0, 0}, {100, 0, 0}, {100, 100, 0}}, {{0, 0, 0}, {100, 100, 0}, {0, 100, 0}}}));
  const std::vector<Ray> rays{{{80, 10, 9}, {0, 0, -1}}, {{10, 80, 9}, {0, 0, -1}}};
  const std::vector<SurfaceHit> hits = scene.first_hits(rays);
  for (const Vec3& observer : {Vec3{10, 50, 0}, Vec3{50, 50, 0}, Vec3{200, 50, 0}}) {
    EXPECT_EQ(seen_from(scene, observer, hits, rays), (std::vector<std::uint8_t>{0, 0}));
  }
  EXPECT_EQ(seen_from(scene, {10, 50, 1e-9}, hits, rays), (std::vector<std::uint8_t>{1, 1}));
}

TEST(SightMap, OfASmallModelIsAsFine) {
  const auto map_of = [](double size) {
    return draw_sight_map(scene_of(test::box_body({0, 0, 0}, {size, size, size})),
                          {size / 2, size / 2, 2 * size});
  };
  const SightMap large = map_of(1024);
  const SightMap small = map_of(0x1p-10);
  EXPECT_EQ(small.surface, large.surface);
  EXPECT_EQ(small.in_sight, large.in_sight);
  EXPECT_EQ(small.surface, small.in_sight);
  EXPECT_GT(small.surface, 500'000U);
}

TEST(RayPicture, TheBackOfASheetIsNotSeen) {
  const ViewScene scene = scene_of(test::soup_body({{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}}));
  const std::vector<Ray> rays{
      {{0, 0, 5}, {0, 0, -1}}, {{0, 0, -5}, {0, 0, 1}}, {{50, 0, 5}, {0, 0, -1}}};
  const std::vector<SurfaceHit> hits = scene.first_hits(rays);
  EXPECT_EQ(seen_from(scene, {1, 1, 3}, hits, rays), (std::vector<std::uint8_t>{1, 0, 0}));
  EXPECT_EQ(seen_from(scene, {1, 1, -3}, hits, rays), (std::vector<std::uint8_t>{0, 1, 0}));
}

TEST(RayPicture, ColorsWhatIsInSightAndMarksThePoint) {
  const ViewScene scene = scene_of(walled_plate());
  const SightPicture drawn = draw_sight(scene, kAbove, {-5, 0, 2}, {96, 96}, 1);
  EXPECT_GT(drawn.surface, 4000U);
  const double share = static_cast<double>(drawn.in_sight) / static_cast<double>(drawn.surface);
  EXPECT_NEAR(share, 0.5, 0.03);
  const auto is_orange = [](Color c) { return c.r > c.b + 60; };
  EXPECT_TRUE(is_orange(drawn.picture.at(20, 20)));
  EXPECT_FALSE(is_orange(drawn.picture.at(75, 20)));
  EXPECT_GT(count_near(drawn.picture, palette::kBlue, 8), 20U);
}

TEST(RayPicture, AHiddenPointIsARing) {
  const ViewScene scene = scene_of(walled_plate());
  const auto blue = [&](const Vec3& observer) {
    return count_near(draw_sight(scene, kAbove, observer, {192, 192}, 1).picture, palette::kBlue,
                      8);
  };
  EXPECT_GT(blue({-5, 0, 2}), blue({-5, 0, -5}) + 5) << "below the plate";
  EXPECT_GT(blue({-5, 0, -5}), 5U);
}

TEST(RayPicture, IsTheSameForAnyNumberOfThreads) {
  const ViewScene scene = scene_of(walled_plate());
  const Camera slanted{{30, -40, 20}, {0, 0, 0}};
  EXPECT_EQ(draw_sight(scene, slanted, {-5, 0, 2}, {80, 60}, 4).picture,
            draw_sight(scene, slanted, {-5, 0, 2}, {80, 60}, 4, {.threads = 2}).picture);
  EXPECT_EQ(draw_depth(scene, slanted, {80, 60}, 3).picture,
            draw_depth(scene, slanted, {80, 60}, 3, {.threads = 2}).picture);
}

TEST(SightMap, CountsTheCellsInSight) {
  Mesh plate_in_millimeters = walled_plate();
  plate_in_millimeters.unit = 0.001;
  const ViewScene scene = scene_of(plate_in_millimeters);
  const SightMap map = draw_sight_map(scene, {-5, 0, 2});
  const double plate = 400 / (map.cell * map.cell);
  EXPECT_NEAR(static_cast<double>(map.surface), plate, 0.01 * plate);
  // The half before the wall, but for the half of the wall's top that is too high to be seen.
  EXPECT_NEAR(static_cast<double>(map.in_sight), (9.875 * 20) / 400 * plate, 0.01 * plate);
  EXPECT_NE(map.svg.find("% is in sight"), std::string::npos);
  EXPECT_NE(map.svg.find("(-5, 0, 2)"), std::string::npos);
  EXPECT_NE(map.svg.find("ground in sight"), std::string::npos);
  EXPECT_NE(map.svg.find("ground, hidden"), std::string::npos);
  EXPECT_NE(map.svg.find(">2 mm</text>"), std::string::npos) << "the scale bar";
  EXPECT_TRUE(map.svg.ends_with("</svg>\n"));
  EXPECT_LT(map.svg.size(), 500'000U);
}

TEST(SightMap, OfNothingSaysSo) {
  const SightMap map = draw_sight_map(ViewScene(SceneContent{}), {1, 2, 3});
  EXPECT_EQ(map.surface, 0U);
  EXPECT_NE(map.svg.find("Nothing is there"), std::string::npos);
  EXPECT_NE(map.svg.find(" units</text>"), std::string::npos);
}

/// A folder with the plate, and the program. Rays need no driver, so nothing is skipped.
class RayPictureVerb : public testing::Test {
 protected:
  void SetUp() override {
    plate_ = (folder_.path() / "plate.ply").string();
    write_mesh(plate_, walled_plate(), MeshFormat::ply);
  }

  [[nodiscard]] std::string path(const char* name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] test::RunResult render(std::vector<std::string> words) const {
    words.insert(words.begin(), {SOMS_VIEW_COMMAND, "render", plate_});
    return test::run_program(words);
  }

  test::TemporaryFolder folder_;
  std::string plate_;
};

TEST_F(RayPictureVerb, WritesBothPicturesAndTheMap) {
  test::RunResult run = render({"--depth", "-o", path("depth.png"), "--size", "64x48", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("\"device\":\"rays\""), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\"nearest\":"), std::string::npos);
  EXPECT_NE(run.out.find("\"unit\":\"units\""), std::string::npos);
  EXPECT_EQ(read_png(path("depth.png")).size, (Size{64, 48}));
  run = render({"--visible-from", "-5, 0 2", "-o", path("sight.png"), "--size", "64x48"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("orange is in sight of (-5, 0, 2)"), std::string::npos) << run.err;
  EXPECT_EQ(read_png(path("sight.png")).size, (Size{64, 48}));
  run = render({"--visible-from", "-5,0,2", "-o", path("sight.svg"), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("\"cells_in_sight\":"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("\"width\""), std::string::npos) << "a map has cells, not pixels";
}

TEST_F(RayPictureVerb, LeavesOutPartsBeforeItDraws) {
  Mesh parted = walled_plate();
  const auto plate =
      static_cast<std::uint32_t>(test::box_body({-10, -10, -1}, {10, 10, 0}).triangles.size());
  const auto all = static_cast<std::uint32_t>(parted.triangles.size());
  parted.parts = {{.name = "plate", .first = 0, .count = plate},
                  {.name = "wall", .first = plate, .count = all - plate}};
  write_mesh(path("parted.obj"), parted, MeshFormat::obj);
  write_mesh(path("rest.ply"), test::box_body({-10, -10, -1}, {10, 10, 0}), MeshFormat::ply);
  const auto draw = [&](const std::string& model, std::vector<std::string> words) {
    words.insert(words.begin(), {SOMS_VIEW_COMMAND, "render", path(model.c_str()), "--depth",
                                 "--up", "z", "--size", "64x48", "--camera", "top"});
    return test::run_program(words);
  };
  ASSERT_EQ(draw("rest.ply", {"-o", path("rest.png")}).status, 0);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--only", "plate"}, {"--ignore", "w*"}}) {
    std::vector<std::string> all_words = words;
    all_words.insert(all_words.end(), {"-o", path("left.png")});
    const test::RunResult run = draw("parted.obj", all_words);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find(" leaves 12 of 24 triangles"), std::string::npos) << run.err;
    EXPECT_EQ(read_png(path("left.png")), read_png(path("rest.png"))) << words[0];
  }
  ASSERT_EQ(draw("parted.obj", {"-o", path("whole.png")}).status, 0);
  EXPECT_NE(read_png(path("whole.png")), read_png(path("rest.png")));
  EXPECT_EQ(draw("parted.obj", {"--only", "palte", "-o", path("a.png")}).status, 2);
}

TEST_F(RayPictureVerb, RefusesWhatMakesNoSense) {
  const auto fails = [&](std::vector<std::string> words, const std::string& with) {
    const test::RunResult run = render(std::move(words));
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_NE(run.err.find(with), std::string::npos) << run.err;
  };
  fails({"--depth", "--visible-from", "1,2,3", "-o", path("a.png")}, "two pictures");
  fails({"--depth", "-o", path("a.svg")}, "only --visible-from");
  fails({"-o", path("a.svg")}, "only --visible-from");
  fails({"--visible-from", "1,2", "-o", path("a.png")}, "three numbers");
  fails({"--visible-from", "1,2,x", "-o", path("a.png")}, "--visible-from");
  fails({"--depth", "--edges", "-o", path("a.png")}, "--edges has no effect with --depth");
  fails({"--visible-from", "1,2,3", "--size", "9x9", "-o", path("a.svg")},
        "--size has no effect with a map");
  // A remedy must not name what is refused in turn, as --level is.
  for (const std::string mode : {"--depth", "--visible-from=1,2,3"}) {
    const std::string named = mode.substr(0, mode.find('='));
    for (const std::string tree : {"--tree=leaf=1", "--tree=traversal=larger", "--thesis"}) {
      fails({mode, tree, "-o", path("a.png")}, " has no effect with " + named + "; leave it out");
    }
  }
}

}  // namespace
}  // namespace soms::view
