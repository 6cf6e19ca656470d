#include "tests/io/tile_files.h"

#include "tests/io/files.h"

namespace soms::test {
namespace {

/// Filled with blanks to a multiple of eight bytes, if there is any.
std::string filled(std::string text) {
  text.resize((text.size() + 7) / 8 * 8, ' ');
  return text;
}

}  // namespace

std::string tile_glb(const std::string& members, const std::string& binary) {
  std::string json = R"({"asset":{"version":"2.0"},)" + members + R"(,"buffers":[{"byteLength":)" +
                     std::to_string(binary.size()) + "}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string chunks = bytes_of(json.size(), 4) + "JSON" + json + bytes_of(binary.size(), 4) +
                             std::string("BIN\0", 4) + binary;
  return "glTF" + bytes_of(2, 4) + bytes_of(12 + chunks.size(), 4) + chunks;
}

std::string numbered_glb(const std::vector<float>& numbers, const std::string& name,
                         const std::string& more_of_primitive, const std::string& more,
                         const std::string& views, const std::string& binary) {
  std::string positions;
  std::string ids;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto x = static_cast<float>(i);
    for (const float number : {x, 0.0F, 0.0F, x + 1, 0.0F, 0.0F, x, 1.0F, 0.0F}) {
      positions += bytes_of(number);
    }
    ids += bytes_of(numbers[i]) + bytes_of(numbers[i]) + bytes_of(numbers[i]);
  }
  const std::string count = std::to_string(3 * numbers.size());
  return tile_glb(
      R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,")" +
          name + R"(":1})" + more_of_primitive +
          R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
          count + R"(},{"bufferView":1,"componentType":5126,"type":"SCALAR","count":)" + count +
          R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + std::to_string(positions.size()) +
          R"(},{"buffer":0,"byteOffset":)" + std::to_string(positions.size()) +
          R"(,"byteLength":)" + std::to_string(ids.size()) + "}" + views + "]" + more,
      positions + ids + binary);
}

std::string b3dm_of(const Batched& parts) {
  std::string lengths;
  std::string sections;
  for (const std::string* const section :
       {&parts.feature_json, &parts.feature_numbers, &parts.batch_json, &parts.batch_numbers}) {
    lengths += bytes_of(filled(*section).size(), 4);
    sections += filled(*section);
  }
  return "b3dm" + bytes_of(1, 4) + bytes_of(28 + sections.size() + parts.glb.size(), 4) + lengths +
         sections + parts.glb;
}

std::string b3dm_of(const std::vector<float>& numbers, std::uint64_t length,
                    const std::string& batch_json, const std::string& more_features) {
  return b3dm_of(
      {.feature_json = R"({"BATCH_LENGTH":)" + std::to_string(length) + more_features + "}",
       .batch_json = batch_json,
       .glb = numbered_glb(numbers)});
}

std::string composite_of(const std::vector<std::string>& tiles) {
  std::string inside;
  for (const std::string& tile : tiles) {
    inside += tile;
  }
  return "cmpt" + bytes_of(1, 4) + bytes_of(16 + inside.size(), 4) + bytes_of(tiles.size(), 4) +
         inside;
}

std::string tileset_of(const std::string& root, const std::string& more) {
  return R"({"asset":{"version":"1.1"},"geometricError":9,"root":)" + root + more + "}";
}

std::string tile_of(const std::string& uri, const std::string& more) {
  return R"({"boundingVolume":{"sphere":[0,0,0,1e9]},"geometricError":1)" +
         (uri.empty() ? std::string() : R"(,"content":{"uri":")" + uri + "\"}") + more + "}";
}

}  // namespace soms::test
