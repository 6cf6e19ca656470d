// Tilesets whose JSON was changed in its structure, in the tileset, in one within it, and in the
// tables and the glTF of contents: each gives a typed error with its place, or a sound mesh.
#include "soms/base/error.h"
#include "soms/geometry/mesh.h"

#include "tests/io/files.h"
#include "tests/io/tile_files.h"
#include "tests/support/json_mutations.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

using TileJson = nlohmann::json;

constexpr int kChangedTilesets = 5000;

/// The JSON of a file, and the file that these documents make.
struct OpenTile {
  std::vector<TileJson> documents = {};
  std::function<std::string(const std::vector<TileJson>&)> closed = {};
};

std::size_t number_at(const std::string& bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t k = 4; k-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes.at(at + k));
  }
  return value;
}

std::string text_of(const TileJson& json) {
  return json.dump(-1, ' ', true, TileJson::error_handler_t::replace);
}

OpenTile open_json(const std::string& bytes) {
  return {{TileJson::parse(bytes)},
          [](const std::vector<TileJson>& documents) { return text_of(documents.at(0)); }};
}

OpenTile open_glb(const std::string& bytes) {
  const std::size_t length = number_at(bytes, 12);
  const std::string rest = bytes.substr(20 + length);
  return {{TileJson::parse(bytes.substr(20, length))},
          [rest](const std::vector<TileJson>& documents) {
            std::string json = text_of(documents.at(0));
            json.resize((json.size() + 3) / 4 * 4, ' ');
            return "glTF" + bytes_of(2, 4) + bytes_of(20 + json.size() + rest.size(), 4) +
                   bytes_of(json.size(), 4) + "JSON" + json + rest;
          }};
}

OpenTile open_b3dm(const std::string& bytes) {
  Batched parts;
  std::size_t at = 28;
  std::size_t size = 12;
  for (std::string* const section :
       {&parts.feature_json, &parts.feature_numbers, &parts.batch_json, &parts.batch_numbers}) {
    *section = bytes.substr(at, number_at(bytes, size));
    at += section->size();
    size += 4;
  }
  const OpenTile glb = open_glb(bytes.substr(at));
  OpenTile open{{TileJson::parse(parts.feature_json), glb.documents.at(0)}};
  if (!parts.batch_json.empty()) {
    open.documents.push_back(TileJson::parse(parts.batch_json));
  }
  open.closed = [parts, glb](const std::vector<TileJson>& documents) {
    Batched changed = parts;
    changed.feature_json = text_of(documents.at(0));
    changed.glb = glb.closed({documents.at(1)});
    if (documents.size() > 2) {
      changed.batch_json = text_of(documents.at(2));
    }
    return b3dm_of(changed);
  };
  return open;
}

OpenTile open_tile(const std::string& name, const std::string& bytes) {
  return name.ends_with(".json")  ? open_json(bytes)
         : name.ends_with(".glb") ? open_glb(bytes)
                                  : open_b3dm(bytes);
}

/// What became of the changed tilesets.
struct TileOutcomes {
  int inputs = 0;
  int refused = 0;
  int placed = 0;  ///< refused with a place within the file
  int read = 0;
};

/// Files by name, among them tileset.json, in a folder of their own.
class TilesToChange {
 public:
  explicit TilesToChange(std::map<std::string, std::string> files) : files_(std::move(files)) {
    for (const auto& [name, bytes] : files_) {
      write_content(folder_.path() / name, bytes);
      if (!name.ends_with(".cmpt")) {
        names_.push_back(name);
        open_[name] = open_tile(name, bytes);
      }
    }
    static_cast<void>(read());
  }

  /// Changes one file, reads the tileset, and puts the file back.
  void read_changed(Rng& rng, TileOutcomes& outcomes) {
    const std::string& name = names_[rng.below(names_.size())];
    const OpenTile& open = open_.at(name);
    std::vector<TileJson> documents = open.documents;
    for (std::uint64_t changes = 1 + rng.below(2); changes > 0; --changes) {
      mutate(documents[rng.below(documents.size())], rng);
    }
    std::string bytes = open.closed(documents);
    if (rng.below(6) == 0) {
      bytes = damaged(bytes, rng);
    }
    write(name, bytes);
    SCOPED_TRACE(name + ": " + bytes.substr(0, 2000));
    judge(name, outcomes);
    write(name, files_.at(name));
  }

 private:
  /// Into a new file: some systems write one that is cut to disk at once.
  void write(const std::string& name, const std::string& bytes) const {
    std::filesystem::remove(folder_.path() / name);
    write_content(folder_.path() / name, bytes);
  }

