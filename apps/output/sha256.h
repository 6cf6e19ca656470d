/// \file
/// Fingerprints of files, which other people's tools compute alike: SHA-256 of FIPS 180-4.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace soms::command {

/// 64 hexadecimal digits, as `sha256sum` prints them.
[[nodiscard]] std::string sha256(std::string_view bytes);

/// The same of a file, whose bytes are not kept in memory; empty if it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace soms::command
