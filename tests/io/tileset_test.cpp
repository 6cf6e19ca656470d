// Tilesets of 3D Tiles: trees of tiles made on the spot, each with one thing that matters.
#include "soms/base/text.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/io/tile_files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// A folder with a tileset and models of one triangle.
class TilesFolder {
 public:
  explicit TilesFolder(const std::string& tileset) {
    write("tileset.json", tileset);
    write("a.b3dm", b3dm_of({0}, 1, R"({"id":["one"]})"));
    write("b.b3dm", b3dm_of({0, 1}, 2));
    write("c.glb", numbered_glb({0}));
  }

  void write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((folder_.path() / name).parent_path());
    write_content(folder_.path() / name, content);
  }

  [[nodiscard]] Mesh read(const ReadOptions& options = {}) const {
    return read_mesh(folder_.path() / "tileset.json", options);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

Mesh read_tiles(const std::string& root) {
  return TilesFolder(tileset_of(root)).read();
}

void refuse_tiles(const std::string& root, ErrorKind kind, const std::string& words) {
  expect_refused([&] { static_cast<void>(read_tiles(root)); }, kind, words);
}

std::string children(const std::vector<std::string>& tiles) {
  std::string text = R"(,"children":[)";
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    text += (i == 0 ? "" : ",") + tiles[i];
  }
  return text + "]";
}

std::string moved(const std::string& x, const std::string& y, const std::string& z) {
  return R"(,"transform":[1,0,0,0,0,1,0,0,0,0,1,0,)" + x + "," + y + "," + z + ",1]";
}

TEST(Tileset, PutsEachContentIntoAPartNamedAsItsFile) {
  const Mesh mesh = read_tiles(tile_of("", children({tile_of("a.b3dm"), tile_of("b.b3dm")})));
  ASSERT_EQ(mesh.parts.size(), 5U);
  EXPECT_EQ(mesh.parts[0].name, "a.b3dm");
  EXPECT_EQ(mesh.parts[1].id, "one");
  EXPECT_EQ(mesh.parts[1].parent, 0U);
  EXPECT_EQ(mesh.parts[2].name, "b.b3dm");
  EXPECT_EQ(mesh.parts[2].count, 2U);
  EXPECT_EQ(mesh.parts[3].id, "0");
  EXPECT_EQ(mesh.parts[4].id, "1");
  EXPECT_EQ(mesh.parts[4].first, 2U);
  EXPECT_EQ(mesh.up, UpAxis::z);
  EXPECT_EQ(mesh.unit, 1);
  EXPECT_TRUE(mesh.notes.empty());
}

TEST(Tileset, NamesEqualIdsOfTwoTilesByTheirTiles) {
  const Mesh mesh =
      read_tiles(tile_of("b.b3dm", children({tile_of("b.b3dm")}) + R"(,"refine":"ADD")"));
  std::vector<std::string> ids;
  for (const Part& part : mesh.parts) {
    ids.push_back(part.id);
  }
  EXPECT_EQ(ids,
            (std::vector<std::string>{"", "b.b3dm/0", "b.b3dm/1", "", "b.b3dm/0#2", "b.b3dm/1#2"}));
}

TEST(Tileset, ComposesTransformsInDoubleFromTheOutsideIn) {
  // A quarter turn about z, columns first, around a shift.
  const std::string turn = R"(,"transform":[0,1,0,0,-1,0,0,0,0,0,1,0,4000000.1,5,6,1])";
  const Mesh mesh =
      read_tiles(tile_of("", turn + children({tile_of("c.glb", moved("0.25", "2", "3"))})));
  ASSERT_EQ(mesh.vertices.size(), 3U);
  EXPECT_EQ(mesh.vertices[0], (Vec3{4000000.1 - 2, 5.25, 9}));
  EXPECT_EQ(mesh.vertices[1], (Vec3{4000000.1 - 2, 6.25, 9}));
  EXPECT_EQ(mesh.vertices[2], (Vec3{4000000.1 - 2, 5.25, 10}));
}

TEST(Tileset, TurnsOutlinesOfMirroredTiles) {
  const std::string mirror = R"(,"transform":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])";
  const Mesh plain = read_tiles(tile_of("c.glb"));
  const Mesh mesh = read_tiles(tile_of("c.glb", mirror));
  EXPECT_EQ(mesh.triangle(0).b, plain.triangle(0).c);
  EXPECT_EQ(mesh.triangle(0).c.x, -plain.triangle(0).b.x);
}

