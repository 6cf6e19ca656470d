/// \file
/// Numbers in decimal digits, whatever the language of the host: std::to_chars and std::from_chars
/// of float and double, or the same where the standard library has neither.
#pragma once

#include <version>

#ifdef __cpp_lib_to_chars
#include <charconv>
#else
#include "soms/base/detail/decimal.h"
#endif

namespace soms {

#ifdef __cpp_lib_to_chars
/// The shortest text from which the same number is read, as std::to_chars writes it.
/// \return Its end. \pre There is room for 32 characters.
template <class Real>
[[nodiscard]] char* write_shortest(char* begin, char* end, Real value) {
  return std::to_chars(begin, end, value).ptr;
}

/// So many digits after the point. \return The end. \pre There is room.
[[nodiscard]] inline char* write_fixed(char* begin, char* end, double value, int digits) {
  return std::to_chars(begin, end, value, std::chars_format::fixed, digits).ptr;
}

/// At most so many significant digits, as "%g" of printf. \return The end. \pre There is room.
[[nodiscard]] inline char* write_significant(char* begin, char* end, double value, int digits) {
  return std::to_chars(begin, end, value, std::chars_format::general, digits).ptr;
}

/// As std::from_chars: the nearest number to the longest text that is one.
template <class Real>
[[nodiscard]] std::from_chars_result read_decimal(const char* begin, const char* end, Real& value) {
  return std::from_chars(begin, end, value);
}
#else
using detail::read_decimal;
using detail::write_fixed;
using detail::write_shortest;
using detail::write_significant;
#endif

}  // namespace soms
