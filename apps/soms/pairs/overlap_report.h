/// \file
/// Answers of the verb `overlap` as text and as JSON Lines.
#pragma once

#include "soms/query/overlap.h"

#include "apps/rows/row_run.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/pairs/traversal_by_name.h"

#include <cstdint>
#include <span>

namespace soms::command {

class Console;
struct PartPair;

/// What is reported about the answer of one pose, and how.
struct OverlapReport {
  const PairReport& pair;
  OverlapMode mode = OverlapMode::all;
  bool list_pairs = true;
  bool by_part = false;  ///< pairs of parts are listed, not of triangles
};

/// True if the answer was cut before any pair was found.
[[nodiscard]] bool is_undecided(const Overlap& answer);

/// Prints the answer of pose number `pose`: JSON with --json, text without. `right` says whether
/// brute force agrees, where requested. `parts` are those of the answer, for `report.by_part`.
void print_answer(const OverlapReport& report, std::uint64_t pose, const CountedAnswer& result,
                  bool right, Console& console, std::span<const PartPair> parts = {});

/// Prints a line over all poses as text, where there may be several.
void print_totals(const OverlapReport& report, const RowTotals& totals, Console& console);

}  // namespace soms::command
