/// \file
/// Checks of documents: that their markup is well-formed, and what is in them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace soms::test {

/// Why the text is no well-formed XML (tags that do not match, attributes without quotes or twice,
/// bare '<' or '&'); empty if it is. `void_elements` need no end, as in HTML.
[[nodiscard]] std::string markup_fault(std::string_view text,
                                       const std::vector<std::string_view>& void_elements = {});

/// All values of the attribute, in order.
[[nodiscard]] std::vector<std::string> values_of(std::string_view text, std::string_view attribute);

/// How often `words` occur.
[[nodiscard]] std::size_t count_of(std::string_view text, std::string_view words);

}  // namespace soms::test