TEST(Tileset, ReadsTheFinestTilesWhereTheyReplaceOthers) {
  const Mesh mesh = read_tiles(
      tile_of("b.b3dm", children({tile_of("a.b3dm"), tile_of("c.glb", children({tile_of("")}))})));
  EXPECT_EQ(mesh.triangles.size(), 2U);  // nothing replaces c.glb
  EXPECT_EQ(
      mesh.notes,
      (std::vector<std::string>{"contents of another level of detail, not read: 1, at root"}));
  const Mesh all = read_tiles(
      tile_of("b.b3dm", R"(,"refine":"ADD")" + children({tile_of("a.b3dm"), tile_of("c.glb")})));
  EXPECT_EQ(all.triangles.size(), 4U);
  EXPECT_TRUE(all.notes.empty());
  // Children inherit what they do not state.
  const Mesh inherited = read_tiles(tile_of(
      "b.b3dm",
      R"(,"refine":"ADD")" +
          children({tile_of("a.b3dm", children({tile_of("c.glb")})),
                    tile_of("a.b3dm", R"(,"refine":"REPLACE")" + children({tile_of("c.glb")}))})));
  EXPECT_EQ(inherited.triangles.size(), 5U);
}

TEST(Tileset, ReadsAllContentsOfATile) {
  EXPECT_EQ(
      read_tiles(tile_of("", R"(,"contents":[{"uri":"a.b3dm"},{"uri":"c.glb"}])")).triangles.size(),
      2U);
  EXPECT_EQ(read_tiles(tile_of("", R"(,"content":{"url":"c.glb"})")).triangles.size(), 1U);
  refuse_tiles(tile_of("a.b3dm", R"(,"contents":[{"uri":"c.glb"}])"), ErrorKind::bad_file,
               "root: both \"content\" and \"contents\"");
}

TEST(Tileset, ReadsTilesetsInTiles) {
  const TilesFolder folder(tileset_of(tile_of("deep%20er/t.json", moved("10", "0", "0"))));
  folder.write("deep er/t.json",
               "\xef\xbb\xbf" + tileset_of(tile_of("x.glb", moved("0", "20", "0"))));
  folder.write("deep er/x.glb", numbered_glb({0}));
  const Mesh mesh = folder.read();
  ASSERT_EQ(mesh.parts.size(), 1U);
  EXPECT_EQ(mesh.parts[0].name, "deep er/x.glb");
  EXPECT_EQ(mesh.vertices[0], (Vec3{10, 20, 0}));
}

TEST(Tileset, EndsWhereTilesetsGoInCircles) {
  const TilesFolder folder(tileset_of(tile_of("one.json")));
  folder.write("one.json", tileset_of(tile_of("two.json")));
  folder.write("two.json", tileset_of(tile_of("one.json")));
  expect_refused([&] { static_cast<void>(folder.read()); }, ErrorKind::bad_file,
                 "two.json, root.content.uri: the tileset \"one.json\" is within itself");
  folder.write("tileset.json", tileset_of(tile_of("tileset.json")));
  expect_refused([&] { static_cast<void>(folder.read()); }, ErrorKind::bad_file, "within itself");
}

TEST(Tileset, ReadsEachTilesetOnceAndNoneTooDeep) {
  const TilesFolder folder(
      tileset_of(tile_of("", children({tile_of("0.json"), tile_of("0.json")}))));
  folder.write("0.json", tileset_of(tile_of("a.b3dm")));
  expect_refused([&] { static_cast<void>(folder.read()); }, ErrorKind::unsupported,
                 "root.children[1].content.uri: the tileset \"0.json\" is named a second time");
  folder.write("tileset.json", tileset_of(tile_of("0.json")));
  for (int i = 0; i < 20; ++i) {
    folder.write(std::to_string(i) + ".json", tileset_of(tile_of(std::to_string(i + 1) + ".json")));
  }
  expect_refused([&] { static_cast<void>(folder.read()); }, ErrorKind::bad_file,
                 "nested more than 16 deep");
}

TEST(Tileset, OpensFilesOfItsFolderOnly) {
  const auto refuse = [](const std::string& uri, ErrorKind kind, const std::string& words) {
    refuse_tiles(tile_of(uri), kind, "root.content.uri: " + words);
  };
  refuse("missing.b3dm", ErrorKind::cannot_open, "\"missing.b3dm\": No such file");
  refuse("https://example.org/a.b3dm", ErrorKind::unsupported, "\"https://example.org/a.b3dm\"");
  refuse("../a.b3dm", ErrorKind::bad_file, "\"../a.b3dm\" is outside the folder");
  refuse("%2e%2e/a.b3dm", ErrorKind::bad_file, "\"../a.b3dm\" is outside the folder");
  refuse("/etc/passwd", ErrorKind::bad_file, "\"/etc/passwd\" is outside the folder");
  refuse_tiles(tile_of("", R"(,"content":{"uri":""})"), ErrorKind::bad_file,
               "root.content.uri: \"\" is outside the folder");
  expect_refused(tileset_of(tile_of("a.b3dm")), "t.json", ErrorKind::cannot_open,
                 "cannot be found for a model from memory");
}

