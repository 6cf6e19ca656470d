/// \file
/// What the page carries as it is, made from sources and committed: web/dist.
#pragma once

#include <span>
#include <string_view>

namespace soms::report {

/// The script, as `npm run build` in web/ leaves it, in pieces that follow one another. ASCII;
/// holds neither "</script" nor "<!--".
[[nodiscard]] std::span<const std::string_view> script();

/// The module that answers when a reader moves a body, as `make live` leaves it: WebAssembly,
/// packed by gzip, in base64. Likewise in pieces.
[[nodiscard]] std::span<const std::string_view> live_module();

}  // namespace soms::report
