/// \file
/// A picture of a path from above, as SVG: how near the profile comes, and where.
#pragma once

#include "apps/soms/clearance/clearance_output.h"

#include <ostream>

namespace soms::command {

/// Draws the part of the city around the path; the path colored by verdicts or, without a
/// clearance, by gaps; the least gap and the first contact.
void draw_clearance_map(std::ostream& out, const ClearanceReport& report,
                        const NearestNames& names);

}  // namespace soms::command