TEST(Tileset, IsDistinguishedFromCityJsonAndGltfByItsContent) {
  const TilesFolder folder(tileset_of(tile_of("c.gltf")));
  folder.write(
      "c.gltf",
      R"({"asset":{"version":"2.0","extras":{"root":1,"geometricError":2}},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"c.bin"}]})");
  folder.write("c.bin", std::string(36, '\0'));
  EXPECT_EQ(folder.read().triangles.size(), 1U);
  expect_refused(tileset_of(tile_of("c.gltf")), "t.gltf", ErrorKind::bad_file,
                 "the content is 3D Tiles, but the extension says glTF");
  folder.write(
      "city.json",
      R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},"CityObjects":{},"vertices":[],"asset":1,"root":2})");
  folder.write("tileset.json", tileset_of(tile_of("city.json")));
  expect_refused([&] { static_cast<void>(folder.read()); }, ErrorKind::bad_file,
                 "no content of a tile is CityJSON");
}

TEST(Tileset, NotesContentsThatItDoesNotRead) {
  const TilesFolder folder(tileset_of(tile_of(
      "", R"(,"contents":[{"uri":"a.pnts"},{"uri":"a.i3dm"},{"uri":"a.b3dm"},{"uri":"a.pnts"}])")));
  folder.write("a.pnts", "pnts" + bytes_of(1, 4) + bytes_of(12, 4));
  folder.write("a.i3dm", "i3dm" + bytes_of(1, 4) + bytes_of(12, 4));
  const Mesh mesh = folder.read();
  EXPECT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(
      mesh.notes,
      (std::vector<std::string>{
          "instanced models (i3dm), not read: 1, at root.contents[1].uri",
          "point clouds (pnts), which are not triangles: 2, the first at root.contents[0].uri"}));
  expect_refused([&] { static_cast<void>(folder.read({.strict = true})); }, ErrorKind::bad_file,
                 "instanced models");
  expect_refused("pnts" + std::string(24, '\0'), "a.pnts", ErrorKind::unsupported, "point cloud");
  expect_refused("i3dm" + std::string(24, '\0'), "a.i3dm", ErrorKind::unsupported,
                 "instanced model");
}

TEST(Tileset, NotesVerticesOutsideOfTheirVolumes) {
  const auto notes_of = [](const std::string& volume, const std::string& more = {}) {
    return read_tiles(R"({"geometricError":1,"content":{"uri":"c.glb"},"boundingVolume":)" +
                      volume + more + "}")
        .notes;
  };
  const std::vector<std::string> none;
  // The triangle has the corners 0, x and z.
  EXPECT_EQ(notes_of(R"({"box":[0.5,0,0.5,0.5,0,0,0,0,0,0,0,0.5]})"), none);
  EXPECT_EQ(notes_of(R"({"box":[0.5,0,0.5,0.5,0,0.5,0,1,0,-0.5,0,0.5]})"), none);
  EXPECT_EQ(notes_of(R"({"box":[0.5,0,0.5,0.4,0,0,0,1,0,0,0,0.5]})"),
            (std::vector<std::string>{
                "vertices outside of the volumes of their tiles: 3, the first in c.glb"}));
  EXPECT_EQ(notes_of(R"({"sphere":[0.5,0,0.5,0.7072]})"), none);
  EXPECT_EQ(notes_of(R"({"sphere":[0,0,0,0.9]})").size(), 1U);
  EXPECT_EQ(notes_of(R"({"sphere":[0,0,0,1]})", moved("9", "9", "9")), none);  // it moves along
  EXPECT_EQ(notes_of(R"({"region":[0,0,0.1,0.1,0,9]})").size(), 1U);
  EXPECT_EQ(notes_of(R"({"extensions":{"3DTILES_bounding_volume_S2":{}}})"), none);
  EXPECT_EQ(
      read_tiles(
          tile_of("", R"(,"content":{"uri":"c.glb","boundingVolume":{"sphere":[0,0,0,0.1]}})"))
          .notes.size(),
      1U);
}

