#include "soms/tiles/cut_tiles.h"

#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/geometry/parts_of.h"
#include "soms/geometry/print.h"
#include "soms/store/tree_file.h"

#include "tests/support/support.h"
#include "tests/tiles/tiled_twin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::kind_of;

Mesh city_of(std::size_t triangles) {
  return generate_city({.triangles = triangles, .size = 600}).mesh;
}

/// The name of the part that holds each triangle.
std::vector<std::string> names_of(const Mesh& mesh) {
  const PartsOf parts(mesh);
  std::vector<std::string> names;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t part = first_run(mesh, parts(i));
    names.push_back(part == Part::kNoParent ? "" : mesh.parts[part].name);
  }
  return names;
}

TEST(CutMesh, PutsEachTriangleIntoOneTileOfTheSizeThatIsAllowed) {
  for (const std::size_t most : {1UL, 7UL, 100UL, 1000UL, 3000UL, 100000UL}) {
    for (const Mesh& mesh : {city_of(3000), generate_sphere(500), Mesh{}}) {
      std::vector<int> met(mesh.triangles.size());
      for (const TileCut& cut : cut_mesh(mesh, most)) {
        EXPECT_FALSE(cut.triangles.empty());
        EXPECT_LE(cut.triangles.size(), most);
        EXPECT_TRUE(std::is_sorted(cut.triangles.begin(), cut.triangles.end()));
        for (const TriangleId i : cut.triangles) {
          ++met[i];
        }
      }
      EXPECT_EQ(met, std::vector<int>(mesh.triangles.size(), 1));
    }
  }
}

TEST(CutMesh, KeepsPartsWholeThatFit) {
  const Mesh mesh = city_of(3000);
  const std::size_t most = 400;
  const PartsOf parts(mesh);
  std::map<std::uint32_t, std::size_t> sizes;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    ++sizes[first_run(mesh, parts(i))];
  }
  std::map<std::uint32_t, std::set<std::size_t>> tiles;
  const std::vector<TileCut> cuts = cut_mesh(mesh, most);
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    bool splits = false;
    for (const TriangleId i : cuts[k].triangles) {
      tiles[first_run(mesh, parts(i))].insert(k);
      splits = splits || sizes[first_run(mesh, parts(i))] > most;
    }
    EXPECT_EQ(cuts[k].splits_part, splits);
  }
  EXPECT_GT(cuts.size(), 6U);
  for (const auto& [part, of] : tiles) {
    EXPECT_TRUE(of.size() == 1 || sizes[part] > most) << mesh.parts[part].name;
  }
}

TEST(CutMesh, CutsAThousandTrianglesInOnePlaceAndFarOut) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0x1p300, 0, 0}, {0x1p300, 0, 0}};
  mesh.triangles.assign(1000, {0, 1, 2});
  mesh.triangles.push_back({3, 4, 2});
  std::size_t triangles = 0;
  for (const TileCut& cut : cut_mesh(mesh, 10)) {
    triangles += cut.triangles.size();
    EXPECT_LE(cut.triangles.size(), 10U);
  }
  EXPECT_EQ(triangles, 1001U);
}

TEST(ExtractMesh, KeepsCornersFacesAndParts) {
  Mesh mesh = city_of(2000);
  mesh.unit = 0.3048;
  mesh.georeference.crs = "EPSG:25833";
  test::for_each_case("extract", 20, [&](Rng& rng) {
    std::vector<TriangleId> some;
    for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
      if (rng.below(4) == 0) {
        some.push_back(i);
      }
    }
    const Mesh tile = extract(mesh, some);
    check(tile);
    ASSERT_EQ(tile.triangles.size(), some.size());
    const std::vector<std::string> names = names_of(mesh);
    const std::vector<std::string> own = names_of(tile);
    for (std::size_t k = 0; k < some.size(); ++k) {
      EXPECT_EQ(tile.triangle(static_cast<TriangleId>(k)), mesh.triangle(some[k]));
      EXPECT_EQ(tile.faces[k], some[k]);
      EXPECT_EQ(own[k], names[some[k]]);
    }
    EXPECT_EQ(tile.unit, mesh.unit);
    EXPECT_EQ(tile.georeference, mesh.georeference);
  });
}

