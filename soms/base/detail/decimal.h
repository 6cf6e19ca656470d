/// \file
/// What decimal.h offers, where the standard library has none of it: by printf and strtod, whatever
/// their language. The same bytes, and the same numbers.
#pragma once

#include <charconv>

namespace soms::detail {

[[nodiscard]] char* write_shortest(char* begin, char* end, double value);
[[nodiscard]] char* write_shortest(char* begin, char* end, float value);
[[nodiscard]] char* write_fixed(char* begin, char* end, double value, int digits);
[[nodiscard]] char* write_significant(char* begin, char* end, double value, int digits);
[[nodiscard]] std::from_chars_result read_decimal(const char* begin, const char* end,
                                                  double& value);
[[nodiscard]] std::from_chars_result read_decimal(const char* begin, const char* end, float& value);

}  // namespace soms::detail