/// Earth-centered coordinates of a place, by the definition of the ellipsoid of WGS 84.
Vec3 on_earth(double longitude, double latitude, double height) {
  const double a = 6378137;
  const double e2 = (2 - 1 / 298.257223563) / 298.257223563;
  const double n = a / std::sqrt(1 - e2 * std::sin(latitude) * std::sin(latitude));
  return {(n + height) * std::cos(latitude) * std::cos(longitude),
          (n + height) * std::cos(latitude) * std::sin(longitude),
          (n * (1 - e2) + height) * std::sin(latitude)};
}

TEST(Tileset, FindsPlacesOfTheEarthInTheirRegions) {
  for_each_case("tileset/regions", 200, [](Rng& rng) {
    const double longitude = rng.uniform(-3.14, 3.14);
    const double latitude = rng.uniform(-1.5, 1.5);
    const double height = rng.uniform(-400, 9000);
    const Vec3 at = on_earth(longitude, latitude, height);
    // A triangle of a meter, in a region of a few meters around it, and in one just beside it.
    const double wide = 4 / 6378137.0 / std::cos(latitude);
    const double high = 4 / 6378137.0;
    const auto notes = [&](double east, double up) {
      const auto text = [](double value) { return shortest(value); };
      return read_tiles(
                 R"({"geometricError":1,"content":{"uri":"c.glb"},"boundingVolume":{"region":[)" +
                 text(longitude - wide + east * wide) + "," + text(latitude - high) + "," +
                 text(longitude + wide + east * wide) + "," + text(latitude + high) + "," +
                 text(height - 4 + up) + "," + text(height + 4 + up) + "]}" +
                 moved(text(at.x), text(at.y), text(at.z)) + "}")
          .notes.size();
    };
    EXPECT_EQ(notes(0, 0), 0U);
    EXPECT_EQ(notes(3, 0), 1U);
    EXPECT_EQ(notes(0, 8), 1U);
  });
}

TEST(Tileset, SaysThatNoAxisIsUpInEarthCenteredCoordinates) {
  const Vec3 at = on_earth(0.1, 0.8, 50);
  const std::string there = moved(std::to_string(at.x), std::to_string(at.y), std::to_string(at.z));
  EXPECT_EQ(read_tiles(tile_of("c.glb", there)).up, UpAxis::unknown);
  EXPECT_EQ(read_tiles(tile_of("c.glb", there)).georeference.crs, "EPSG:4978");
  const Mesh local = read_tiles(tile_of("c.glb", moved("100000", "400000", "0")));
  EXPECT_EQ(local.up, UpAxis::z);
  EXPECT_TRUE(local.georeference.empty());
  EXPECT_EQ(
      read_tiles(
          R"({"geometricError":1,"content":{"uri":"c.glb"},"boundingVolume":{"region":[0,0,1,1,0,9]}})")
          .up,
      UpAxis::unknown);
}

TEST(Tileset, KeepsTheTurnOfOldTilesetsWithZUp) {
  const TilesFolder folder(
      R"({"asset":{"version":"1.0","gltfUpAxis":"Z"},"geometricError":9,"root":)" +
      tile_of("c.glb") + "}");
  EXPECT_EQ(folder.read().vertices[2], (Vec3{0, 1, 0}));
}

TEST(Tileset, IsEmptyWithoutTriangles) {
  refuse_tiles(tile_of(""), ErrorKind::empty_mesh, "no triangles");
  EXPECT_TRUE(TilesFolder(tileset_of(tile_of(""))).read({.allow_empty = true}).triangles.empty());
}

TEST(Tileset, IsATypedErrorOrSoundWhereBytesChange) {
  const std::string whole = tileset_of(
      tile_of("b.b3dm", R"(,"refine":"ADD")" + moved("1", "2", "3") +
                            children({tile_of("a.b3dm"), tile_of("deeper.json"),
                                      tile_of("", R"(,"contents":[{"uri":"c.glb"}])")})));
  const TilesFolder folder(whole);
  folder.write("deeper.json", tileset_of(tile_of("c.glb")));
  EXPECT_EQ(folder.read().triangles.size(), 5U);
  for_each_case("tileset/damaged", 500, [&](Rng& rng) {
    folder.write("tileset.json", damaged(whole, rng));
    expect_typed_or_sound([&] { return folder.read({.allow_empty = true}); });
  });
}

TEST(Tileset, KeepsWithinMemory) {
  const TilesFolder folder(tileset_of(tile_of("a.b3dm")));
  expect_refused([&] { static_cast<void>(folder.read({.max_memory = 2000})); },
                 ErrorKind::out_of_memory, "exceeds the memory limit");
}

}  // namespace
}  // namespace soms::test
