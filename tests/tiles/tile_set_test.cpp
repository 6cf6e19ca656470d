#include "soms/tiles/tile_set.h"

#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"
#include "tests/tiles/tiled_twin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::kind_of;
using test::tiles_of;
using test::whole_of;

Mesh point_at(const Vec3& at) {
  return test::soup_body({{at, at, at}});
}

/// Tiles of every size answer as the whole.
void expect_union(Rng& rng, const std::vector<Mesh>& meshes, const Shape& mover, const Pose& pose,
                  std::size_t rows) {
  const Body whole(Shape(whole_of(meshes)), pose);
  test::TiledQuestions questions = test::random_questions(rng, mover, whole.shape.bounds(), rows);
  const std::size_t all = std::max<std::size_t>(whole.shape.mesh().triangles.size(), 1);
  for (const std::size_t most : {std::size_t{1}, all / 40 + 1, all / 5 + 1, all}) {
    const test::TemporaryFolder folder;
    const TileSet tiles = tiles_of(folder.path(), meshes, {.most = most});
    EXPECT_EQ(tiles.triangles(), whole.shape.mesh().triangles.size());
    EXPECT_EQ(tiles.bounds(), whole.shape.bounds());
    EXPECT_EQ(difference(questions, {tiles, pose}, whole), "") << "tiles of " << most;
  }
}

TEST(TileSet, AnswersAsTheWholeInCities) {
  test::for_each_case("tiled cities", 3, [](Rng& rng) {
    const Mesh city = generate_city({.triangles = 1500 + rng.below(1000), .size = 400}).mesh;
    expect_union(rng, {test::unstated(city), test::unstated(generate_sphere(100))},
                 Shape(generate_mover(MoverKind::car)), {}, 60);
  });
}

TEST(TileSet, AnswersAsTheWholeWhereItIsMoved) {
  test::for_each_case("moved tiles", 3, [](Rng& rng) {
    const Mesh city = generate_city({.triangles = 1000, .size = 200}).mesh;
    const Pose pose = Pose::about_z(rng.uniform(0, 6), {rng.uniform(-30, 30), 5, 1});
    expect_union(rng, {city}, Shape(generate_sphere(80)), pose, 40);
  });
}

// A mover that is larger than every tile, and a triangle across everything.
TEST(TileSet, AnswersAsTheWholeBesideLargeThings) {
  test::for_each_case("large movers", 3, [](Rng& rng) {
    std::vector<Mesh> meshes{
        test::mapped(test::unstated(generate_sphere(200)), [](const Vec3& v) { return 5.0 * v; }),
        test::soup_body({{{-100, -90, -80}, {100, 95, 70}, {-90, 100, 3}}})};
    const Shape mover(test::mapped(generate_sphere(60), [](const Vec3& v) { return 8.0 * v; }));
    expect_union(rng, meshes, mover, {}, 30);
  });
}

// Rays through shared edges and corners, points above them, movers that touch them.
TEST(TileSet, AnswersAsTheWholeOnEdgesBetweenTiles) {
  const std::vector<Mesh> meshes{test::box_body({0, 0, 0}, {8, 8, 8}, 4)};
  const Body whole{Shape(meshes[0])};
  test::TiledQuestions q{.mover = Shape(test::box_body({0, 0, 0}, {2, 2, 2})), .at_most = 2};
  for (int x = -1; x <= 9; ++x) {
    for (int y = -1; y <= 9; ++y) {
      const Vec3 at{static_cast<double>(x), static_cast<double>(y), 10};
      q.poses.push_back(Pose::translation(at.x, at.y, at.x == 0 ? 8.0 : 9.0));
      q.points.push_back(at);
      q.rays.push_back({at, {0, 0, -1}});
      q.rays.push_back({at, {-at.x, -at.y, -10}});
      q.segments.push_back(Ray::between(at, {4, 4, 4}));
    }
  }
  for (const std::size_t most : {1UL, 2UL, 5UL, 50UL}) {
    const test::TemporaryFolder folder;
    const TileSet tiles = tiles_of(folder.path(), meshes, {.most = most});
    EXPECT_EQ(difference(q, {tiles}, whole), "") << most;
  }
}

