#include "reproduce/nearest_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace soms::reproduce {

namespace {

constexpr double kNormal95 = 1.959963984540054;  ///< of the normal distribution, both sides
constexpr double kHalf = 0.5;

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

NearestVerdict nearest_of(const Claim& claim) {
  NearestVerdict nearest{.options = claim.nearest, .why = claim.why_nearest};
  std::set<std::string_view> subjects;
  for (const ClaimRow& row : claim.rows) {
    if (!row.unjudged.empty() || !is_nearest(claim, row)) {
      continue;
    }
    const Verdict stand = stand_of(row);
    nearest.rows.hold += stand == Verdict::holds ? 1U : 0U;
    nearest.rows.open += stand == Verdict::undecided ? 1U : 0U;
    nearest.rows.fail += stand == Verdict::does_not_hold ? 1U : 0U;
    subjects.insert(row.subject);
  }
  nearest.rows.subjects = subjects.size();
  nearest.share = share_of(nearest.rows);
  nearest.stand = stand_of(nearest.rows, claim.scope);
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
  return nearest.why.empty() ? text : fmt::format("{} {}", text, nearest.why);
}

}  // namespace soms::reproduce
