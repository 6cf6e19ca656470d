/// \file
/// What a path stands for, where links lead on.
#pragma once

#include <filesystem>

namespace soms::detail {

inline constexpr int kMostLinks = 40;  ///< in a row, as many as Linux follows

/// The folder that the last name of `path` is looked up in.
[[nodiscard]] std::filesystem::path folder_of(const std::filesystem::path& path);

/// The open descriptor of this program that `path` stands for (/dev/stdin, /dev/fd/3), else -1.
[[nodiscard]] int named_descriptor(std::filesystem::path path);

}  // namespace soms::detail