TEST(ExtractMesh, NamesAnObjectWhoseFirstRunIsElsewhere) {
  Mesh mesh = generate_sphere(20);
  mesh.parts = {{"house", Part::kNoParent, 0, 5},
                {"tree", Part::kNoParent, 5, 5},
                {"", Part::kNoParent, 10, 5, "", "", {}, 0},
                {"", 1, 15, 5, "", "", {}, 0}};
  mesh.parts[0].id = "h1";
  std::vector<TriangleId> late;
  for (TriangleId i = 7; i < 20; ++i) {
    late.push_back(i);
  }
  const Mesh tile = extract(mesh, late);
  check(tile);
  ASSERT_EQ(tile.parts.size(), 3U);
  EXPECT_EQ(tile.parts[1].name, "house");
  EXPECT_EQ(tile.parts[1].id, "h1");
  EXPECT_EQ(tile.parts[1].continues, Part::kNoParent);
  EXPECT_EQ(tile.parts[2].continues, 1U);
  EXPECT_EQ(tile.parts[2].parent, 0U);
}

TEST(TileCutter, GoesOnWhereItEnded) {
  const test::TemporaryFolder folder;
  const std::vector<Mesh> meshes{test::unstated(city_of(2000)),
                                 test::unstated(generate_sphere(300)),
                                 test::unstated(city_of(1000))};
  const CutOptions options{.most = 300};
  const TileSet first = test::tiles_of(folder.path(), meshes, options);
  std::map<std::string, std::filesystem::file_time_type> times;
  for (const Tile& tile : first.tiles()) {
    times[tile.file] = std::filesystem::last_write_time(folder.path() / tile.file);
  }
  // A tile of the second model is lost.
  for (const Tile& tile : first.tiles()) {
    if (tile.source == 1) {
      std::filesystem::remove(folder.path() / tile.file);
    }
  }
  std::filesystem::remove(folder.path() / kTileManifest);
  TileCutter cutter(folder.path(), options);
  std::vector<bool> cut;
  for (const Mesh& mesh : meshes) {
    cut.push_back(cutter.add(mesh));
  }
  cutter.finish();
  EXPECT_EQ(cut, (std::vector<bool>{false, true, false}));
  const TileSet again = TileSet::open(folder.path());
  EXPECT_EQ(again.manifest(), first.manifest());
  EXPECT_EQ(again.hash(), first.hash());
  EXPECT_EQ(std::filesystem::last_write_time(folder.path() / first.tiles()[0].file),
            times[first.tiles()[0].file]);
}

TEST(TileCutter, CutsAgainWhatIsDamaged) {
  const test::TemporaryFolder folder;
  const std::vector<Mesh> meshes{city_of(1000)};
  const TileSet first = test::tiles_of(folder.path(), meshes, {.most = 300});
  for (const std::string& file : {first.tiles()[1].file, first.tiles()[1].ids}) {
    std::fstream bytes(folder.path() / file, std::ios::binary | std::ios::in | std::ios::out);
    bytes.seekp(static_cast<std::streamoff>(std::filesystem::file_size(folder.path() / file) / 2));
    bytes.put('#');
    bytes.close();
    EXPECT_EQ(kind_of([&] { verify_tiles(folder.path()); }), ErrorKind::bad_file) << file;
    TileCutter cutter(folder.path(), {.most = 300});
    EXPECT_TRUE(cutter.add(meshes[0]));
    cutter.finish();
    verify_tiles(folder.path());
  }
}

