/// \file
/// Where answers of `overlap` go: standard output, and the files of --report, --csv and --binary.
#pragma once

#include "apps/output/output.h"
#include "apps/soms/answers/answer_columns.h"
#include "apps/soms/pairs/overlap.h"
#include "apps/soms/pairs/overlap_page.h"
#include "apps/soms/pairs/overlap_parts.h"
#include "apps/soms/pairs/overlap_report.h"

#include <optional>

namespace soms::command {

class OverlapOutput {
 public:
  /// Opens the files: one that cannot be written is an error before the work, not after it.
  /// \errors ErrorKind::cannot_write.
  explicit OverlapOutput(const OverlapVerbOptions& options);

  /// Before the first answer. `report` must stay, as must its meshes.
  void begin(const OverlapReport& report);

  /// Adds the answer of pose number `pose` to each output. `right` is as in `print_answer`.
  /// \errors ErrorKind::cannot_write; ErrorKind::cancelled, before anything is added; ClosedPipe.
  void add(std::uint64_t pose, const Pose& a, const Pose& b, const CountedAnswer& result,
           bool right, Console& console);

  /// Makes the files appear.
  /// \errors As `add`.
  void finish(const RowTotals& totals);

 private:
  std::string name_a_;
  std::string name_b_;
  std::optional<OutputFile> page_file_;
  std::optional<OutputFile> csv_file_;
  OverlapColumns columns_;
  const OverlapReport* report_ = nullptr;
  PartsOf parts_a_;
  PartsOf parts_b_;
  std::optional<OverlapPage> page_;
};

}  // namespace soms::command
