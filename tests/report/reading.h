/// \file
/// Reads a page back: its data, as a browser would.
#pragma once

#include <nlohmann/json.hpp>

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

/// The JSON of a page's scene.
[[nodiscard]] nlohmann::json scene_of(std::string_view page);

}  // namespace soms::test
