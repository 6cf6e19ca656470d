/// \file
/// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>

namespace soms::command {

/// A whole number with commas between thousands.
[[nodiscard]] std::string with_commas(std::uint64_t number);

/// "1 triangle", "2 triangles".
[[nodiscard]] std::string counted(std::uint64_t number, const std::string& noun);

}  // namespace soms::command
