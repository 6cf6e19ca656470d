/// \file
/// The page of a clearance along a path: what `clearance -o FILE.html` writes.
#pragma once

#include "apps/soms/clearance/clearance_output.h"

#include <ostream>

namespace soms::command {

/// Figures, the gap along the path as a plot, the nearest places as a table, and the stations in
/// three dimensions.
void write_clearance_page(std::ostream& out, const ClearanceReport& report,
                          const NearestNames& names);

}  // namespace soms::command
