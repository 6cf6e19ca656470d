/// \file
/// A clash list as one HTML page.
#pragma once

#include "apps/report/parts_page.h"
#include "apps/soms/clash/clash_rows.h"

#include <ostream>
#include <string>

namespace soms::command {

/// Writes the page: every row, and the parts as far as there is room. `command` is the command line
/// that gives the list again; `verified` says that brute force found the same.
/// \errors As `overlap`, for the curves along which surfaces cross.
report::ShownParts write_clashes_as_page(const ClashReport& report, const std::string& command,
                                         bool verified, std::ostream& out);

}  // namespace soms::command
