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
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
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

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Whether a color is another one in less light.
bool is_shade_of(Color shown, Color color) {
  for (int k = 600; k <= 1000; ++k) {
    if (look::lit(color, k / 1000.0) == shown) {
      return true;
    }
  }
  return false;
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
  EXPECT_TRUE(is_shade_of(drawn.picture.at(4, 4), ordered_color(0)));
  EXPECT_TRUE(is_shade_of(drawn.picture.at(0, 0), ordered_color(1)));
  EXPECT_TRUE(is_shade_of(drawn.picture.at(8, 8), ordered_color(1)));
}

TEST(RayPicture, DepthShowsShapes) {
  // Two faces of a box at about one distance, which color alone would not tell apart.
  const ViewScene scene = scene_of(test::box_body({-10, -10, -10}, {10, 10, 10}));
  const Picture drawn =
      draw_depth(scene, {{300, -300, 0}, {0, 0, 0}, {0, 0, 1}, 0.08}, {40, 20}, 1).picture;
  const Color left = drawn.at(17, 10);
  const Color right = drawn.at(23, 10);
  EXPECT_GT(std::abs(left.r + left.g + left.b - right.r - right.g - right.b), 30);
}

TEST(RayPicture, DepthsAndSightsAreNumbersByPixel) {
  const ViewScene scene = scene_of(walled_plate());
  const std::vector<double> depths = depths_of(scene, kAbove, {41, 41});
  ASSERT_EQ(depths.size(), 41U * 41U);
  EXPECT_TRUE(std::isnan(depths[0])) << "beside the plate";
  EXPECT_EQ(depths[20 * 41 + 20], 90) << "the wall's top";
  const std::vector<std::uint8_t> cells = sight_cells(scene, kAbove, {-5, 0, 2}, {41, 41});
  EXPECT_EQ(cells[0], kEmptyCell);
  EXPECT_EQ(cells[20 * 41 + 12], kSeenCell) << "the plate on this side of the wall";
  EXPECT_EQ(cells[20 * 41 + 28], kHiddenCell) << "the plate behind it";
}

TEST(SightMap, AsAGridHasItsPlaceAndTheSameCells) {
  const Mesh plate = walled_plate();
  const Vec3 observer{-5, 0, 2};
  const SightMap grid = sight_grid(scene_of(plate), observer);
  const SightMap map = draw_sight_map(scene_of(plate), observer);
  EXPECT_EQ(grid.in_sight, map.in_sight);
  EXPECT_EQ(grid.surface, map.surface);
  std::istringstream in(grid.text);
  std::map<std::string, double> head;
  for (int k = 0; k < 6; ++k) {
    std::string name;
    in >> name >> head[name];
  }
  EXPECT_EQ(head["cellsize"], map.cell);
  EXPECT_EQ(head["NODATA_value"], -9999);
  // The wall is at x = 0: cells west of it are seen, those east of it are not.
  std::uint64_t seen = 0;
  std::uint64_t surface = 0;
  const auto columns = static_cast<std::size_t>(head["ncols"]);
  const auto rows = static_cast<std::size_t>(head["nrows"]);
  for (std::size_t k = 0; k < columns * rows; ++k) {
    double value = 0;
    ASSERT_TRUE(in >> value) << k;
    const double x =
        head["xllcorner"] + (static_cast<double>(k % columns) + 0.5) * head["cellsize"];
    seen += value == 1 ? 1 : 0;
    surface += value >= 0 ? 1 : 0;
    EXPECT_FALSE(value == 1 && x > 0.2) << "seen behind the wall, at x " << x;
    EXPECT_FALSE(value == 0 && x < -0.2) << "hidden before the wall, at x " << x;
  }
  EXPECT_EQ(seen, grid.in_sight);
  EXPECT_EQ(surface, grid.surface);
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
  EXPECT_EQ(count_near(small, palette::kGap, 8), 0U);
}

TEST(RayPicture, TheKeyOfDepthNamesTheUnitOfTheScene) {
  Mesh plate = walled_plate();
  const Camera slanted{{30, -40, 20}, {0, 0, 0}};
  const Picture unknown = draw_depth(scene_of(plate), slanted, {320, 240}, 1).picture;
  plate.unit = 0.001;
  const ViewScene scene = scene_of(plate);
  EXPECT_EQ(scene.unit(), 0.001);
  const Picture millimeters = draw_depth(scene, slanted, {320, 240}, 1).picture;
  EXPECT_NE(millimeters, unknown) << "distance in mm, and: unit unknown";
  EXPECT_GT(count_near(unknown, palette::kGap, 40), 100U) << "which takes many letters";
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
  EXPECT_NE(map.text.find("% is in sight"), std::string::npos);
  EXPECT_NE(map.text.find("(-5, 0, 2)"), std::string::npos);
  EXPECT_NE(map.text.find("ground in sight"), std::string::npos);
  EXPECT_NE(map.text.find("ground, hidden"), std::string::npos);
  EXPECT_NE(map.text.find(">2 mm</text>"), std::string::npos) << "the scale bar";
  EXPECT_TRUE(map.text.ends_with("</svg>\n"));
  EXPECT_LT(map.text.size(), 500'000U);
}

TEST(SightMap, OfNothingSaysSo) {
  const SightMap map = draw_sight_map(ViewScene(SceneContent{}), {1, 2, 3});
  EXPECT_EQ(map.surface, 0U);
  EXPECT_NE(map.text.find("Nothing is there"), std::string::npos);
  EXPECT_NE(map.text.find(" units</text>"), std::string::npos);
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

TEST_F(RayPictureVerb, WritesArraysAndGrids) {
  test::RunResult run = render({"--depth", "-o", path("depth.npy"), "--size", "64x48", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("\"nearest\":"), std::string::npos) << run.out;
  const std::string depth = bytes_of(path("depth.npy"));
  EXPECT_TRUE(depth.starts_with("\x93NUMPY")) << depth.size();
  EXPECT_NE(depth.find("'descr': '<f8', 'fortran_order': False, 'shape': (48, 64), "),
            std::string::npos);
  EXPECT_EQ(depth.size() % 64, 0U);
  EXPECT_EQ(depth.size() - depth.find('\n') - 1, 64U * 48U * 8U);
  run = render({"--visible-from", "-5,0,2", "-o", path("sight.npy"), "--size", "64x48"});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string sight = bytes_of(path("sight.npy"));
  EXPECT_NE(sight.find("'|u1'"), std::string::npos);
  EXPECT_EQ(sight.size() - sight.find('\n') - 1, 64U * 48U);
  run = render({"--visible-from", "-5,0,2", "-o", path("sight.asc"), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("\"cells_in_sight\":"), std::string::npos) << run.out;
  EXPECT_TRUE(bytes_of(path("sight.asc")).starts_with("ncols "));
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
  fails({"--depth", "-o", path("a.asc")}, "seen from an eye");
  fails({"--depth", "--samples", "2", "-o", path("a.npy")}, "one ray for each pixel");
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
