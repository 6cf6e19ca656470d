#include "apps/soms/clash/clash_text.h"

#include "soms/base/text.h"

#include "apps/cli/console.h"
#include "apps/cli/table.h"
#include "apps/cli/text.h"
#include "apps/soms/clash/clash_output.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

constexpr std::size_t kRowsInText = 40;  // that a person may want to read

std::string set_in_text(const ClashSet& set) {
  const std::string files = set.meshes.size() == 1 ? printable(set.meshes.front().source)
                                                   : counted(set.meshes.size(), "model");
  return fmt::format("{} ({})", files, counted(set.parts.size(), "part"));
}

/// "3 crossing, 1 touching".
std::string kinds_in_text(const ClashCounts& counts) {
  std::string text;
  for (std::size_t k = 0; k < kClashKinds; ++k) {
    if (counts[k] != 0) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", with_commas(counts[k]),
                          name(static_cast<ClashKind>(k)));
    }
  }
  return text;
}

/// What distinguishes a clash from others of its kind.
std::string detail_in_text(const ClashReport& report, const Clash& clash) {
  switch (clash.kind) {
    case ClashKind::inside:
      return clash.relation == Relation::a_in_b ? ", the first in the second"
                                                : ", the second in the first";
    case ClashKind::near:
      return fmt::format(", {} apart", readable(clash.gap.lower));
    case ClashKind::undecided: {
      std::string text = clash.triangle_pairs == 0 ? "" : ", surfaces meet";
      const auto [a, b] = bodies_in(report.models, clash);
      for (const auto& [part, which] : {std::pair{&a, "first"}, std::pair{&b, "second"}}) {
        if (!part->closed && part->odd_edges == 0) {
          text += fmt::format(", parts of the {} close each other in several ways", which);
        } else if (!part->closed) {
          text += fmt::format(", the {} is open at {}", which, counted(part->odd_edges, "edge"));
        }
      }
      return text;
    }
    case ClashKind::crossing:
    case ClashKind::same:
    case ClashKind::touching:
      break;
  }
  const std::string deep =
      clash.penetration ? fmt::format(", {} deep", readable(clash.penetration->depth)) : "";
  return fmt::format("{}, {} of triangles", deep, counted(clash.triangle_pairs, "pair"));
}

std::string label_of(const ClashSet& set, std::uint32_t part, const PartBody& body) {
  return printable(body_label(set.mesh_of(part), body.part, body.joined));
}

std::string row_in_text(const ClashReport& report, const ClashRow& row) {
  const Clash& clash = row.clash;
  const std::string_view status = status_name(row.status);
  const auto [a, b] = bodies_in(report.models, clash);
  return fmt::format("  {:<9}  {}{}{} and {} at {}{}\n", name(clash.kind), status,
                     status.empty() ? "" : "  ", label_of(report.models.a, clash.a, a),
                     label_of(report.models.second(), clash.b, b), point_in_text(clash.place),
                     detail_in_text(report, clash));
}

/// What the class of a clash means to whoever looks for faults.
Ink ink_of(ClashKind kind) {
  return kind == ClashKind::near || kind == ClashKind::undecided ? Ink::open : Ink::touches;
}

/// The cells of a row in a terminal.
TableRow row_in_table(const ClashReport& report, const ClashRow& row, int digits) {
  const Clash& clash = row.clash;
  const auto [a, b] = bodies_in(report.models, clash);
  const std::string pairs =
      clash.triangle_pairs == 0 ? std::string() : with_commas(clash.triangle_pairs);
  const bool says_more = clash.kind == ClashKind::inside || clash.kind == ClashKind::undecided;
  std::string more = says_more ? detail_in_text(report, clash) : std::string();
  more.erase(0, more.find_first_not_of(", "));
  return {
      .cells = {std::string(name(clash.kind)), std::string(status_name(row.status)),
                clash.penetration ? readable(clash.penetration->depth, digits) : std::string(),
                clash.kind == ClashKind::near ? readable(clash.gap.lower, digits) : std::string(),
                label_of(report.models.a, clash.a, a), label_of(report.models.second(), clash.b, b),
                point_in_text(clash.place, digits), pairs, more},
      .ink = ink_of(clash.kind)};
}

