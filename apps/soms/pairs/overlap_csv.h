/// \file
/// `overlap --csv`: answers as a table for spreadsheets and scripts.
#pragma once

#include "apps/soms/pairs/overlap_parts.h"
#include "apps/soms/pairs/overlap_report.h"

#include <cstdint>
#include <ostream>
#include <span>

namespace soms::command {

/// The first line: names of the columns.
void write_csv_head(std::ostream& out, const OverlapReport& report);

/// A row for each pair of triangles of pose number `pose`, or with `report.by_part` for each pair
/// of parts.
void write_csv_rows(std::ostream& out, const OverlapReport& report, std::uint64_t pose,
                    const PosedParts& a, const PosedParts& b, const Overlap& answer,
                    std::span<const PartPair> parts);

}  // namespace soms::command
