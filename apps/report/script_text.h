/// \file
/// Words from anywhere, made fit for data inside a script of an HTML page.
#pragma once

#include <string>
#include <string_view>

namespace soms::report {

/// `words` as a JSON string with its quotes. No '<', '>' or '&' remains, so that nothing in it ends
/// the script or begins a comment; bytes that are no UTF-8 are replaced by U+FFFD.
[[nodiscard]] std::string script_text(std::string_view words);

/// JSON, made fit for a script element: '<', '>' and '&', which are in its strings alone, are
/// escaped.
[[nodiscard]] std::string script_json(std::string_view json);

/// At most `most` bytes of `words`, cut between characters; "..." stands for what was cut.
[[nodiscard]] std::string shortened(std::string_view words, std::size_t most);

/// At most `most` bytes of the end of `words`, cut between characters, after "..." for what was
/// cut.
[[nodiscard]] std::string shortened_front(std::string_view words, std::size_t most);

}  // namespace soms::report