TEST(TileCutter, KeepsWhatAnotherRunCut) {
  const test::TemporaryFolder folder;
  const std::vector<Mesh> meshes{city_of(1000), city_of(1400)};
  const TileSet first = test::tiles_of(folder.path(), meshes, {.most = 300});
  Mesh stated = meshes[0];
  stated.georeference.crs = "EPSG:25833";
  Mesh parted = meshes[0];
  parted.parts.resize(1);
  const std::vector<std::pair<Mesh, CutOptions>> others{
      {meshes[1], {.most = 300}},
      {meshes[0], {.most = 301}},
      {meshes[0], {.most = 300, .shape = {.layout = Layout::compact}}},
      {meshes[0], {.most = 300, .shape = {.build = {.per_leaf = 4}}}},
      {stated, {.most = 300}},
      {parted, {.most = 300}}};
  for (const auto& other : others) {
    EXPECT_EQ(kind_of([&] { TileCutter(folder.path(), other.second).add(other.first); }),
              ErrorKind::usage);
  }
  TileCutter fewer(folder.path(), {.most = 300});
  EXPECT_FALSE(fewer.add(meshes[0]));
  EXPECT_EQ(kind_of([&] { fewer.finish(); }), ErrorKind::usage);
  // Nor where the receipt in between is lost.
  const test::TemporaryFolder gap;
  static_cast<void>(test::tiles_of(gap.path(), std::vector<Mesh>{meshes[0], meshes[1], meshes[0]},
                                   {.most = 300}));
  std::filesystem::remove(gap.path() / "source-000001.json");
  TileCutter one(gap.path(), {.most = 300});
  EXPECT_FALSE(one.add(meshes[0]));
  EXPECT_EQ(kind_of([&] { one.finish(); }), ErrorKind::usage);
  verify_tiles(gap.path());
  verify_tiles(folder.path());
  EXPECT_EQ(TileSet::open(folder.path()).manifest(), first.manifest());
  // More models come behind those that are there.
  TileCutter more(folder.path(), {.most = 300});
  EXPECT_FALSE(more.add(meshes[0]));
  EXPECT_FALSE(more.add(meshes[1]));
  EXPECT_TRUE(more.add(meshes[0]));
  more.finish();
  verify_tiles(folder.path());
  EXPECT_EQ(TileSet::open(folder.path()).triangles(), 3400U);
}

TEST(TileCutter, RemovesTilesOfARunThatEndedAndNothingElse) {
  const test::TemporaryFolder folder;
  for (const char* const name : {"tile-000900.somst", "tile-000900.npy"}) {
    std::ofstream(folder.path() / name) << "half";
  }
  const TileSet set =
      test::tiles_of(folder.path(), std::vector<Mesh>{city_of(1000)}, {.most = 300});
  const auto files = std::distance(std::filesystem::directory_iterator(folder.path()), {});
  EXPECT_EQ(static_cast<std::size_t>(files), 2 * set.tiles().size() + 2);
  for (const char* const name : {"tile-north.ply", "tile-notes.txt", "source-model.obj",
                                 "tile-00001.npy", "tile-000001.somst.bak"}) {
    const std::filesystem::path path = folder.path() / name;
    std::ofstream(path) << "mine";
    EXPECT_EQ(kind_of([&] { TileCutter(folder.path(), {}); }), ErrorKind::usage) << name;
    EXPECT_TRUE(std::filesystem::exists(path)) << name;
    std::filesystem::remove(path);
  }
  std::filesystem::create_directory(folder.path() / "tile-000901.npy");
  EXPECT_EQ(kind_of([&] { TileCutter(folder.path(), {}); }), ErrorKind::cannot_write);
}

TEST(TileCutter, WritesTheSameBytesForAnyThreads) {
  const test::TemporaryFolder a;
  const test::TemporaryFolder b;
  const Mesh mesh = city_of(2000);
  for (const auto& [path, threads] : {std::pair(a.path(), 1), std::pair(b.path(), 4)}) {
    TileCutter cutter(path, {.most = 300});
    cutter.add(mesh, {.threads = threads});
    cutter.finish();
  }
  EXPECT_EQ(TileSet::open(a.path()).hash(), TileSet::open(b.path()).hash());
}

TEST(TileCutter, RefusesWhatDoesNotGoTogether) {
  const test::TemporaryFolder folder;
  TileCutter cutter(folder.path() / "tiles", {.most = 100});
  Mesh mesh = generate_sphere(50);
  cutter.add(mesh);
  mesh.unit = 0.001;
  EXPECT_EQ(kind_of([&] { cutter.add(mesh); }), ErrorKind::usage);
  mesh.unit = 0;
  mesh.up = UpAxis::y;
  EXPECT_EQ(kind_of([&] { cutter.add(mesh); }), ErrorKind::usage);
  mesh.up = UpAxis::unknown;
  mesh.georeference.crs = "EPSG:25833";
  EXPECT_EQ(kind_of([&] { cutter.add(mesh); }), ErrorKind::usage);
  EXPECT_EQ(kind_of([&] { TileCutter(folder.path(), {.most = 0}); }), ErrorKind::usage);
  std::ofstream(folder.path() / "notes.txt") << "mine";
  EXPECT_EQ(kind_of([&] { TileCutter(folder.path(), {}); }), ErrorKind::usage);
  EXPECT_EQ(kind_of([&] { TileCutter(folder.path() / "notes.txt", {}); }), ErrorKind::cannot_write);
}

}  // namespace
}  // namespace soms
