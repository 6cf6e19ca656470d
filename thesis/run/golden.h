/// \file
/// This program's counts beside those of the golden tables.
#pragma once

#include "soms/base/limits.h"

#include "thesis/run/golden_tables.h"
#include "thesis/trips/models.h"

#include <cstddef>
#include <string>
#include <vector>

namespace soms::reproduce {

/// A row whose counts are not this program's.
struct GoldenDifference {
  std::string file;
  std::size_t line = 0;
  std::string row;   ///< what was counted: "bunny soms thesis inner stop level 15"
  std::string what;  ///< "leaves 924, here 923"
};

/// A golden table after the comparison.
struct GoldenFile {
  std::string file;
  std::size_t rows = 0;
  std::size_t compared = 0;
  std::size_t different = 0;
};

/// A model that the golden tables count and the run does not have.
struct NotGiven {
  std::string model;
  std::size_t rows = 0;  ///< of both tables; a trip's rows count for the first model that lacks
};

/// What a comparison found.
struct GoldenComparison {
  std::vector<GoldenFile> files = {};
  std::vector<GoldenDifference> differences = {};  ///< the first `kMostDifferences`
  std::vector<NotGiven> not_given = {};
  bool whole = true;  ///< false if it was stopped before the last row
  double seconds = 0;

  [[nodiscard]] std::size_t rows() const;
  [[nodiscard]] std::size_t compared() const;
  [[nodiscard]] std::size_t different() const;
};

/// Differences that are named one by one.
inline constexpr std::size_t kMostDifferences = 20;

/// Counts every row again whose models are there, by the hashes of their corners: each tree is
/// built to its own level, each trip traversed by its own algorithm. A stop request ends it early.
[[nodiscard]] GoldenComparison compare_with_golden(const GoldenTables& tables, const Models& models,
                                                   const Limits& limits);

/// "thesis_counts.csv, line 5: bunny soms thesis inner stop level 4: leaves 9, here 8".
[[nodiscard]] std::string sentence_of(const GoldenDifference& difference);

/// "8,961 of 8,961 rows compared: all equal"; says how many differ and what was not compared.
[[nodiscard]] std::string summary_of(const GoldenComparison& comparison);

/// The section of the page: the summary, and, folded, a line for each file, the differences and the
/// models that are not given.
[[nodiscard]] std::string markup_of(const GoldenComparison& comparison);

}  // namespace soms::reproduce
