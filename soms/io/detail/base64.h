/// \file
/// Bytes that are written as text of 64 letters.
#pragma once

#include "soms/base/limits.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace soms::detail {

/// Bytes that `letters` of base64 stand for, at most.
[[nodiscard]] constexpr std::size_t base64_size(std::size_t letters) {
  return letters / 4 * 3 + 3;
}

/// Decodes base64 into `to`, which has room for `base64_size`; the = at the end may be missing.
/// Returns the number of bytes; nothing where another letter stands or the last group is cut.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::optional<std::size_t> decode_base64(std::string_view text, char* to,
                                                       const Limits& limits);

}  // namespace soms::detail