// sqrt(2 + 2^-60) and sqrt(2) have one bracket: it does not say which tile is nearer.
TEST(TileSet, DecidesTiesOfBracketsExactly) {
  const std::vector<Mesh> meshes{point_at({1, 1, 0x1p-30}), point_at({1, 1, 0})};
  const Body whole{Shape(whole_of(meshes))};
  const test::TemporaryFolder folder;
  const TileSet tiles = tiles_of(folder.path(), meshes, {.most = 1});
  test::TiledQuestions q{.mover = Shape(point_at({0, 0, 0})), .at_most = 3};
  q.poses = {Pose{}};
  q.points = {{0, 0, 0}};
  ASSERT_EQ(tiles.tiles().size(), 2U);
  EXPECT_EQ(difference(q, {tiles}, whole), "");
  EXPECT_EQ(distance(q.mover, q.poses, TiledBody{tiles}).triangles[0], (TrianglePair{0, 1}));
  EXPECT_EQ(closest(TiledBody{tiles}, q.points).triangle[0], 1U);
}

// Equal distances go to the least number, whichever tile is met first.
TEST(TileSet, NamesTheLeastOfEquallyNearTriangles) {
  test::for_each_case("equal tiles", 20, [](Rng& rng) {
    std::vector<Triangle> triangles;
    for (int k = 0; k < 40; ++k) {
      const Vec3 at{rng.below(2) == 0 ? 1.0 : -1.0, rng.below(2) == 0 ? 1.0 : -1.0,
                    rng.below(2) == 0 ? 1.0 : -1.0};
      triangles.push_back({at, 2.0 * at, {at.x, 2 * at.y, 3 * at.z}});
    }
    const std::vector<Mesh> meshes{test::soup_body(triangles)};
    const test::TemporaryFolder folder;
    const TileSet tiles = tiles_of(folder.path(), meshes, {.most = 1 + rng.below(7)});
    test::TiledQuestions q{.mover = Shape(test::box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5})),
                           .at_most = 4};
    q.poses = {Pose{}, Pose::translation(1, 1, 1), Pose::translation(0.5, 0, 0)};
    q.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}};
    q.rays = {{{0, 0, 0}, {1, 1, 1}}, {{3, 3, 3}, {-1, -1, -1}}, {{1, 1, 0}, {0, 0, 1}}};
    q.segments = {Ray::between({0, 0, 0}, {2, 2, 2}), Ray::between({0, 0, 0}, {-2, 2, 2})};
    EXPECT_EQ(difference(q, {tiles}, Body{Shape(meshes[0])}), "");
  });
}

TEST(TileSet, AnswersWithoutTriangles) {
  const test::TemporaryFolder folder;
  const std::vector<Mesh> none{Mesh{}};
  const TileSet tiles = tiles_of(folder.path(), none, {});
  EXPECT_TRUE(tiles.tiles().empty());
  test::TiledQuestions q{.mover = Shape(generate_sphere(20)), .at_most = 1};
  q.poses = {Pose{}};
  q.points = {{0, 0, 0}};
  q.rays = {{{0, 0, 0}, {1, 0, 0}}};
  q.segments = {Ray::between({0, 0, 0}, {1, 0, 0})};
  EXPECT_EQ(difference(q, {tiles}, Body()), "");
  EXPECT_EQ(difference(q, {TileSet()}, Body()), "");
  // A model without triangles between others leaves no tile, and a mover without any meets nothing.
  const std::vector<Mesh> some{test::unstated(generate_sphere(40)), Mesh{},
                               test::unstated(generate_sphere(60))};
  const test::TemporaryFolder other;
  const TileSet three = tiles_of(other.path(), some, {.most = 20});
  EXPECT_EQ(three.manifest().sources[2].first, 40U);
  EXPECT_EQ(difference(q, {three}, Body{Shape(whole_of(some))}), "");
  q.mover = Shape();
  EXPECT_EQ(difference(q, {three}, Body{Shape(whole_of(some))}), "");
}

