/// \file
/// What pages about two models at rows of poses share, whatever the question is.
#pragma once

#include "soms/base/pose.h"

#include "apps/report/page.h"
#include "apps/rows/row_run.h"
#include "apps/soms/pairs/pair_report.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

/// Poses of A and B.
using PosesOfPair = std::pair<Pose, Pose>;

/// Two models as a page names them.
struct PageModels {
  ModelShape a;
  std::string name_a;
  ModelShape b;
  std::string name_b;
};

/// Poses of as many rows as a page has room for: every so many.
class PoseTrack {
 public:
  /// Adds the poses of the next row.
  void add(const PosesOfPair& poses);

  [[nodiscard]] std::uint64_t rows() const { return rows_; }

  /// By number of row.
  [[nodiscard]] const std::map<std::uint64_t, PosesOfPair>& kept() const { return kept_; }

 private:
  std::map<std::uint64_t, PosesOfPair> kept_;
  std::uint64_t rows_ = 0;
  std::uint64_t pause_ = 1;  ///< between those that are kept
};

/// The models at the poses of `kept`, of `rows` in all; nothing touches yet.
[[nodiscard]] report::Scene scene_of_pair(const PageModels& models,
                                          std::map<std::uint64_t, PosesOfPair> kept,
                                          std::uint64_t rows);

/// What the models are, and what reading them noted.
[[nodiscard]] std::vector<report::Fact> facts_of_models(const PageModels& models,
                                                        const PairReport& report);

/// What is said of poses for which the answer is yes, and of the others.
struct PoseWords {
  std::string yes = "with overlap";
  std::string no = "without";
};

/// "interrupted after 7: 2 with overlap, 4 without, 1 undecided".
[[nodiscard]] report::Fact fact_of_poses(const PairReport& report, const RowTotals& totals,
                                         const PoseWords& words = {});

/// Tests, and what brute force said with --verify.
[[nodiscard]] std::vector<report::Fact> facts_of_work(const PairReport& report,
                                                      const RowTotals& totals, const Cost& cost);

}  // namespace soms::command
