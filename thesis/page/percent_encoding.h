/// \file
/// Bytes as a part of an address.
#pragma once

#include <string>
#include <string_view>

namespace soms::reproduce {

/// Bytes as a part of an address (RFC 3986): all but letters, digits and marks without a meaning
/// there as "%3F".
[[nodiscard]] std::string percent_encoded(std::string_view bytes);

}  // namespace soms::reproduce