std::string clash_table(const ClashReport& report, const std::vector<const ClashRow*>& rows,
                        const Terminal& terminal) {
  std::vector<TableRow> cells;
  for (const ClashRow* const row : rows) {
    cells.push_back(row_in_table(report, *row, terminal.digits()));
  }
  return table_text({{.head = "class"},
                     {.head = "status"},
                     {.head = "depth", .right = true},
                     {.head = "gap", .right = true},
                     {.head = "first part", .shortens = true},
                     {.head = "second part", .shortens = true},
                     {.head = "at"},
                     {.head = "pairs", .right = true},
                     {.head = "", .shortens = true}},
                    std::move(cells), terminal);
}

/// The matrix of sets, where there are several.
void print_matrix(const ClashReport& report, Console& console) {
  const auto cells = counts_by_sets(report);
  if (cells.size() < 2) {
    return;
  }
  for (const auto& [sets, counts] : cells) {
    console.print(fmt::format("  {} and {}: {}\n", printable(sets.first), printable(sets.second),
                              kinds_in_text(counts)));
  }
}

void print_groups(const ClashReport& report, Console& console) {
  const auto groups = counts_by_group(report);
  console.print(fmt::format("in {}\n", counted(groups.size(), "group")));
  for (std::size_t k = 0; k < std::min(groups.size(), kRowsInText); ++k) {
    console.print(
        fmt::format("  {}: {}\n", printable(groups[k].first), kinds_in_text(groups[k].second)));
  }
  if (groups.size() > kRowsInText) {
    console.print(fmt::format("  and {} more; --json or -o FILE lists all\n",
                              with_commas(groups.size() - kRowsInText)));
  }
}

/// The worst of each class first.
void print_clash_rows(const ClashReport& report, Console& console) {
  std::vector<const ClashRow*> rows = worst_first(report.rows);
  rows.resize(std::min(rows.size(), kRowsInText));
  if (console.terminal().person) {
    console.print(rows.empty() ? std::string() : clash_table(report, rows, console.terminal()));
    return;
  }
  for (const ClashRow* const row : rows) {
    console.print(row_in_text(report, *row));
  }
}

}  // namespace

void print_clashes_as_text(const ClashReport& report, Console& console) {
  const ClashModels& models = report.models;
  console.print(models.two_sets
                    ? fmt::format("{} against {}", set_in_text(models.a), set_in_text(models.b))
                    : set_in_text(models.a) + " among each other");
  console.print(fmt::format(": {} of parts, {} with boxes that meet\n",
                            counted(models.pairs(), "pair"),
                            with_commas(report.compared + report.left)));
  for (const auto& [what, count] : report.removed) {
    console.print(fmt::format("removed by {}: {}\n", printable(what), with_commas(count)));
  }
  if (report.removed_by_tolerance && report.unknown_depth != 0) {
    console.print(
        fmt::format("kept, as a part is not convex: {}\n", with_commas(report.unknown_depth)));
  }
  const std::size_t rows = report.rows.size();
  const std::string verdict = fmt::format("{}{} {}{}{}", report.complete() ? "" : "at least ",
                                          with_commas(rows), rows == 1 ? "clash" : "clashes",
                                          rows == 0 ? "" : ": ", kinds_in_text(report.by_kind));
  console.print(console.terminal().paint(verdict, ink_of(rows != 0, !report.complete())) + "\n");
  if (report.has_baseline) {
    console.print(fmt::format(
        "{} new, {} active, {} resolved since the older list\n",
        with_commas(count_status(report, ClashStatus::fresh)),
        with_commas(count_status(report, ClashStatus::active)),
        report.complete() ? with_commas(report.resolved.size()) : std::string("unknown")));
  }
  print_matrix(report, console);
  if (report.grouped) {
    print_groups(report, console);
    return;
  }
  print_clash_rows(report, console);
  if (rows > kRowsInText) {
    console.print(fmt::format("  and {} more; --json or -o FILE lists all\n",
                              with_commas(rows - kRowsInText)));
  }
}

}  // namespace soms::command
