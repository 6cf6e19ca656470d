/// \file
/// Reads a page back: its data, as a browser would.
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soms::test {

/// Content of the script element with this id; the test fails unless there is exactly one.
[[nodiscard]] std::string element(std::string_view page, std::string_view id);

/// Bytes of base64. Fails on anything else.
[[nodiscard]] std::vector<std::uint8_t> bytes_of(std::string_view base64);

/// Little-endian words of base64, and what they are as floats.
[[nodiscard]] std::vector<std::uint32_t> words_of(std::string_view base64);
[[nodiscard]] std::vector<float> floats_of(std::string_view base64);

/// A mesh of a page.
struct PageMesh {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::uint32_t> indices;
  /// How many triangles in a row are of a part, and its number plus 1.
  std::vector<std::array<std::uint64_t, 2>> parts = {};
};

/// The mesh "model-K" or "coarse-K" of a page; of so many triangles, if parts follow it.
[[nodiscard]] PageMesh mesh_of(std::string_view page, std::string_view id, double step,
                               std::uint64_t triangles = ~std::uint64_t{0});

/// Place and turning of each body that moves, at each step that the page holds, body after body.
[[nodiscard]] std::vector<std::array<double, 7>> poses_of(std::string_view page);

/// Two triangles of a page that touch.
struct PagePair {
  std::uint64_t i = 0;
  std::uint64_t j = 0;
  /// Ends of the crossing, corners of i, corners of j.
  std::array<std::array<double, 3>, 8> points{};
};

[[nodiscard]] std::vector<PagePair> pairs_of(std::string_view page);

/// The lines of curves in steps of each, `counts` has how many.
[[nodiscard]] std::vector<std::array<std::int64_t, 6>> lines_of(
    std::string_view page, const std::vector<std::uint32_t>& counts);

/// The JSON of a page's scene.
[[nodiscard]] nlohmann::json scene_of(std::string_view page);

}  // namespace soms::test
