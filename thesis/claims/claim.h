/// \file
/// A claim of the thesis as a matrix of readings and metrics, and the verdict that follows from it.
///
/// The rule: each row holds a number, a range the claim demands of it, and for a measured number
/// its 95 % interval. A row holds if its whole interval lies inside the range, fails if all of it
/// lies outside, and is undecided if it lies across an end. A measured row counts as decided only
/// if it rests on at least kLeastProcesses processes. Over all readings the claim then
///
/// - holds in all readings, if every row that is judged holds;
/// - holds under some readings, if not all rows hold, but whole lines do, with at least kLeastRows
///   rows together. A line is all rows of one metric, reading and demand. It is whole if every row
///   of it holds and, for a comparison, if it has at least kLeastSubjects subjects;
/// - holds on some subjects, if rows hold, but too few in whole lines;
/// - does not hold in any reading, if every row fails;
/// - is undecided, if no row holds and at least one is undecided;
/// - cannot be checked, if there is no row to judge.
///
/// The reading nearest to the text has a verdict of its own (nearest_verdict.h). Which subjects are
/// judged is one rule for all claims (judged_subjects.h).
#pragma once

#include "thesis/trips/statistics.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// How a row of a matrix, or a whole claim, stands.
enum class Verdict {
  holds,              ///< in all readings
  holds_under,        ///< in some of the readings that the thesis leaves open, on all subjects
  holds_on_some,      ///< on some models or trips, in no reading on enough of them
  undecided,          ///< measurements lie on both sides of what is claimed
  does_not_hold,      ///< in no reading
  cannot_be_checked,  ///< what it was measured on is not available
};

/// All verdicts, in the order of the enumeration.
inline constexpr std::size_t kVerdictCount = 6;

/// What a claim says something about.
enum class Scope {
  comparison,  ///< more, less, faster, earlier: of models in general, judged on every model
  figure,      ///< a number of one named model, judged on that model alone
};

/// The least number of subjects from which a comparison follows, and of rows.
inline constexpr std::size_t kLeastSubjects = 3;
inline constexpr std::size_t kLeastRows = 3;

/// The least number of processes that a measured row rests on if it decides.
inline constexpr int kLeastProcesses = 5;

/// What a row's subject is.
enum class SubjectKind {
  given,     ///< a model that was read, a generated sweep, or a trip
  stand_in,  ///< made in the place of a model that was not given
  toy_set,   ///< made by this project to show a picture
};

/// The open range a number must lie in: above one bound, below another.
struct Demand {
  double above = -std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();
};

/// One reading of a claim by one metric on one subject.
struct ClaimRow {
  std::string
      reading;  ///< how what the thesis leaves open is settled: "empty side stop, inner axis"
  std::string metric;   ///< what is counted or measured: "leaves with one triangle, SOMS - spatial"
  std::string subject;  ///< on what: a model, or a trip
  std::string unit = {};
  Demand demand = {};
  double value = 0;
  std::optional<Interval> interval = std::nullopt;  ///< of a measured value; nothing for a count
  int rounds = 0;                                   ///< measurements behind it; 0 for a count
  int processes = 0;                                ///< that they come from; 0 for a count
  std::string unjudged = {};  ///< why this row is shown but not judged; empty if it is judged
  SubjectKind kind = SubjectKind::given;
  std::size_t triangles = 0;  ///< of the subject's model, where a figure names it by them
  bool on_stand_in = false;   ///< not judged for no other reason than that it is on a stand-in
  bool is_nearest = false;    ///< of a reading nearest to the text that `Claim::nearest` describes
};

/// Whose verdict was another one in the first edition of the page, and why it changed.
struct Revision {
  Verdict before = Verdict::cannot_be_checked;  ///< holds, holds_under, does_not_hold
  std::string reason;  ///< a clause: "it raced one kind of depth-first traversal"
};

