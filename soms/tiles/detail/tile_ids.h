/// \file
/// The numbers of a tile's triangles, as an array file of NumPy.
#pragma once

#include "soms/store/detail/mapped_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace soms::detail {

/// The file's bytes: a header of 128 bytes, and the numbers with the least byte first.
[[nodiscard]] std::string tile_ids_bytes(std::span<const std::uint64_t> ids);

/// `lanes_hash` of the numbers.
[[nodiscard]] std::uint64_t tile_ids_hash(std::span<const std::uint64_t> ids);

/// The numbers in a file that `tile_ids_bytes` made of `count` of them. They stay as long as what
/// `held` keeps. \errors ErrorKind::bad_file.
[[nodiscard]] std::span<const std::uint64_t> tile_ids_of(const HeldBytes& held, std::uint64_t count,
                                                         const std::string& name);

/// Throws ErrorKind::bad_file unless numbers ascend from `begin` and stay below `end`.
void check_tile_ids(std::span<const std::uint64_t> ids, std::uint64_t begin, std::uint64_t end,
                    const std::string& name);

}  // namespace soms::detail
