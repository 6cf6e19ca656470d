/// \file
/// The page of how near two models are: what `distance` and `within` write to -o FILE.html.
#pragma once

#include "soms/base/bracket.h"
#include "soms/query/answer.h"

#include "apps/report/page.h"
#include "apps/soms/pairs/near_output.h"
#include "apps/soms/pairs/pair_page.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace soms::command {

/// How a page words the answers to a question.
struct NearWords {
  std::string lead = {};
  std::string note = {};
  PoseWords poses = {};
  report::Noun touching = {};  ///< poses with distance 0; empty: which they are is not known
  std::string table = {};      ///< its title
  std::string column = {};     ///< title of the answers
  std::string named = {};      ///< before the length of a pair: "yes, at most "
  std::string apart = {};  ///< before a lower bound: "no, at least "; empty: bounds are not shown
  std::string order = {};  ///< which rows come first
  std::string plot = {};   ///< its title
  std::string least = {};  ///< name of the line of the least length in some poses
  std::string greatest = {};  ///< of the greatest, or of the lower bounds
  std::string each = {};      ///< caption of a plot of each pose
  std::string of_few = {};    ///< of one that merges some poses; ends before "N poses each."
};

/// An answer as a page shows it.
struct NearFinding {
  NearPair pair = {};   ///< without triangles where the answer names none, or is undecided
  Bracket length = {};  ///< of the pair
  double at_least = 0;  ///< without a pair: a lower bound of the distance
  Coverage coverage = Coverage::complete;
  Cost cost = {};
};

/// Remembers answers as they come, however many: figures of all; poses, and nearest points, of the
/// nearest that a page has room for.
class NearPage {
 public:
  /// The meshes of `models` must stay.
  NearPage(PageModels models, NearWords words);

  /// Adds the answer of the next pose.
  void add(const PosesOfPair& poses, const NearFinding& finding);

  /// Writes the page of the answers so far; `answer` is what they come to, in words.
  void write(std::ostream& out, const PairReport& report, const RowTotals& totals,
             const std::string& answer) const;

 private:
  /// A pair that is named, and where.
  struct Near {
    Bracket length;
    std::uint64_t pose = 0;
    TrianglePair triangles;
    Vec3 point_a;
    Vec3 point_b;
    PosesOfPair poses;

    [[nodiscard]] bool touches() const { return length.upper == 0; }

    /// Nearest first; of equally near ones the first pose.
    [[nodiscard]] bool operator<(const Near& other) const;
  };

  /// A pose without a pair.
  struct Apart {
    std::uint64_t pose = 0;
    double at_least = 0;
    bool undecided = false;
  };

  /// Of some poses one after the other; not numbers where none is known.
  struct Extremes {
    double least = std::numeric_limits<double>::quiet_NaN();
    double greatest = std::numeric_limits<double>::quiet_NaN();

    void grow(const Extremes& other);
  };

  [[nodiscard]] bool has_bounds() const { return !words_.apart.empty(); }

  void keep(const Near& near);
  void follow(std::uint64_t pose, const Extremes& distance);
  void add_overlaps(report::Scene& scene, const std::vector<Near>& nearest) const;
  [[nodiscard]] report::Scene scene(const std::vector<Near>& nearest) const;
  [[nodiscard]] std::string caption(std::size_t rows) const;
  [[nodiscard]] report::Table table(const std::vector<Near>& nearest) const;
  [[nodiscard]] std::vector<report::Plot> plots() const;

  PageModels models_;
  NearWords words_;
  PoseTrack track_;
  bool complete_ = true;  ///< no answer was cut
  Cost cost_;
  std::vector<Near> nearest_;  ///< a heap, the farthest on top
  std::uint64_t known_ = 0;    ///< pairs that were named
  std::vector<Apart> apart_;   ///< the first
  std::uint64_t overlaps_ = 0;
  std::uint64_t first_overlap_ = 0;
  std::uint64_t last_overlap_ = 0;
  std::vector<Extremes> course_;  ///< of a few poses each
  std::uint64_t poses_of_point_ = 1;
};

}  // namespace soms::command
