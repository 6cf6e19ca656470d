// Folders of tiles that are damaged: a typed error, or the answer.
#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/generate/shapes.h"

#include "tests/support/support.h"
#include "tests/tiles/tiled_twin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace soms {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::remove(path);  // what is mapped keeps the old file
  std::ofstream(path, std::ios::binary) << bytes;
}

/// What a damaged folder says: an error, or the answers of the whole.
class DamagedTiles : public testing::Test {
 protected:
  DamagedTiles()
      : tiles_(test::tiles_of(folder_.path(), std::vector<Mesh>{mesh_}, {.most = 40})),
        whole_(Shape(mesh_)) {
    Rng rng(3);
    questions_ = test::random_questions(rng, Shape(generate_sphere(20)), whole_.shape.bounds(), 8);
  }

  /// "same", or the kind of the error.
  [[nodiscard]] std::string outcome() const {
    try {
      const std::string difference =
          test::difference(questions_, {TileSet::open(folder_.path())}, whole_);
      return difference.empty() ? "same" : difference;
    } catch (const Error& error) {
      return std::string(name(error.kind()));
    }
  }

  void expect_known(const std::string& what) const {
    const std::string found = outcome();
    EXPECT_TRUE(found == "same" || found == "bad_file" || found == "unsupported" ||
                found == "not_finite" || found == "cannot_open" || found == "out_of_range")
        << what << ": " << found;
  }

  test::TemporaryFolder folder_;
  Mesh mesh_ = generate_sphere(200);
  TileSet tiles_;
  Body whole_;
  test::TiledQuestions questions_;
};

TEST_F(DamagedTiles, TruncatedFilesAreRefused) {
  const Tile& tile = tiles_.tiles()[1];
  for (const std::string& file : {tile.file, tile.ids, std::string(kTileManifest)}) {
    const std::filesystem::path path = folder_.path() / file;
    const std::string bytes = bytes_of(path);
    for (const double share : {0.0, 0.01, 0.3, 0.9, 0.999}) {
      write(path,
            bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
      EXPECT_EQ(outcome(), "bad_file") << file << " " << share;
    }
    write(path, bytes + std::string(8, '\0'));
    EXPECT_NE(outcome(), "same") << file;
    std::filesystem::remove(path);
    EXPECT_EQ(outcome(), "cannot_open") << file;
    write(path, bytes);
    EXPECT_EQ(outcome(), "same");
  }
}

TEST_F(DamagedTiles, FlippedBytesAreFound) {
  const Tile& tile = tiles_.tiles()[1];
  test::for_each_case("flipped tiles", 200, [&](Rng& rng) {
    const std::string& file = rng.below(2) == 0 ? tile.file : tile.ids;
    const std::filesystem::path path = folder_.path() / file;
    const std::string bytes = bytes_of(path);
    std::string other = bytes;
    other[rng.below(other.size())] ^= static_cast<char>(1 + rng.below(255));
    write(path, other);
    expect_known(file);
    write(path, bytes);
  });
}

TEST_F(DamagedTiles, ChangedManifestsAreReadOrRefused) {
  const std::filesystem::path path = folder_.path() / kTileManifest;
  const std::string bytes = bytes_of(path);
  test::for_each_case("changed manifests", 400, [&](Rng& rng) {
    std::string other = bytes;
    const std::size_t at = rng.below(other.size());
    switch (rng.below(4)) {
      case 0:
        other[at] = static_cast<char>(32 + rng.below(95));
        break;
      case 1:
        other.erase(at, 1 + rng.below(20));
        break;
      case 2:
        other.insert(at, other.substr(rng.below(other.size()), rng.below(30)));
        break;
      default:
        other.insert(at, std::to_string(rng.below(1ULL << 60)));
    }
    write(path, other);
    const std::string found = outcome();
    // A box of the manifest is compared with the tile's when that is met: until then it may hide
    // it.
    EXPECT_TRUE(found != "usage" && found != "cannot_write") << found;
  });
}

TEST_F(DamagedTiles, TilesOfAnotherSetAreNotTaken) {
  const test::TemporaryFolder other;
  static_cast<void>(
      test::tiles_of(other.path(), std::vector<Mesh>{generate_sphere(202)}, {.most = 40}));
  std::filesystem::copy_file(other.path() / tiles_.tiles()[2].file,
                             folder_.path() / tiles_.tiles()[2].file,
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(outcome(), "bad_file");
}

TEST_F(DamagedTiles, VerifyingFindsTrianglesThatAreInTwoTilesOrInNone) {
  verify_tiles(folder_.path());
  const std::filesystem::path path = folder_.path() / kTileManifest;
  const std::string bytes = bytes_of(path);
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string other = bytes;
    other.replace(other.find(from), from.size(), to);
    return other;
  };
  const std::string row0 = bytes.substr(bytes.find("{\"file\": \"tile-000000"));
  const std::string first = row0.substr(0, row0.find("},\n") + 1);
  const std::string row1 = bytes.substr(bytes.find("{\"file\": \"tile-000001"));
  const std::string second = row1.substr(0, row1.find("},\n") + 1);
  for (const std::string& other :
       {replaced(second, first), replaced("\"bytes\": ", "\"bytes\": 1"),
        replaced("\"bytes\": ", "\"bytes\": 18446744073709551615, \"was\": ")}) {
    write(path, other);
    EXPECT_EQ(test::kind_of([&] { verify_tiles(folder_.path()); }), ErrorKind::bad_file) << other;
  }
}

TEST_F(DamagedTiles, NamesLeadNowhereElse) {
  const std::filesystem::path path = folder_.path() / kTileManifest;
  const std::string bytes = bytes_of(path);
  for (const char* const name : {"../tile-000000.somst", "/etc/passwd", "..", ".", ""}) {
    std::string other = bytes;
    const std::string old = "\"tile-000000.somst\"";
    other.replace(other.find(old), old.size(), std::string("\"") + name + "\"");
    write(path, other);
    EXPECT_EQ(outcome(), "bad_file") << name;
  }
  std::string next = bytes;
  next.replace(next.find("soms.tiles/1"), 12, "soms.tiles/2");
  write(path, next);
  EXPECT_EQ(outcome(), "unsupported");
}

}  // namespace
}  // namespace soms
