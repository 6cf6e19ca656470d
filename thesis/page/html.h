/// \file
/// Words and links of the page that several of its sections use.
#pragma once

#include "thesis/claims/claim.h"
#include "thesis/claims/nearest_verdict.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace soms::reproduce {

/// "1,024 rows", "1 row".
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// A verdict in a colored frame, with a sign so that color is not all that tells them apart.
[[nodiscard]] std::string badge(Verdict verdict);
[[nodiscard]] std::string badge(NearestStand stand);

/// The sign of a verdict.
[[nodiscard]] std::string_view sign_of(Verdict verdict);
[[nodiscard]] std::string_view sign_of(NearestStand stand);

/// A class of style sheet for a verdict: its color.
[[nodiscard]] std::string_view class_of(Verdict verdict);
[[nodiscard]] std::string_view class_of(NearestStand stand);

/// Words as a sentence: with a stop at the end.
[[nodiscard]] std::string sentence(std::string words);

/// "table-5.3" as people write it: "Table 5.3".
[[nodiscard]] std::string spoken(std::string_view item);

}  // namespace soms::reproduce
