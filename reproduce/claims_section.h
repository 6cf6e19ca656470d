/// \file
/// The section of the page that sets each claim of the thesis beside its matrix and its verdict.
#pragma once

#include "reproduce/report.h"

#include <string>

namespace soms::reproduce {

/// The section as HTML. \param open Whether matrices are unfolded, as on paper.
[[nodiscard]] std::string claims_section(const Report& report, bool open);

}  // namespace soms::reproduce
