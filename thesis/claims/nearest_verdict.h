/// \file
/// How the reading nearest to the text stands, beside the verdict over all readings.
///
/// The rule, over the judged rows of the readings nearest to the text. The share is that of the
/// rows that hold, with its Wilson interval of 95 %: the low end is that of the rows that hold, the
/// high end that of the rows that hold or are undecided. Of these the first that is true:
///
/// - cannot be checked: there is no row;
/// - too few rows: of a comparison fewer than kLeastSubjects subjects or kLeastRows rows;
/// - holds: every row holds;
/// - fails: every row fails;
/// - mostly holds: the low end is above 1/2;
/// - mostly fails: the high end is below 1/2;
/// - mixed: some rows hold and some fail;
/// - undecided: all others.
///
/// Rows that count and rows that measure time say different things. Where a claim has both, each
/// kind has its own verdict by the rule above. If both can be judged, but most rows hold in one
/// kind only, then the claim is mixed, whatever the rows together say.
#pragma once

#include "thesis/claims/claim.h"
#include "thesis/trips/statistics.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace soms::reproduce {

/// How the reading nearest to the text stands.
enum class NearestStand {
  holds,              ///< in every row
  mostly_holds,       ///< in more than half of such rows, by the interval
  mixed,              ///< rows hold and fail, and the interval decides nothing
  undecided,          ///< too many measurements lie on both sides of what is claimed
  mostly_fails,       ///< in less than half of such rows, by the interval
  fails,              ///< in every row
  too_few_rows,       ///< a comparison on too few subjects
  cannot_be_checked,  ///< nothing to judge
};

/// All of them, in the order of the enumeration.
inline constexpr std::size_t kNearestStandCount = 8;

/// Rows of the nearest readings that are judged.
struct NearestRows {
  std::size_t hold = 0;
  std::size_t open = 0;  ///< undecided
  std::size_t fail = 0;
  std::size_t subjects = 0;

  [[nodiscard]] std::size_t judged() const { return hold + open + fail; }
};

/// Rows of one kind, with the verdict of these alone.
struct NearestPart {
  NearestRows rows = {};
  NearestStand stand = NearestStand::cannot_be_checked;
};

/// The nearest reading of a claim and its verdict.
struct NearestVerdict {
  std::string options;  ///< `Claim::nearest`
  std::string why;      ///< why it is nearest: a sentence
  NearestRows rows = {};
  Interval share = {0, 1};  ///< 0 to 1 if there is no row
  NearestPart counted = {};
  NearestPart measured = {};
  NearestStand stand = NearestStand::cannot_be_checked;

  /// True if rows of both kinds are judged.
  [[nodiscard]] bool has_both_kinds() const {
    return counted.rows.judged() > 0 && measured.rows.judged() > 0;
  }
};

/// The Wilson interval of 95 % of a share. \pre `hold <= of`, and `of` is not 0.
/// \source Wilson, Probable inference, the law of succession, and statistical inference, 1927.
[[nodiscard]] Interval wilson_interval(std::size_t hold, std::size_t of);

/// The share of the rows that hold, by the rule above; 0 to 1 if there is no row.
[[nodiscard]] Interval share_of(const NearestRows& rows);

/// The verdict of these rows, by the rule above.
[[nodiscard]] NearestStand stand_of(const NearestRows& rows, Scope scope);

/// The verdict of a claim from that of all its nearest rows, `together`, and of both kinds, by the
/// rule above.
[[nodiscard]] NearestStand stand_of(NearestStand together, const NearestPart& counted,
                                    const NearestPart& measured);

/// The nearest reading of a claim with its verdict.
[[nodiscard]] NearestVerdict nearest_of(const Claim& claim);

/// "holds", "mostly holds", "mixed", "undecided", "mostly fails", "fails", "too few rows", "cannot
/// be checked".
[[nodiscard]] std::string_view name(NearestStand stand);

/// "5 of 10 rows"; empty if there is no row.
[[nodiscard]] std::string share_words(const NearestVerdict& nearest);

/// "26 of 28 by counts, 1 of 12 by time"; `share_words` if only one kind of rows is judged.
[[nodiscard]] std::string shares_words(const NearestVerdict& nearest);

/// "Nearest to the text (stop, inner axis): 5 of 10 rows hold, 1 undecided, on 5 subjects; the
/// share is 24 to 83 %. ..." with both kinds, if there are, and the reason at its end.
[[nodiscard]] std::string words_of(const NearestVerdict& nearest);

}  // namespace soms::reproduce
