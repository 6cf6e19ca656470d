/// \file
/// Numbers as people read them.
#pragma once

#include "soms/base/vector.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace soms::command {

/// A whole number with commas between thousands.
[[nodiscard]] std::string with_commas(std::uint64_t number);

/// A number of at most nine digits: all of them where they are enough to tell it, as 0.1, else the
/// first nine, as 0.100000001 for the float that is nearest to 0.1. Or of another number of digits.
[[nodiscard]] std::string readable(double number, int digits = 9);

/// The first four digits of a number, as a picture has room for: "0.01235". Programs get all.
[[nodiscard]] std::string four_digits(double number);

/// "(1, 2.5, 0)", as `readable`.
[[nodiscard]] std::string point_in_text(const Vec3& point, int digits = 9);

/// A line of a table: without the blanks that fill its last cell, with a line break.
[[nodiscard]] std::string table_line(std::string_view cells);

/// "1 triangle", "2 triangles".
[[nodiscard]] std::string counted(std::uint64_t number, const std::string& noun);

}  // namespace soms::command