TEST(TileSet, KeepsWhatFitsOpen) {
  Rng rng(7);
  const std::vector<Mesh> meshes{generate_city({.triangles = 4000, .size = 400}).mesh};
  const Body whole{Shape(meshes[0])};
  const test::TemporaryFolder folder;
  const TileSet all = tiles_of(folder.path(), meshes, {.most = 100});
  const auto q =
      test::random_questions(rng, Shape(generate_mover(MoverKind::car)), whole.shape.bounds(), 200);
  EXPECT_EQ(difference(q, {all}, whole, {.threads = 4}), "");
  EXPECT_LE(all.openings(), all.tiles().size() * 4);  // at most once by each thread
  // Room for two tiles: all is answered alike, and what is met again is opened again.
  const TileSet few = TileSet::open(folder.path(), {.max_memory = all.bytes() / 30});
  EXPECT_EQ(difference(q, {few}, whole, {.threads = 4}), "");
  EXPECT_GT(few.openings(), all.openings());
  // Rows come tile by tile, so far fewer tiles are opened than there are rows and tiles that they
  // meet.
  const TileSet ordered = TileSet::open(folder.path(), {.max_memory = 1});
  static_cast<void>(closest(TiledBody{ordered}, q.points));
  EXPECT_LT(ordered.openings(), 3 * q.points.size());
}

TEST(TileSet, CutsAnswersWhenTimeIsUp) {
  const std::vector<Mesh> meshes{generate_city({.triangles = 2000, .size = 400}).mesh};
  const test::TemporaryFolder folder;
  const TiledBody tiles{tiles_of(folder.path(), meshes, {.most = 200})};
  const auto past = std::chrono::steady_clock::time_point::min();
  const Shape car(generate_mover(MoverKind::car));
  const std::vector<Pose> poses{Pose::translation(20, 20, 1), Pose::translation(1e4, 0, 0)};
  const DistanceBatch truth = distance(car, poses, Body{Shape(meshes[0])});
  const DistanceBatch cut = distance(car, poses, tiles, {}, {.deadline = past});
  const WithinBatch within_cut = within(car, poses, tiles, 1e5, {.deadline = past});
  for (std::size_t k = 0; k < 2; ++k) {
    if (cut.coverage[k] == Coverage::cut) {
      EXPECT_LE(cut.lower[k], truth.lower[k]);
      EXPECT_GE(cut.upper[k], truth.upper[k]);
    } else {
      EXPECT_EQ(cut.lower[k], truth.lower[k]);
    }
    if (within_cut.coverage[k] == Coverage::cut) {
      EXPECT_LE(within_cut.at_least[k], truth.lower[k]);
    }
  }
}

