/// \file
/// `overlap --by part`: answers as pairs of parts, in text and in JSON.
#pragma once

#include "apps/soms/pairs/overlap_parts.h"
#include "apps/soms/pairs/overlap_report.h"

#include <span>

namespace soms::command {

/// The pairs of parts as text: how many, and with `report.single` one line each.
void print_parts_as_text(const OverlapReport& report, const Overlap& answer,
                         std::span<const PartPair> parts, Console& console);

/// The key "parts" and its value, with a comma before.
void print_parts_as_json(const OverlapReport& report, std::span<const PartPair> parts,
                         Console& console);

}  // namespace soms::command
