/// \file
/// The script of the page, as `npm run build` in web/ leaves it.
#pragma once

#include <span>
#include <string_view>

namespace soms::report {

/// Pieces that follow one another. ASCII; holds neither "</script" nor "<!--".
[[nodiscard]] std::span<const std::string_view> script();

}  // namespace soms::report