/// A claim of the thesis.
struct Claim {
  std::string id;         ///< snake_case, unique: "more_single_triangle_leaves"
  std::string statement;  ///< in our words
  std::string source;     ///< where the thesis says so: "abstract", "table 5.9 by its caption"
  std::vector<ClaimRow> rows = {};
  Scope scope = Scope::comparison;
  std::size_t named_triangles = 0;  ///< of the one model that a figure is about
  /// The readings nearest to the text: all that the text or a caption states as it states it, the
  /// rest at the defaults. Rows are nearest if their readings begin with it, or by their flag.
  std::string nearest = {};
  std::string why_nearest = {};  ///< a sentence: why these readings are nearest
  std::string note = {};         ///< computed, beside the verdict
  std::string why = {};          ///< what explains the numbers, true whatever the verdict
  std::string settles = {};      ///< what would settle what is open; empty if nothing is
  std::optional<Revision> revision = std::nullopt;
};

/// How a row stands: holds, undecided or does_not_hold; cannot_be_checked if it is not judged.
/// Numbers are taken as the CSV has them, with six significant digits.
[[nodiscard]] Verdict stand_of(const ClaimRow& row);

/// How its number stands, whether or not the row is judged.
[[nodiscard]] Verdict stand_of_number(const ClaimRow& row);

/// True if a measured row rests on enough processes to decide, and for every count.
[[nodiscard]] bool rests_on_enough(const ClaimRow& row);

/// "holds", "undecided", "fails", or "not judged".
[[nodiscard]] std::string_view stand_word(const ClaimRow& row);

/// What follows from the rows, by the rule above.
[[nodiscard]] Verdict verdict_of(const Claim& claim);

/// True if a row's reading is one of those nearest to the text.
[[nodiscard]] bool is_nearest(const Claim& claim, const ClaimRow& row);

/// Where it holds, from the rows alone: in how many, and the readings of which every row, some or
/// none holds.
[[nodiscard]] std::string where(const Claim& claim);

/// The subjects of a claim, each once, in the order of its rows.
[[nodiscard]] std::vector<std::string> subjects_of(const Claim& claim);

/// The rows by line of the matrix: those of one metric, reading and demand, on all subjects.
[[nodiscard]] std::vector<std::vector<const ClaimRow*>> lines_of(const Claim& claim);

/// True if a row was measured, not counted.
[[nodiscard]] bool is_timed(const Claim& claim);

/// How many rows are judged, and how many of them hold.
struct JudgedRows {
  std::size_t judged = 0;
  std::size_t hold = 0;
};

[[nodiscard]] JudgedRows judged_rows(const Claim& claim);

/// Rows that are not judged for no other reason than that their model is a stand-in.
struct OnStandIns {
  std::size_t rows = 0;
  std::size_t hold = 0;  ///< those that would hold
};

[[nodiscard]] OnStandIns on_stand_ins(const Claim& claim);

/// "On stand-ins, which decide nothing: 12 of 44 rows would hold."; empty if there are none.
[[nodiscard]] std::string stand_in_words(const Claim& claim);

/// "27 of 75 rows": how many of the rows that are judged hold.
[[nodiscard]] std::string share_words(const Claim& claim);

/// "holds in all readings", "holds under some readings", "holds on some subjects", "undecided",
/// "does not hold in any reading", "cannot be checked".
[[nodiscard]] std::string_view name(Verdict verdict);

/// "comparison", "figure".
[[nodiscard]] std::string_view name(Scope scope);

/// A row that counts, and one that was measured.
[[nodiscard]] ClaimRow counted_row(std::string reading, std::string metric, std::string subject,
                                   std::string unit, Demand demand, double value);
[[nodiscard]] ClaimRow measured_row(std::string reading, std::string metric, std::string subject,
                                    std::string unit, Demand demand, const Estimate& estimate);

/// "> 8", "< 1", "21 to 31".
[[nodiscard]] std::string words_of(const Demand& demand);

/// "+26.4 %" or "0.931 (0.92 to 0.94)": a row's number for people.
[[nodiscard]] std::string words_of(const ClaimRow& row);

}  // namespace soms::reproduce
