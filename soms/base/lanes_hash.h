/// \file
/// A hash of large arrays at the speed of memory. It finds damage, and is no defense against
/// forgery.
#pragma once

#include "soms/base/limits.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace soms {

/// Hash of bytes: the same for any number of threads and on every machine. Pieces of 1 MiB are
/// hashed one by one, in eight lanes of 64 bits, and then their hashes.
/// \errors  ErrorKind::cancelled.
/// \cost    O(n).
[[nodiscard]] std::uint64_t lanes_hash(std::span<const std::byte> bytes, const Limits& limits = {});

}  // namespace soms
