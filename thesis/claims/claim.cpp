#include "thesis/claims/claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace soms::reproduce {

namespace {

/// Readings that are named in a sentence; the matrix has them all.
constexpr std::size_t kNamed = 4;

/// The number as the CSV has it.
double written(double number) {
  const std::string digits = fmt::format("{:.6g}", number);
  double value = number;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

/// A line of the matrix: the rows of one reading by one metric, on all subjects that are judged.
struct Group {
  std::string name;
  std::size_t rows = 0;
  std::size_t hold = 0;
};

/// The lines that have a row to judge; named by the reading alone if the claim has one metric.
std::vector<Group> groups_of(const Claim& claim) {
  std::set<std::string_view> metrics;
  for (const ClaimRow& row : claim.rows) {
    if (row.unjudged.empty()) {
      metrics.insert(row.metric);
    }
  }
  std::vector<Group> groups;
  for (const std::vector<const ClaimRow*>& line : lines_of(claim)) {
    const ClaimRow& first = *line.front();
    Group group{first.reading.empty() ? first.metric
                : metrics.size() == 1 ? first.reading
                                      : fmt::format("{}: {}", first.reading, first.metric)};
    for (const ClaimRow* row : line) {
      group.rows += row->unjudged.empty() ? 1U : 0U;
      group.hold += stand_of(*row) == Verdict::holds ? 1U : 0U;
    }
    if (group.rows > 0) {
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

std::size_t count_of(const Claim& claim, Verdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(claim.rows.begin(), claim.rows.end(),
                    [&](const ClaimRow& row) { return stand_of(row) == verdict; }));
}

/// "a; b; c; and 4 more".
std::string listed(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), kNamed);
  std::string text = fmt::format(
      "{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), "; "));
  if (shown < names.size()) {
    text += fmt::format("; and {} more", names.size() - shown);
  }
  return text;
}

/// True if whole lines have enough rows together: one chance line decides nothing.
bool has_whole_lines(const Claim& claim) {
  std::size_t rows = 0;
  for (const std::vector<const ClaimRow*>& line : lines_of(claim)) {
    std::size_t hold = 0;
    std::size_t judged = 0;
    std::set<std::string_view> subjects;
    for (const ClaimRow* const row : line) {
      if (row->unjudged.empty()) {
        ++judged;
        hold += stand_of(*row) == Verdict::holds ? 1U : 0U;
        subjects.insert(row->subject);
      }
    }
    const bool enough = claim.scope == Scope::figure || subjects.size() >= kLeastSubjects;
    rows += hold == judged && enough ? hold : 0;
  }
  return rows >= kLeastRows;
}

}  // namespace

bool is_nearest(const Claim& claim, const ClaimRow& row) {
  if (row.is_nearest || claim.nearest.empty() || !row.reading.starts_with(claim.nearest)) {
    return row.is_nearest;
  }
  // "level 1" is not how "level 12" begins.
  const std::string_view rest = std::string_view(row.reading).substr(claim.nearest.size());
  return rest.empty() || std::isalnum(static_cast<unsigned char>(rest.front())) == 0;
}

bool rests_on_enough(const ClaimRow& row) {
  return !row.interval || row.processes >= kLeastProcesses;
}

Verdict stand_of(const ClaimRow& row) {
  return row.unjudged.empty() ? stand_of_number(row) : Verdict::cannot_be_checked;
}

Verdict stand_of_number(const ClaimRow& row) {
  if (!rests_on_enough(row)) {
    return Verdict::undecided;
  }
  const Interval range = row.interval.value_or(Interval{row.value, row.value});
  const double low = written(range.low);
  const double high = written(range.high);
  if (low > row.demand.above && high < row.demand.below) {
    return Verdict::holds;
  }
  return high <= row.demand.above || low >= row.demand.below ? Verdict::does_not_hold
                                                             : Verdict::undecided;
}

std::string_view stand_word(const ClaimRow& row) {
  switch (stand_of(row)) {
    case Verdict::holds:
      return "holds";
    case Verdict::undecided:
      return "undecided";
    case Verdict::does_not_hold:
      return "fails";
    default:
      return "not judged";
  }
}

Verdict verdict_of(const Claim& claim) {
  const std::size_t hold = count_of(claim, Verdict::holds);
  const std::size_t open = count_of(claim, Verdict::undecided);
  const std::size_t fail = count_of(claim, Verdict::does_not_hold);
  if (hold + open + fail == 0) {
    return Verdict::cannot_be_checked;
  }
  if (hold > 0) {
    return open + fail == 0         ? Verdict::holds
           : has_whole_lines(claim) ? Verdict::holds_under
                                    : Verdict::holds_on_some;
  }
  return open > 0 ? Verdict::undecided : Verdict::does_not_hold;
}

OnStandIns on_stand_ins(const Claim& claim) {
  OnStandIns found;
  for (const ClaimRow& row : claim.rows) {
    if (row.on_stand_in) {
      ++found.rows;
      found.hold += stand_of_number(row) == Verdict::holds ? 1U : 0U;
    }
  }
  return found;
}

std::string stand_in_words(const Claim& claim) {
  const OnStandIns found = on_stand_ins(claim);
  return found.rows == 0
             ? std::string()
             : fmt::format("On stand-ins, which decide nothing: {} of {} rows would hold.",
                           found.hold, found.rows);
}

JudgedRows judged_rows(const Claim& claim) {
  return {claim.rows.size() - count_of(claim, Verdict::cannot_be_checked),
          count_of(claim, Verdict::holds)};
}

std::string share_words(const Claim& claim) {
  const JudgedRows rows = judged_rows(claim);
  return rows.judged == 0 ? std::string() : fmt::format("{} of {} rows", rows.hold, rows.judged);
}

std::string where(const Claim& claim) {
  const auto [judged, hold] = judged_rows(claim);
  if (judged == 0) {
    return "No row of its matrix can be judged.";
  }
  const std::size_t open = count_of(claim, Verdict::undecided);
  std::string text = fmt::format("Holds in {} of {} rows{}.", hold, judged,
                                 open == 0 ? "" : fmt::format(", undecided in {}", open));
  const Verdict verdict = verdict_of(claim);
  if (verdict != Verdict::holds_under && verdict != Verdict::holds_on_some) {
    return text;
  }
  std::vector<std::string> everywhere;
  std::vector<std::string> somewhere;
  std::vector<std::string> nowhere;
  for (const Group& group : groups_of(claim)) {
    if (group.hold == group.rows) {
      everywhere.push_back(fmt::format("{} ({})", group.name, group.rows));
    } else if (group.hold == 0) {
      nowhere.push_back(group.name);
    } else {
      somewhere.push_back(fmt::format("{} ({} of {})", group.name, group.hold, group.rows));
    }
  }
  for (const auto& [words, readings] :
       {std::pair("On every subject", &everywhere), std::pair("On some", &somewhere),
        std::pair("On none", &nowhere)}) {
    if (!readings->empty()) {
      text += fmt::format(" {}: {}.", words, listed(*readings));
    }
  }
  return text;
}

std::vector<std::string> subjects_of(const Claim& claim) {
  std::vector<std::string> subjects;
  for (const ClaimRow& row : claim.rows) {
    if (std::find(subjects.begin(), subjects.end(), row.subject) == subjects.end()) {
      subjects.push_back(row.subject);
    }
  }
  return subjects;
}

std::vector<std::vector<const ClaimRow*>> lines_of(const Claim& claim) {
  using ClaimLine = std::vector<const ClaimRow*>;
  std::vector<ClaimLine> lines;
  for (const ClaimRow& row : claim.rows) {
    const auto line = std::find_if(lines.begin(), lines.end(), [&](const ClaimLine& other) {
      return other[0]->metric == row.metric && other[0]->reading == row.reading &&
             other[0]->demand.above == row.demand.above &&
             other[0]->demand.below == row.demand.below;
    });
    (line == lines.end() ? lines.emplace_back() : *line).push_back(&row);
  }
  return lines;
}

bool is_timed(const Claim& claim) {
  return std::any_of(claim.rows.begin(), claim.rows.end(),
                     [](const ClaimRow& row) { return row.interval.has_value(); });
}

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, kVerdictCount> kNames{
      "holds in all readings",        "holds under some readings",
      "holds on some subjects",       "undecided",
      "does not hold in any reading", "cannot be checked"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string_view name(Scope scope) {
  return scope == Scope::figure ? "figure" : "comparison";
}

ClaimRow counted_row(std::string reading, std::string metric, std::string subject, std::string unit,
                     Demand demand, double value) {
  return {.reading = std::move(reading),
          .metric = std::move(metric),
          .subject = std::move(subject),
          .unit = std::move(unit),
          .demand = demand,
          .value = value};
}

ClaimRow measured_row(std::string reading, std::string metric, std::string subject,
                      std::string unit, Demand demand, const Estimate& estimate) {
  ClaimRow row = counted_row(std::move(reading), std::move(metric), std::move(subject),
                             std::move(unit), demand, estimate.value);
  row.interval = estimate.interval;
  row.rounds = estimate.rounds;
  row.processes = estimate.processes;
  return row;
}

std::string words_of(const Demand& demand) {
  const double middle = std::midpoint(demand.above, demand.below);
  if (demand.below - demand.above == 1 && middle == std::floor(middle)) {
    return fmt::format("= {}", middle);
  }
  const bool above = demand.above > -std::numeric_limits<double>::infinity();
  const bool below = demand.below < std::numeric_limits<double>::infinity();
  return above && below ? fmt::format("{:.4g} to {:.4g}", demand.above, demand.below)
         : above        ? fmt::format("> {:.4g}", demand.above)
         : below        ? fmt::format("< {:.4g}", demand.below)
                        : std::string();
}

std::string words_of(const ClaimRow& row) {
  const bool percent = row.unit == "%" || row.unit == "points";
  const auto number = [&](double value) {
    return percent ? fmt::format("{:+.1f}", value) : fmt::format("{:.4g}", value);
  };
  std::string text = number(row.value);
  if (row.interval) {
    text += fmt::format(" ({} to {})", number(row.interval->low), number(row.interval->high));
  }
  return row.unit.empty() ? text : fmt::format("{} {}", text, row.unit);
}

}  // namespace soms::reproduce