// A bound that is proved of one tile says nothing of those that are as near.
TEST(TileSet, WithinIsNoFartherThanTilesThatWereNotMet) {
  test::for_each_case("tiles/within cut", 200, [](Rng& rng) {
    const auto number = [&] { return rng.uniform(-9, 9); };
    std::vector<Triangle> triangles;
    for (int k = 0; k < 30; ++k) {
      const Vec3 at{number(), number(), number()};
      triangles.push_back({at, at + Vec3{1, 0, 0.2}, at + Vec3{0, 3, 1}});
    }
    const std::vector<Mesh> meshes{test::soup_body(triangles)};
    const test::TemporaryFolder folder;
    const TiledBody tiles{tiles_of(folder.path(), meshes, {.most = 1})};
    const Shape mover(test::soup_body({{{-5, -0.1, 0}, {5, 0, 0}, {-5, 0.1, 0}}}));
    const std::vector<Pose> poses{Pose::about_z(rng.uniform(0, 6), {number(), number(), 20})};
    const double truth = distance(mover, poses, Body{Shape(meshes[0])}).lower[0];
    for (const int steps : {0, 1, 4, 16, 64}) {
      // However many steps of the clock fit into it, the bound holds.
      const auto soon = std::chrono::steady_clock::now() + steps * std::chrono::microseconds(1);
      const WithinBatch cut = within(mover, poses, tiles, 100, {.deadline = soon});
      if (cut.coverage[0] == Coverage::cut) {
        EXPECT_LE(cut.at_least[0], truth);
      } else {
        EXPECT_TRUE(cut.within[0] != 0);
      }
    }
  });
}

TEST(TileSet, StopsAtTheDeadlineBeforeItOpensTiles) {
  const std::vector<Mesh> meshes{generate_city({.triangles = 2000, .size = 400}).mesh};
  const test::TemporaryFolder folder;
  const TiledBody tiles{tiles_of(folder.path(), meshes, {.most = 20})};
  const auto past = std::chrono::steady_clock::time_point::min();
  const Shape city(meshes[0]);
  const std::vector<Pose> poses(3);
  const std::vector<Vec3> points(3);
  const std::vector<Ray> rays(3, Ray{{0, 0, 90}, {0, 0, -1}});
  EXPECT_EQ(overlap(city, poses, tiles, {}, {.deadline = past}).coverage[1], Coverage::cut);
  EXPECT_EQ(distance(city, poses, tiles, {}, {.deadline = past}).coverage[1], Coverage::cut);
  EXPECT_EQ(within(city, poses, tiles, 1, {.deadline = past}).coverage[1], Coverage::cut);
  EXPECT_EQ(closest(tiles, points, {}, {.deadline = past}).coverage[1], Coverage::cut);
  EXPECT_EQ(closest_hit(tiles, rays, {}, {.deadline = past}).coverage[1], Coverage::cut);
  EXPECT_EQ(any_hit(tiles, rays, {}, {.deadline = past}).coverage[1], Coverage::cut);
  EXPECT_EQ(tiles.tiles.openings(), 0U);
}

TEST(TileSet, ReportsProgressThatOnlyGrows) {
  const std::vector<Mesh> meshes{generate_city({.triangles = 2000, .size = 400}).mesh};
  const test::TemporaryFolder folder;
  const TiledBody tiles{tiles_of(folder.path(), meshes, {.most = 100})};
  const std::vector<Pose> poses(500, Pose::translation(20, 20, 0));
  const std::vector<Ray> rays(500, Ray{{0, 0, 90}, {0, 0, -1}});
  std::vector<double> shares;
  const Limits limits{.progress = [&](double share) { shares.push_back(share); }};
  const auto check = [&] {
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_FALSE(shares.empty());
    shares.clear();
  };
  static_cast<void>(overlap(Shape(generate_sphere(20)), poses, tiles, {}, limits));
  check();
  static_cast<void>(closest_hit(tiles, rays, {}, limits));
  check();
  static_cast<void>(distance(Shape(generate_sphere(20)), poses, tiles, {}, limits));
  check();
}

// Cut again, a folder has other numbers in files of the same names.
TEST(TileSet, FindsThatItsFolderWasCutAgain) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "tiles";
  const Mesh a = test::unstated(generate_sphere(30));
  const Mesh b = test::mapped(test::unstated(generate_sphere(20)), [](const Vec3& v) {
    return v + Vec3{100, 100, 100};
  });
  const std::vector<Vec3> points{{100, 100, 103}, {0, 0, 3}};
  const TileSet set = tiles_of(path, std::vector<Mesh>{a, b}, {.most = 100}, {.max_memory = 0});
  const ClosestBatch before = closest(TiledBody{set}, points);
  std::filesystem::remove_all(path);
  static_cast<void>(
      tiles_of(path, std::vector<Mesh>{test::unstated(generate_sphere(60)), b}, {.most = 100}));
  EXPECT_EQ(kind_of([&] {
              static_cast<void>(closest(TiledBody{set}, points));
              static_cast<void>(closest(TiledBody{set}, points));
            }),
            ErrorKind::bad_file);
  EXPECT_GE(*before.triangle[0], 30U);
}

