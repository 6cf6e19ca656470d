// Broken tiles and tilesets: each ends in a typed error that names the place.
#include "soms/base/error.h"

#include "tests/io/files.h"
#include "tests/io/tile_files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace soms::test {
namespace {

std::string with_number(std::string bytes, std::size_t at, std::uint64_t value) {
  return bytes.replace(at, 4, bytes_of(value, 4));
}

const std::string& good() {
  static const std::string bytes = b3dm_of({0, 1}, 2, R"({"id":["a","b"],"height":[1,2]})");
  return bytes;
}

void refuse_b3dm(const std::string& bytes, ErrorKind kind, const std::string& words) {
  SCOPED_TRACE(words);
  expect_refused(bytes, "t.b3dm", kind, "t.b3dm, " + words);
}

void refuse_b3dm(const std::string& bytes, const std::string& words) {
  refuse_b3dm(bytes, ErrorKind::bad_file, words);
}

TEST(BrokenTiles, HaveGoodOnesBesideThem) {
  EXPECT_EQ(read_text(good(), "t.b3dm").parts.size(), 2U);
}

TEST(BrokenTiles, RefuseHeadersThatDoNotAddUp) {
  expect_refused("b3dn" + good().substr(4), "t.b3dm", ErrorKind::bad_file,
                 "t.b3dm, byte 0: no content of a tile begins with \"b3dn\"");
  refuse_b3dm(good().substr(0, 27), "byte 0: the header of the tile is cut off: 27 of 28 bytes");
  refuse_b3dm("b3dm", "byte 0: the header of the tile is cut off: 4 of 28");
  refuse_b3dm(with_number(good(), 4, 2), ErrorKind::unsupported, "byte 4: version 2 of this tile");
  refuse_b3dm(with_number(good(), 8, good().size() + 1), "byte 8: the header states");
  refuse_b3dm(with_number(good(), 8, 27), "byte 8: the header states 27 bytes");
  refuse_b3dm(with_number(good(), 8, 0xffffffff), "byte 8: the header states 4294967295 bytes");
  refuse_b3dm(with_number(good(), 12, 0xffffffff),
              "byte 12: the feature table's JSON states 4294967295 bytes");
  refuse_b3dm(with_number(good(), 16, good().size()),
              "byte 16: the feature table's numbers states");
  refuse_b3dm(with_number(good(), 20, 0xfffffff0), "byte 20: the batch table's JSON states");
  refuse_b3dm(with_number(good(), 24, good().size() - 28),
              "byte 24: the batch table's numbers states");
  refuse_b3dm(good().substr(0, good().size() - 1), "byte 8: the header states");
}

TEST(BrokenTiles, RefuseFeatureTablesThatSayNothing) {
  const std::string glb = numbered_glb({0, 1});
  const auto refuse = [&](const std::string& json, const std::string& words) {
    refuse_b3dm(b3dm_of({.feature_json = json, .glb = glb}), words);
  };
  refuse("", "byte 28: the JSON ends too soon");
  refuse("{\"BATCH_LENGTH\":", "byte 44: the JSON ends too soon");
  refuse("{BATCH_LENGTH:2}", "byte 29: this is not valid JSON");
  refuse("{}", "feature table: \"BATCH_LENGTH\" is missing");
  refuse(R"({"BATCH_LENGTH":-1})", "feature table, BATCH_LENGTH: expected a whole number");
  refuse(R"({"BATCH_LENGTH":"2"})", "feature table, BATCH_LENGTH: expected a whole number");
  refuse(R"({"BATCH_LENGTH":{"byteOffset":0}})",
         "feature table, BATCH_LENGTH: 4 bytes from byte 0");
  refuse(R"({"BATCH_LENGTH":2,"RTC_CENTER":[1,2]})",
         "feature table, RTC_CENTER: 2 numbers instead of 3");
  refuse(R"({"BATCH_LENGTH":2,"RTC_CENTER":[1,2,"3"]})",
         "feature table, RTC_CENTER[2]: expected a number");
  refuse(R"({"BATCH_LENGTH":2,"RTC_CENTER":{"byteOffset":99}})",
         "feature table, RTC_CENTER: 12 bytes from byte 99");
  refuse_b3dm(
      b3dm_of({.feature_json = R"({"BATCH_LENGTH":2,"RTC_CENTER":[1,2,1e999]})", .glb = glb}),
      ErrorKind::not_finite, "byte 68: a number is too large");
}

TEST(BrokenTiles, RefuseBatchTablesThatDoNotFit) {
  const auto refuse = [&](const std::string& json, const std::string& words) {
    refuse_b3dm(b3dm_of({0, 1}, 2, json), words);
  };
  refuse(R"({"id":["a"]})", "batch table, id: 1 values, but BATCH_LENGTH is 2");
  refuse(R"({"id":["a","b","c"]})", "batch table, id: 3 values, but BATCH_LENGTH is 2");
  refuse(R"({"id":"ab"})", "batch table, id: expected a list");
  refuse(R"([1,2])", "batch table: expected an object");
  refuse(R"({"id":["a","b"],"id":["a","b"]})", "batch table, id: this name occurs twice");
  refuse(R"({"h":{"byteOffset":0,"componentType":"FLOAT","type":"SCALAR"}})",
         "batch table, h: 2 values of 4 bytes from byte 0, but the table's numbers have 0 bytes");
  refuse(R"({"h":{"byteOffset":18446744073709551615,"componentType":"FLOAT","type":"SCALAR"}})",
         "batch table, h: 2 values");
  refuse(R"({"h":{"byteOffset":0,"componentType":"HALF","type":"SCALAR"}})",
         "batch table, h.componentType: \"HALF\" is not a component type");
  refuse(R"({"h":{"byteOffset":0,"componentType":"FLOAT","type":"MAT4"}})",
         "batch table, h.type: \"MAT4\" is not a type");
  refuse(R"({"h":{"componentType":"FLOAT","type":"SCALAR"}})",
         "batch table, h: \"byteOffset\" is missing");
}

TEST(BrokenTiles, RefuseBatchIdsBeyondTheTable) {
  refuse_b3dm(b3dm_of({0, 2}, 2), "accessors[1]: element 3 is feature 2");
  refuse_b3dm(b3dm_of({0, 1}, 1), "accessors[1]: element 3 is feature 1");
  refuse_b3dm(b3dm_of({0, 0.5F}, 2), "accessors[1]: element 3 is not a whole number from 0");
  refuse_b3dm(b3dm_of({0, -1}, 2), "accessors[1]: element 3 is not a whole number from 0");
  refuse_b3dm(b3dm_of({0, 3e38F}, 2), "accessors[1]: element 3 is not a whole number from 0");
  std::string glb = numbered_glb({0, 1});
  const std::string count = R"("SCALAR","count":6)";
  glb.replace(glb.find(count), count.size(), R"("SCALAR","count":3)");
  refuse_b3dm(b3dm_of({.glb = glb}), "accessors[1]: 3 feature ids, but 6 positions");
}

TEST(BrokenTiles, RefuseGltfThatIsMissingOrCutOff) {
  const std::string glb = numbered_glb({0, 1});
  refuse_b3dm(b3dm_of({}), "byte 52: the glTF of the tile is missing");
  refuse_b3dm(b3dm_of({.glb = "glTG" + glb.substr(4)}),
              "byte 52: the glTF of the tile does not begin with \"glTF\"");
  refuse_b3dm(b3dm_of({.glb = "models/house.glb"}),
              "byte 52: the glTF of the tile does not begin with \"glTF\"");
  refuse_b3dm(b3dm_of({.glb = glb.substr(0, 11)}), "byte 52: the GLB header is missing");
  refuse_b3dm(b3dm_of({.glb = with_number(glb, 8, glb.size() + 4)}), "byte 60: the header states");
  refuse_b3dm(b3dm_of({.glb = with_number(glb, 4, 1)}), ErrorKind::unsupported,
              "byte 56: version 1 of GLB");
  refuse_b3dm(b3dm_of({.glb = with_number(glb, 12, 0xffffffff)}), "byte 64: a chunk is cut off");
  refuse_b3dm(b3dm_of({.glb = numbered_glb({0, 1}, "_BATCHID", {},
                                           R"(,"extensions":{"CESIUM_RTC":{"center":[1]}})")}),
              "extensions.CESIUM_RTC.center: 1 numbers instead of 3");
}

TEST(BrokenTiles, RefuseCompositesThatDoNotAddUp) {
  const auto refuse = [](const std::string& bytes, const std::string& words) {
    expect_refused(bytes, "t.cmpt", ErrorKind::bad_file, "t.cmpt, " + words);
  };
  const std::string two = composite_of({good(), good()});
  refuse(two.substr(0, 15), "byte 0: the header of the tile is cut off: 15 of 16");
  refuse(with_number(two, 12, 3),
         "byte " + std::to_string(two.size()) + ": tile 2 of the composite is cut off");
  refuse(with_number(two, 24, two.size()), "byte 24: tile 0 of the composite states");
  refuse(with_number(two, 24, 8), "byte 24: tile 0 of the composite states 8 bytes");
  refuse(composite_of({"abcd" + std::string(8, '\x0c')}),
         "byte 24: tile 0 of the composite states");
  refuse(composite_of({"abcd" + bytes_of(1, 4) + bytes_of(12, 4)}),
         "byte 16: no content of a tile begins with \"abcd\"");
  std::string deep = good();
  for (int i = 0; i < 10; ++i) {
    deep = composite_of({deep});
  }
  refuse(deep, "byte 128: composites are nested more than 8 deep");
}

void refuse_tileset(const std::string& text, ErrorKind kind, const std::string& words) {
  SCOPED_TRACE(words);
  expect_refused(text, "t.json", kind, "t.json" + words);
}

void refuse_root(const std::string& root, const std::string& words,
                 ErrorKind kind = ErrorKind::bad_file) {
  refuse_tileset(tileset_of(root), kind, words);
}

TEST(BrokenTilesets, RefuseWhatIsNotSaid) {
  refuse_tileset(R"({"asset":{"version":"1.0"},"geometricError":1})", ErrorKind::bad_file,
                 ": \"root\" is missing");
  refuse_tileset(R"({"asset":{"version":"1.0"},"root":{}})", ErrorKind::bad_file,
                 ": \"geometricError\" is missing");
  refuse_tileset(R"({"asset":{},"geometricError":1,"root":{}})", ErrorKind::bad_file,
                 ", asset: \"version\" is missing");
  refuse_tileset(R"({"asset":{"version":"2.0"},"geometricError":1,"root":{}})",
                 ErrorKind::unsupported, ", asset.version: version \"2.0\" is not read");
  refuse_tileset(R"({"asset":{"version":"1.0","gltfUpAxis":"X"},"geometricError":1,"root":{}})",
                 ErrorKind::unsupported, ", asset.gltfUpAxis: the up axis \"X\"");
  refuse_tileset(tileset_of(tile_of("")).substr(0, 60), ErrorKind::bad_file,
                 ", line 1: the JSON ends too soon");
  refuse_root("[]", ", root: expected an object");
  refuse_root(R"({"geometricError":1})", ", root: \"boundingVolume\" is missing");
  refuse_root(R"({"boundingVolume":{"sphere":[0,0,0,1]}})",
              ", root: \"geometricError\" is missing");
  refuse_root(R"({"boundingVolume":{"sphere":[0,0,0,1]},"geometricError":-1})",
              ", root.geometricError: the geometric error must be 0 or more");
  refuse_root(tile_of("", R"(,"content":{})"), ", root.content: \"uri\" is missing");
  refuse_root(tile_of("", R"(,"content":{"uri":7})"), ", root.content.uri: expected a string");
  refuse_root(tile_of("", R"(,"children":{})"), ", root.children: expected a list");
  refuse_root(tile_of("", R"(,"children":[7])"), ", root.children[0]: expected an object");
  refuse_root(tile_of("", R"(,"refine":"MERGE")"), ", root.refine: \"MERGE\" is neither");
}

TEST(BrokenTilesets, RefuseTransformsThatAreNone) {
  const auto refuse = [](const std::string& numbers, const std::string& words,
                         ErrorKind kind = ErrorKind::bad_file) {
    refuse_root(tile_of("", R"(,"transform":[)" + numbers + "]"), words, kind);
  };
  refuse("1,0,0,0,0,1,0,0,0,0,1,0,5,5,5", ", root.transform: 15 numbers instead of 16");
  refuse("1,0,0,0,0,1,0,0,0,0,1,0,5,5,5,1,1", ", root.transform: 17 numbers instead of 16");
  refuse("1,0,0,0,0,1,0,0,0,0,1,0,NaN,5,5,1", ", line 1: this is not valid JSON");
  refuse("1,0,0,0,0,1,0,0,0,0,1,0,null,5,5,1", ", root.transform[12]: expected a number");
  refuse("1,0,0,0,0,1,0,0,0,0,1,0,1e999,5,5,1", ", line 1: a number is too large",
         ErrorKind::not_finite);
  refuse("1,0,0,5,0,1,0,5,0,0,1,5,0,0,0,1", ", root.transform: the last row is not 0 0 0 1");
}

TEST(BrokenTilesets, RefuseVolumesThatAreNone) {
  const auto refuse = [](const std::string& volume, const std::string& words) {
    refuse_root(R"({"geometricError":1,"boundingVolume":)" + volume + "}", words);
  };
  refuse("{}", ", root.boundingVolume: none of \"region\", \"box\" and \"sphere\"");
  refuse("[]", ", root.boundingVolume: expected an object");
  refuse(R"({"box":[1,2,3,4,5,6,7,8,9,10,11]})",
         ", root.boundingVolume.box: 11 numbers instead of 12");
  refuse(R"({"region":[1,2,3,4,5]})", ", root.boundingVolume.region: 5 numbers instead of 6");
  refuse(R"({"region":[0,1,1,0,0,9]})", ", root.boundingVolume.region: the region ends before");
  refuse(R"({"region":[0,0,1,1,9,0]})", ", root.boundingVolume.region: the region ends before");
  refuse(R"({"sphere":[0,0,0,-1]})", ", root.boundingVolume.sphere[3]: a negative radius");
  refuse(R"({"sphere":[0,0,"0",1]})", ", root.boundingVolume.sphere[2]: expected a number");
}

TEST(BrokenTilesets, RefuseWhatIsNotRead) {
  const auto refuse = [](const std::string& root, const std::string& words) {
    refuse_root(root, words, ErrorKind::unsupported);
  };
  refuse(tile_of("a/{level}/{x}/{y}.glb", R"(,"implicitTiling":{"subdivisionScheme":"QUADTREE"})"),
         ", root.implicitTiling: implicit tiling, which is not read");
  refuse(tile_of("", R"(,"extensions":{"3DTILES_implicit_tiling":{}})"),
         ", root.extensions.3DTILES_implicit_tiling: implicit tiling");
  refuse(tile_of("", R"(,"extensions":{"3DTILES_multiple_contents":{}})"),
         ", root.extensions.3DTILES_multiple_contents: several contents");
  refuse_tileset(tileset_of(tile_of(""), R"(,"extensionsRequired":["VENDOR_tiles"])"),
                 ErrorKind::unsupported, ", extensionsRequired[0]: the extension \"VENDOR_tiles\"");
}

TEST(BrokenTilesets, AreNamedByTheFileOfTheirContent) {
  const TemporaryFolder folder;
  write_content(folder.path() / "tileset.json", tileset_of(tile_of("bad.b3dm")));
  const auto refuse = [&](const std::string& content, const std::string& words) {
    write_content(folder.path() / "bad.b3dm", content);
    expect_refused([&] { static_cast<void>(read_mesh(folder.path() / "tileset.json")); },
                   ErrorKind::bad_file, words);
  };
  refuse("", "root.content.uri: \"bad.b3dm\": the file is empty");
  refuse(with_number(good(), 8, 9), "bad.b3dm, byte 8: the header states 9 bytes");
  refuse("no tile", "bad.b3dm, byte 0: no content of a tile begins with \"no t\"");
  refuse(tileset_of("{}"), "bad.b3dm, root: \"boundingVolume\" is missing");
}

}  // namespace
}  // namespace soms::test
