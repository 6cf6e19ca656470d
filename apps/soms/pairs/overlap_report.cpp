#include "apps/soms/pairs/overlap_report.h"

#include "soms/base/text.h"

#include "apps/cli/text.h"
#include "apps/output/json.h"
#include "apps/rows/json_rows.h"
#include "apps/soms/pairs/overlap_parts.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace soms::command {

namespace {

constexpr std::size_t kListed = 20;                   // pairs that a person may want to read
constexpr std::size_t kPiece = std::size_t{1} << 16;  // bytes handed on at once

void write_pairs(const std::vector<TrianglePair>& pairs, JsonRows& rows) {
  std::string piece = ",\"pairs\":[";
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const char* const format = k == 0 ? "[{},{}]" : ",[{},{}]";
    fmt::format_to(std::back_inserter(piece), fmt::runtime(format), pairs[k].a, pairs[k].b);
    if (piece.size() > kPiece) {
      rows.put(piece);
      piece.clear();
    }
  }
  rows.put(piece + "]");
}

void write_parts(const OverlapReport& report, std::span<const PartPair> parts, JsonRows& rows) {
  std::string piece = ",\"parts\":[";
  for (const PartPair& pair : parts) {
    piece += json_text({{"a", part_as_json(report.pair.a, pair.a)},
                        {"b", part_as_json(report.pair.b, pair.b)},
                        {"count", pair.count},
                        {"first", {pair.first.a, pair.first.b}},
                        {"box", json_box(pair.box)}});
    piece += &pair == &parts.back() ? "" : ",";
    if (piece.size() > kPiece) {
      rows.put(piece);
      piece.clear();
    }
  }
  rows.put(piece + "]");
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

std::string pairs_of_parts(std::size_t count) {
  return with_commas(count) + (count == 1 ? " pair of parts" : " pairs of parts");
}

std::string text_of_parts(const OverlapReport& report, const Overlap& answer,
                          std::span<const PartPair> parts, const Terminal& terminal) {
  const char* const at_least = answer.coverage == Coverage::cut ? "at least " : "";
  std::string text =
      terminal.paint(
          fmt::format("{}{} of triangles overlap{}, in {}{}{}", at_least,
                      counted(answer.pairs.size(), "pair"), answer.pairs.size() == 1 ? "s" : "",
                      at_least, pairs_of_parts(parts.size()), report.pair.single ? ":" : ""),
          Ink::touches) +
      "\n";
  for (std::size_t k = 0; k < parts.size() && report.pair.single; ++k) {
    const Vec3 at = parts[k].box.center();
    text += fmt::format("  {} and {}: {} of triangles around ({}, {}, {})\n",
                        part_in_text(report.pair.a, parts[k].a),
                        part_in_text(report.pair.b, parts[k].b), counted(parts[k].count, "pair"),
                        readable(at.x), readable(at.y), readable(at.z));
  }
  return text;
}

/// The first pairs of triangles, for a single pose.
std::string text_of_pairs(const OverlapReport& report, const std::vector<TrianglePair>& pairs) {
  const std::size_t listed = std::min(kListed, pairs.size());
  std::string text;
  if (listed > 0) {
    text = fmt::format("  triangle of {} and triangle of {}:\n", printable(report.pair.a.source),
                       printable(report.pair.b.source));
  }
  for (std::size_t k = 0; k < listed; ++k) {
    text += fmt::format("  {} and {}\n", triangle_label(report.pair.a, pairs[k].a),
                        triangle_label(report.pair.b, pairs[k].b));
  }
  if (listed < pairs.size()) {
    text += fmt::format("  and {} more; --json lists all\n", with_commas(pairs.size() - listed));
  }
  return text;
}

}  // namespace

bool is_undecided(const Overlap& answer) {
  return answer.coverage == Coverage::cut && !answer.any;
}

void write_json(const OverlapReport& report, const AnsweredRow& row, const CountedAnswer& result,
                JsonRows& rows, std::span<const PartPair> parts) {
  const Overlap& answer = result.answer;
  const char* const overlap = is_undecided(answer) ? "null" : answer.any ? "true" : "false";
  std::string text =
      fmt::format("{{\"schema\":\"soms.overlap/2\",\"pose\":{},\"any\":{}", row.number, overlap);
  // Which pair --any finds is not promised, so its number and hash would say nothing.
  if (report.mode != OverlapMode::any) {
    text += fmt::format(",\"count\":{},\"hash\":\"{:016x}\"", answer.pairs.size(), answer.hash());
  }
  text += coverage_keys(answer.coverage, answer.cost, result.count_keys);
  rows.put(text + report_keys(report.pair, row.number, row.right));
  if (report.by_part) {
    write_parts(report, parts, rows);
  } else if (report.list_pairs) {
    write_pairs(answer.pairs, rows);
  }
  rows.put("}");
  rows.end_row();
}

std::string text_of(const OverlapReport& report, std::uint64_t pose, const CountedAnswer& result,
                    std::span<const PartPair> parts, const Terminal& terminal) {
  const Overlap& answer = result.answer;
  const bool single = report.pair.single;
  std::string text = single ? "" : fmt::format("pose {}: ", pose);
  if (report.by_part && answer.any) {
    text += text_of_parts(report, answer, parts, terminal);
  } else {
    text +=
        terminal.paint(summary(report, answer), ink_of(answer.any, is_undecided(answer))) + "\n";
  }
  // What a named traversal did, in a line: who names one wants to compare.
  text += single ? result.count_line : "";
  const bool lists = single && report.list_pairs && report.mode == OverlapMode::all &&
                     !(report.by_part && answer.any);
  return lists ? text + text_of_pairs(report, answer.pairs) : text;
}

std::string text_of(const RowTotals& totals) {
  std::string text = fmt::format(
      "{}: {} with overlap, {} without{}\n", counted(totals.rows, "pose"),
      with_commas(totals.found), with_commas(totals.rows - totals.found - totals.undecided),
      totals.undecided == 0 ? "" : fmt::format(", {} undecided", with_commas(totals.undecided)));
  if (totals.found + totals.undecided < totals.rows) {
    text +=
        "only surfaces are compared, at these poses: a body inside the other is not found, nor "
        "what happens between two poses\n";
  }
  return text;
}

}  // namespace soms::command
