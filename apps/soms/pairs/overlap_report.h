/// \file
/// Answers of the verb `overlap` as text and as JSON.
#pragma once

#include "soms/query/overlap.h"

#include "apps/cli/terminal.h"
#include "apps/rows/question.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/pairs/traversal_by_name.h"

#include <cstdint>
#include <span>
#include <string>

namespace soms::command {

class JsonRows;
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

/// Writes the answer of a row as JSON. `parts` are those of the answer, for `report.by_part`.
void write_json(const OverlapReport& report, const AnsweredRow& row, const CountedAnswer& result,
                JsonRows& rows, std::span<const PartPair> parts);

/// The same as text.
[[nodiscard]] std::string text_of(const OverlapReport& report, std::uint64_t pose,
                                  const CountedAnswer& result, std::span<const PartPair> parts,
                                  const Terminal& terminal);

/// A line over all poses.
[[nodiscard]] std::string text_of(const RowTotals& totals);

}  // namespace soms::command
