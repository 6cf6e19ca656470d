/// \file
/// What the page says of the claims of the thesis: all with their verdicts, and each with its
/// matrix.
#pragma once

#include "thesis/page/report.h"

#include <string>

namespace soms::reproduce {

/// A claim with its verdict, reasons and matrix, as HTML.
[[nodiscard]] std::string claim_part(const Claim& claim, PageFiles files);

/// All claims with their verdicts and where they hold, as HTML.
[[nodiscard]] std::string claims_section(const Report& report);

}  // namespace soms::reproduce
