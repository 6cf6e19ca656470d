/// \file
/// The page of overlap answers: what -o FILE.html writes.
#pragma once

#include "soms/base/pose.h"
#include "soms/query/overlap.h"

#include "apps/report/page.h"
#include "apps/soms/pairs/overlap_report.h"
#include "apps/soms/pairs/overlap_rows.h"
#include "apps/soms/pairs/pair_page.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace soms::command {

/// Remembers answers as they come, however many: figures and pairs of parts of all; poses, and
/// pairs of triangles, of as many as a page has room for.
class OverlapPage {
 public:
  explicit OverlapPage(PageModels models);

  /// The pairs of parts of the next answer, as `add` takes them.
  /// \errors ErrorKind::cancelled.
  [[nodiscard]] std::vector<PartPair> parts(const Pose& a, const Pose& b, const Overlap& answer,
                                            const Limits& limits) const;

  /// Adds the answer of the next pose. `parts` are those of `parts`, or of `part_pairs`.
  void add(const Pose& a, const Pose& b, const Overlap& answer, std::span<const PartPair> parts);

  /// Writes the page of the answers so far.
  void write(std::ostream& out, const OverlapReport& report, const RowTotals& totals) const;

 private:
  void count_pairs(std::uint64_t pose, const Overlap& answer);
  void add_rows(report::Scene& scene) const;
  [[nodiscard]] bool is_complete(const OverlapReport& report) const;
  [[nodiscard]] report::Scene scene(const OverlapReport& report) const;
  [[nodiscard]] std::string lead(const report::Scene& scene, const RowTotals& totals) const;
  [[nodiscard]] std::vector<report::Plot> plots() const;
  [[nodiscard]] std::vector<report::Fact> facts(const OverlapReport& report,
                                                const RowTotals& totals) const;

  PageModels models_;
  std::uint64_t pairs_ = 0;
  bool complete_ = true;  ///< no answer was cut or stopped at its first pair
  Cost cost_;
  PoseTrack track_;
  OverlapRows rows_;
  std::vector<std::uint64_t> counts_;  ///< pairs: the most of each few poses
  std::uint64_t poses_of_count_ = 1;
};

}  // namespace soms::command
