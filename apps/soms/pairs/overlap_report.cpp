#include "apps/soms/pairs/overlap_report.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/output/json.h"
#include "apps/soms/pairs/overlap_by_part.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace soms::command {

namespace {

constexpr std::size_t kListed = 20;                   // pairs that a person may want to read
constexpr std::size_t kPiece = std::size_t{1} << 16;  // bytes handed on at once

void print_pairs_as_json(const std::vector<TrianglePair>& pairs, Console& console) {
  std::string piece = ",\"pairs\":[";
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const char* const format = k == 0 ? "[{},{}]" : ",[{},{}]";
    fmt::format_to(std::back_inserter(piece), fmt::runtime(format), pairs[k].first,
                   pairs[k].second);
    if (piece.size() > kPiece) {
      console.print(piece);
      piece.clear();
    }
  }
  console.print(piece + "]");
}

void print_json(const OverlapReport& report, std::uint64_t pose, const CountedAnswer& result,
                bool right, Console& console, std::span<const PartPair> parts) {
  const Overlap& answer = result.answer;
  const char* const overlap = is_undecided(answer) ? "null" : answer.any ? "true" : "false";
  std::string text =
      fmt::format("{{\"schema\":\"soms.overlap/2\",\"pose\":{},\"any\":{}", pose, overlap);
  // Which pair --any finds is not promised, so its number and hash would say nothing.
  if (report.mode != OverlapMode::any) {
    text += fmt::format(",\"count\":{},\"hash\":\"{:016x}\"", answer.pairs.size(), answer.hash());
  }
  text += coverage_keys(answer.coverage, answer.cost, result.count_keys);
  console.print(text + report_keys(report.pair, pose, right));
  if (report.by_part) {
    print_parts_as_json(report, parts, console);
  } else if (report.list_pairs) {
    print_pairs_as_json(answer.pairs, console);
  }
  console.print("}\n");
}

std::string summary(const OverlapReport& report, const Overlap& answer) {
  if (is_undecided(answer)) {
    return "undecided: out of time";
  }
  if (!answer.any && report.pair.single && report.pair.gap > 0) {
    return fmt::format("no triangles overlap: the boxes of the models are {:.4g} apart",
                       report.pair.gap);
  }
  if (!answer.any) {
    return report.pair.single ? std::string("no triangles overlap (surfaces only: ") +
                                    (report.pair.one_box_in_other
                                         ? "soms solid says whether one is inside the other)"
                                         : "a body entirely inside the other is not detected)")
                              : "no overlap";
  }
  if (report.mode != OverlapMode::all) {
    const auto& [i, j] = answer.pairs.front();
    const bool late = report.mode == OverlapMode::first && answer.coverage == Coverage::cut;
    return fmt::format("overlap: triangle {} of {} and {} of {}{}",
                       triangle_label(report.pair.a, i), printable(report.pair.a.source),
                       triangle_label(report.pair.b, j), printable(report.pair.b.source),
                       late ? " (out of time: there may be an earlier pair)" : "");
  }
  const bool one = answer.pairs.size() == 1;
  return fmt::format("{}{} of triangles overlap{}",
                     answer.coverage == Coverage::cut ? "at least " : "",
                     counted(answer.pairs.size(), "pair"), one ? "s" : "");
}

/// What a named traversal did, in a line: who names one wants to compare.
void print_traversal(const OverlapReport& report, const CountedAnswer& result, Console& console) {
  if (report.pair.single && !result.count_line.empty()) {
    console.print(result.count_line);
  }
}

void print_text(const OverlapReport& report, std::uint64_t pose, const CountedAnswer& result,
                Console& console, std::span<const PartPair> parts) {
  const Overlap& answer = result.answer;
  if (report.by_part && answer.any) {
    console.print(report.pair.single ? "" : fmt::format("pose {}: ", pose));
    print_parts_as_text(report, answer, parts, console);
    print_traversal(report, result, console);
    return;
  }
  const bool strong = console.colored() && answer.any;
  console.print(fmt::format("{}{}{}{}\n", report.pair.single ? "" : fmt::format("pose {}: ", pose),
                            strong ? "\x1b[1m" : "", summary(report, answer),
                            strong ? "\x1b[0m" : ""));
  print_traversal(report, result, console);
  if (!report.pair.single || !report.list_pairs || report.mode != OverlapMode::all) {
    return;
  }
  const std::size_t listed = std::min(kListed, answer.pairs.size());
  if (listed > 0) {
    console.print(fmt::format("  triangle of {} and triangle of {}:\n",
                              printable(report.pair.a.source), printable(report.pair.b.source)));
  }
  for (std::size_t k = 0; k < listed; ++k) {
    const auto& [i, j] = answer.pairs[k];
    console.print(fmt::format("  {} and {}\n", triangle_label(report.pair.a, i),
                              triangle_label(report.pair.b, j)));
  }
  if (listed < answer.pairs.size()) {
    console.print(fmt::format("  and {} more; --json lists all\n",
                              with_commas(answer.pairs.size() - listed)));
  }
}

}  // namespace

bool is_undecided(const Overlap& answer) {
  return answer.coverage == Coverage::cut && !answer.any;
}

void print_answer(const OverlapReport& report, std::uint64_t pose, const CountedAnswer& result,
                  bool right, Console& console, std::span<const PartPair> parts) {
  if (console.shared().json) {
    print_json(report, pose, result, right, console, parts);
  } else if (report.pair.lists_rows) {
    print_text(report, pose, result, console, parts);
  }
}

void print_totals(const OverlapReport& report, const RowTotals& totals, Console& console) {
  if (!report.pair.single) {
    console.print(fmt::format(
        "{}: {} with overlap, {} without{}\n", counted(totals.rows, "pose"),
        with_commas(totals.found), with_commas(totals.rows - totals.found - totals.undecided),
        totals.undecided == 0 ? "" : fmt::format(", {} undecided", with_commas(totals.undecided))));
    if (totals.found + totals.undecided < totals.rows) {
      console.print(
          "only surfaces are compared, at these poses: a body inside the other is not found, nor "
          "what happens between two poses\n");
    }
  }
}

}  // namespace soms::command