  [[nodiscard]] Mesh read() const { return read_mesh(folder_.path() / "tileset.json"); }

  void judge(const std::string& changed, TileOutcomes& outcomes) const {
    ++outcomes.inputs;
    try {
      const Mesh mesh = read();
      check(mesh);
      EXPECT_FALSE(mesh.triangles.empty());
      ++outcomes.read;
    } catch (const Error& error) {
      ++outcomes.refused;
      EXPECT_NE(error.kind(), ErrorKind::usage) << error.what();
      EXPECT_NE(error.kind(), ErrorKind::cancelled) << error.what();
      const std::string start = (folder_.path() / "tileset.json").string();
      EXPECT_TRUE(error.place().starts_with(start)) << error.what();
      EXPECT_NE(error.place().find(changed), std::string::npos) << error.what();
      EXPECT_FALSE(error.remedy().empty());
      outcomes.placed += error.place().starts_with(start + ", ") ? 1 : 0;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "no typed error: " << error.what();
    }
  }

  TemporaryFolder folder_;
  std::map<std::string, std::string> files_;
  std::map<std::string, OpenTile> open_;
  std::vector<std::string> names_;  ///< of files that are changed
};

void expect_tilesets_sound(const char* tag, std::map<std::string, std::string> files) {
  TilesToChange tiles(std::move(files));
  TileOutcomes outcomes;
  for_each_case(tag, kChangedTilesets, [&](Rng& rng) { tiles.read_changed(rng, outcomes); });
  EXPECT_GE(outcomes.inputs, kChangedTilesets);
  EXPECT_EQ(outcomes.inputs, outcomes.refused + outcomes.read);
  EXPECT_GT(outcomes.refused, kChangedTilesets / 4);
  EXPECT_GT(outcomes.read, kChangedTilesets / 50);
  EXPECT_GT(outcomes.placed, outcomes.refused / 2);
}

TEST(ChangedTilesets, OfTheTestDataGiveTypedErrorsOrSoundMeshes) {
  TileJson tileset = TileJson::parse(content_of(test::data("formats/tileset.json")));
  tileset["root"]["children"].push_back(
      {{"boundingVolume", {{"box", {0, 0, 0, 99, 0, 0, 0, 99, 0, 0, 0, 99}}}},
       {"geometricError", 0},
       {"content", {{"uri", "composite.cmpt"}}}});
  expect_tilesets_sound("changed tilesets of the test data",
                        {{"tileset.json", text_of(tileset)},
                         {"batched.b3dm", content_of(test::data("formats/batched.b3dm"))},
                         {"composite.cmpt", content_of(test::data("formats/composite.cmpt"))}});
}

TEST(ChangedTilesets, WithOneInsideGiveTypedErrorsOrSoundMeshes) {
  const std::string old = R"({"asset":{"version":"1.0","gltfUpAxis":"Z"},"geometricError":2,"root":{
    "boundingVolume":{"region":[0.1,0.2,0.3,0.4,-9,9]},"geometricError":1,"refine":"add",
    "contents":[{"uri":"c.glb"},{"uri":"b.b3dm","boundingVolume":{"sphere":[1,2,3,4]}}]}})";
  const std::string tileset = tileset_of(
      tile_of("a.b3dm",
              R"(,"refine":"REPLACE","transform":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1],"children":[)" +
                  tile_of("inner.json") + "," + tile_of("a.b3dm", R"(,"viewerRequestVolume":{})") +
                  "]"),
      R"(,"extensionsUsed":["3DTILES_metadata"],"extensionsRequired":["3DTILES_metadata"])");
  const std::string glb =
      numbered_glb({0, 1}, "_BATCHID", {}, R"(,"extensions":{"CESIUM_RTC":{"center":[1,2,3]}})");
  expect_tilesets_sound(
      "changed tilesets with one inside",
      {{"tileset.json", tileset},
       {"inner.json", old},
       {"a.b3dm", b3dm_of({0, 1}, 2, R"({"id":["a","b"],"height":[1,2],"more":[{"x":1},null]})",
                          R"(,"RTC_CENTER":[4,5,6])")},
       {"b.b3dm",
        b3dm_of({.feature_json = R"({"BATCH_LENGTH":2,"RTC_CENTER":{"byteOffset":0}})",
                 .feature_numbers = bytes_of(0, 16),
                 .batch_json = R"({"h":{"byteOffset":0,"componentType":"FLOAT","type":"SCALAR"}})",
                 .batch_numbers = bytes_of(0, 8),
                 .glb = glb})},
       {"c.glb", numbered_glb({0})}});
}

}  // namespace
}  // namespace soms::test
