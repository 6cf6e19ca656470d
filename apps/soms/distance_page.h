/// \file
/// The page of distances: what `distance --report` writes.
#pragma once

#include "soms/query/distance.h"

#include "apps/report/page.h"
#include "apps/soms/pair_page.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace soms::command {

/// Remembers answers as they come, however many: figures of all; poses, and nearest points, of the
/// nearest that a page has room for.
class DistancePage {
 public:
  /// The meshes of `models` must stay.
  explicit DistancePage(PageModels models);

  /// Adds the answer of the next pose.
  void add(const Pose& a, const Pose& b, const Distance& answer);

  /// Writes the page of the answers so far; `answer` is what they come to, in words.
  void write(std::ostream& out, const PairReport& report, const RowTotals& totals,
             const std::string& answer) const;

 private:
  /// A distance that is known, and where.
  struct Near {
    Bracket distance;
    std::uint64_t pose = 0;
    TrianglePair triangles;
    Vec3 point_a;
    Vec3 point_b;
    PosesOfPair poses;

    [[nodiscard]] bool touches() const { return distance.upper == 0; }

    /// Nearest first; of equally near ones the first pose.
    [[nodiscard]] bool operator<(const Near& other) const;
  };

  /// Of some poses one after the other; not numbers where none is known.
  struct Extremes {
    double least = std::numeric_limits<double>::quiet_NaN();
    double greatest = std::numeric_limits<double>::quiet_NaN();

    void grow(const Extremes& other);
  };

  void follow(std::uint64_t pose, const Extremes& distance);
  void add_overlaps(report::Scene& scene, const std::vector<Near>& nearest) const;
  [[nodiscard]] report::Scene scene(const std::vector<Near>& nearest) const;
  [[nodiscard]] report::Table table(const std::vector<Near>& nearest) const;
  [[nodiscard]] std::vector<report::Plot> plots() const;

  PageModels models_;
  PoseTrack track_;
  bool complete_ = true;  ///< no answer was cut
  Cost cost_;
  std::vector<Near> nearest_;  ///< a heap, the farthest on top
  std::uint64_t known_ = 0;    ///< distances
  std::uint64_t overlaps_ = 0;
  std::uint64_t first_overlap_ = 0;
  std::uint64_t last_overlap_ = 0;
  std::vector<Extremes> course_;  ///< of a few poses each
  std::uint64_t poses_of_point_ = 1;
};

}  // namespace soms::command
