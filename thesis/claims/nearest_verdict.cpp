#include "thesis/claims/nearest_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace soms::reproduce {

namespace {

constexpr double kNormal95 = 1.959963984540054;  ///< of the normal distribution, both sides
constexpr double kHalf = 0.5;

/// The rows of one kind, or of both, with their verdict.
class RowTally {
 public:
  void add(const ClaimRow& row) {
    const Verdict stand = stand_of(row);
    rows_.hold += stand == Verdict::holds ? 1U : 0U;
    rows_.open += stand == Verdict::undecided ? 1U : 0U;
    rows_.fail += stand == Verdict::does_not_hold ? 1U : 0U;
    subjects_.insert(row.subject);
    rows_.subjects = subjects_.size();
  }

  [[nodiscard]] NearestPart part(Scope scope) const { return {rows_, stand_of(rows_, scope)}; }

 private:
  NearestRows rows_;
  std::set<std::string_view> subjects_;
};

bool is_judged(NearestStand stand) {
  return stand != NearestStand::too_few_rows && stand != NearestStand::cannot_be_checked;
}

bool mostly_holds(NearestStand stand) {
  return stand == NearestStand::holds || stand == NearestStand::mostly_holds;
}

}  // namespace

Interval wilson_interval(std::size_t hold, std::size_t of) {
  const auto n = static_cast<double>(of);
  const double share = static_cast<double>(hold) / n;
  const double z2 = kNormal95 * kNormal95;
  const double middle = share + z2 / (2 * n);
  const double reach = kNormal95 * std::sqrt(share * (1 - share) / n + z2 / (4 * n * n));
  const double scale = 1 + z2 / n;
  // Of none and of all the ends are 0 and 1; rounding would miss them.
  return {hold == 0 ? 0 : (middle - reach) / scale, hold == of ? 1 : (middle + reach) / scale};
}

Interval share_of(const NearestRows& rows) {
  return rows.judged() == 0 ? Interval{0, 1}
                            : Interval{wilson_interval(rows.hold, rows.judged()).low,
                                       wilson_interval(rows.hold + rows.open, rows.judged()).high};
}

NearestStand stand_of(const NearestRows& rows, Scope scope) {
  const std::size_t judged = rows.judged();
  if (judged == 0) {
    return NearestStand::cannot_be_checked;
  }
  if (scope == Scope::comparison && (rows.subjects < kLeastSubjects || judged < kLeastRows)) {
    return NearestStand::too_few_rows;
  }
  if (rows.hold == judged || rows.fail == judged) {
    return rows.hold == judged ? NearestStand::holds : NearestStand::fails;
  }
  const Interval share = share_of(rows);
  if (share.low > kHalf || share.high < kHalf) {
    return share.low > kHalf ? NearestStand::mostly_holds : NearestStand::mostly_fails;
  }
  return rows.hold > 0 && rows.fail > 0 ? NearestStand::mixed : NearestStand::undecided;
}

NearestStand stand_of(NearestStand together, const NearestPart& counted,
                      const NearestPart& measured) {
  const bool differ = is_judged(counted.stand) && is_judged(measured.stand) &&
                      mostly_holds(counted.stand) != mostly_holds(measured.stand);
  return differ ? NearestStand::mixed : together;
}

NearestVerdict nearest_of(const Claim& claim) {
  RowTally all;
  RowTally counted;
  RowTally measured;
  for (const ClaimRow& row : claim.rows) {
    if (row.unjudged.empty() && is_nearest(claim, row)) {
      all.add(row);
      (row.interval ? measured : counted).add(row);
    }
  }
  NearestVerdict nearest{.options = claim.nearest,
                         .why = claim.why_nearest,
                         .counted = counted.part(claim.scope),
                         .measured = measured.part(claim.scope)};
  const NearestPart together = all.part(claim.scope);
  nearest.rows = together.rows;
  nearest.share = share_of(nearest.rows);
  nearest.stand = stand_of(together.stand, nearest.counted, nearest.measured);
  return nearest;
}

std::string_view name(NearestStand stand) {
  constexpr std::array<std::string_view, kNearestStandCount> kNames{
      "holds",        "mostly holds", "mixed",        "undecided",
      "mostly fails", "fails",        "too few rows", "cannot be checked"};
  return kNames[static_cast<std::size_t>(stand)];
}

std::string share_words(const NearestVerdict& nearest) {
  const std::size_t judged = nearest.rows.judged();
  return judged == 0 ? std::string() : fmt::format("{} of {} rows", nearest.rows.hold, judged);
}

std::string shares_words(const NearestVerdict& nearest) {
  const auto words = [](const NearestPart& part) {
    return fmt::format("{} of {}", part.rows.hold, part.rows.judged());
  };
  return nearest.has_both_kinds() ? fmt::format("{} by counts, {} by time", words(nearest.counted),
                                                words(nearest.measured))
                                  : share_words(nearest);
}

std::string words_of(const NearestVerdict& nearest) {
  const NearestRows& rows = nearest.rows;
  std::string text = fmt::format("Nearest to the text ({}): ", nearest.options);
  if (rows.judged() == 0) {
    text += "no row can be judged.";
  } else {
    text += fmt::format(
        "{} hold{}, on {} subject{}; the share is {:.0f} to {:.0f} %.", share_words(nearest),
        rows.open == 0 ? "" : fmt::format(", {} undecided", rows.open), rows.subjects,
        rows.subjects == 1 ? "" : "s", 100 * nearest.share.low, 100 * nearest.share.high);
  }
  if (nearest.has_both_kinds()) {
    text += fmt::format(" By kind: {} ({}, {}).", shares_words(nearest),
                        name(nearest.counted.stand), name(nearest.measured.stand));
  }
  return nearest.why.empty() ? text : fmt::format("{} {}", text, nearest.why);
}

}  // namespace soms::reproduce