TEST(TileSet, StaysWhereItIsWhenTheProgramGoesElsewhere) {
  const test::TemporaryFolder folder;
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const TileSet set = tiles_of("tiles", std::vector<Mesh>{generate_sphere(30)}, {.most = 10});
  std::filesystem::current_path(here);
  EXPECT_EQ(set.folder(), "tiles");
  EXPECT_EQ(set.place(), folder.path() / "tiles");
  EXPECT_EQ(set.open_tile(0)->ids.size(), set.tiles()[0].triangles);
}

TEST(TileSet, ComparesByContentAndPrints) {
  const std::vector<Mesh> meshes{generate_sphere(100)};
  const test::TemporaryFolder a;
  const test::TemporaryFolder b;
  const TileSet tiles = tiles_of(a.path(), meshes, {.most = 30});
  EXPECT_EQ(tiles, tiles_of(b.path(), meshes, {.most = 30}));
  EXPECT_EQ(*tiles.open_tile(0), *TileSet::open(b.path()).open_tile(0));
  const test::TemporaryFolder c;
  EXPECT_NE(tiles, tiles_of(c.path(), meshes, {.most = 20}));
  Mesh renamed = meshes[0];
  renamed.source = "elsewhere/ball.ply";
  const test::TemporaryFolder d;
  EXPECT_EQ(tiles.hash() == tiles_of(d.path(), std::vector<Mesh>{renamed}, {.most = 30}).hash(),
            false);  // tree files state what they were built of
  std::ostringstream text;
  text << tiles << tiles.manifest() << CutOptions{} << TileCut{{1, 2}, true}
       << TileOptions{.max_memory = 7};
  EXPECT_NE(text.str().find("100 triangles"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("TileManifest{1 source, "), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("TileCut{2 triangles, splits_part: true}"), std::string::npos)
      << text.str();
  EXPECT_NE(text.str().find("TileOptions{max_memory: 7, check: sound}"), std::string::npos)
      << text.str();
}

TEST(TileSet, RefusesWhatItCannotAnswer) {
  const test::TemporaryFolder folder;
  const std::vector<Mesh> meshes{generate_sphere(100)};
  const TiledBody tiles{tiles_of(folder.path(), meshes, {.most = 30})};
  const Shape mover(generate_sphere(20));
  const std::vector<Pose> poses{Pose{}};
  const std::vector<Ray> rays{{{0, 0, 0}, {1, 0, 0}}};
  EXPECT_EQ(kind_of([&] { static_cast<void>(overlap(mover, poses, tiles, {.limit = 3})); }),
            ErrorKind::usage);
  EXPECT_EQ(kind_of([&] { static_cast<void>(closest_hit(tiles, rays, {.skip = 100})); }),
            ErrorKind::usage);
  EXPECT_EQ(kind_of([&] { static_cast<void>(within(mover, poses, tiles, -1)); }), ErrorKind::usage);
  Pose bent;
  bent.m[0] = 2;
  EXPECT_EQ(kind_of([&] { static_cast<void>(distance(mover, std::vector{bent}, tiles)); }),
            ErrorKind::not_rigid);
  EXPECT_EQ(kind_of([&] {
              static_cast<void>(distance(mover, poses, TiledBody{tiles.tiles, bent}));
            }),
            ErrorKind::not_rigid);
}

}  // namespace
}  // namespace soms
