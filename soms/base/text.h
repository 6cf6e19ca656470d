/// \file
/// Words from anywhere, made fit for a file that must be read by others.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace soms {

/// Bytes of the UTF-8 character that begins at `at`; 0 if none does. \pre at < words.size().
[[nodiscard]] std::size_t utf8_character(std::string_view words, std::size_t at);

/// `words` as text or attribute of an XML or HTML file: markup and quotes escaped, what XML or
/// UTF-8 forbids replaced by '?'.
[[nodiscard]] std::string xml_text(std::string_view words);

/// Shortest text from which the same double is read: "0.1", "1e+300", "-0", "nan", "inf".
[[nodiscard]] std::string shortest(double value);

/// `words` in double quotes, on one line and fit for a terminal: quotes and backslashes after a
/// backslash, control characters and what is no UTF-8 as \xNN.
[[nodiscard]] std::string quoted_text(std::string_view words);

}  // namespace soms
