/// \file
/// 3D Tiles for tests of readers, made on the spot.
#pragma once

#include "soms/base/vector.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soms::test {

/// Parts of a batched model; each may be broken.
struct Batched {
  std::string feature_json = R"({"BATCH_LENGTH":2})";
  std::string feature_numbers = {};
  std::string batch_json = {};
  std::string batch_numbers = {};
  std::string glb = {};
};

/// A GLB of these members of the document, and these bytes as buffer 0.
[[nodiscard]] std::string tile_glb(const std::string& members, const std::string& binary);

/// A GLB of triangles with the corners p, p + x and p + y, one for each number, at p = (number of
/// the triangle, 0, 0); each has the attribute `name` with its number, as floats. `views` are
/// appended to the list of views, and `binary` to their 48 bytes a triangle.
[[nodiscard]] std::string numbered_glb(const std::vector<float>& numbers,
                                       const std::string& name = "_BATCHID",
                                       const std::string& more_of_primitive = {},
                                       const std::string& more = {}, const std::string& views = {},
                                       const std::string& binary = {});

/// A tile with a header of this word: `least` header bytes and what follows.
[[nodiscard]] std::string b3dm_of(const Batched& parts);

/// A b3dm of `numbered_glb`.
[[nodiscard]] std::string b3dm_of(const std::vector<float>& numbers, std::uint64_t length,
                                  const std::string& batch_json = {},
                                  const std::string& more_features = {});

/// A composite of these tiles.
[[nodiscard]] std::string composite_of(const std::vector<std::string>& tiles);

/// A tileset of this root.
[[nodiscard]] std::string tileset_of(const std::string& root, const std::string& more = {});

/// A tile in a huge sphere with these members, and this content, if any.
[[nodiscard]] std::string tile_of(const std::string& uri, const std::string& more = {});

}  // namespace soms::test
