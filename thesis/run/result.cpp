#include "thesis/run/result.h"

#include "soms/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soms::reproduce {

namespace {

struct CsvCell {
  std::string operator()(std::monostate) const { return {}; }

  std::string operator()(const std::string& text) const { return csv_field(text); }

  std::string operator()(std::int64_t count) const { return std::to_string(count); }

  std::string operator()(double number) const { return fmt::format("{:.6g}", number); }
};

std::string with_commas(std::int64_t count) {
  std::string digits = std::to_string(count);
  const std::size_t first = count < 0 ? 1 : 0;
  for (std::size_t at = digits.size(); at > first + 3;) {
    at -= 3;
    digits.insert(at, 1, ',');
  }
  return digits;
}

/// Three significant digits, but never a count's digits lost: 12345.6 is 12,346.
std::string three_digits(double number) {
  if (number >= 999.5 && number < 1e15) {
    return with_commas(std::llround(number));
  }
  return fmt::format("{:.3g}", number);
}

struct PageCell {
  std::string operator()(std::monostate) const { return {}; }

  std::string operator()(const std::string& text) const { return text; }

  std::string operator()(std::int64_t count) const { return with_commas(count); }

  std::string operator()(double number) const { return three_digits(number); }
};

/// A row's number with the sign of how it stands.
std::string marked(const ClaimRow& row) {
  switch (stand_of(row)) {
    case Verdict::holds:
      return "\u2713 " + words_of(row);
    case Verdict::undecided:
      return "\u00b1 " + words_of(row);
    case Verdict::does_not_hold:
      return "\u2717 " + words_of(row);
    default:
      return fmt::format("({})", words_of(row));
  }
}

std::string csv_line(const std::vector<std::string>& cells) {
  return fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace

Table claim_table(const Claim& claim) {
  const ColumnKind kind = is_timed(claim) ? ColumnKind::timed : ColumnKind::counted;
  Table table{
      .id = "claim_" + claim.id,
      .caption = fmt::format("The matrix of the claim: {}. A row holds if its number, with the "
                             "whole interval of 95 % where it is measured, lies above the "
                             "column above and below the column below.",
                             claim.statement),
      .columns = {{"metric"},
                  {"reading"},
                  {"nearest"},
                  {"subject"},
                  {"unit"},
                  {"above"},
                  {"below"},
                  {"value", "", kind},
                  {"low", "", kind},
                  {"high", "", kind},
                  {"rounds"},
                  {"processes"},
                  {"stands", "", kind},
                  {"unjudged"},
                  {"on_stand_in"}}};
  for (const ClaimRow& row : claim.rows) {
    const auto bound = [](double end) { return std::isinf(end) ? Cell{} : Cell{end}; };
    const auto yes_if = [](bool is) { return std::string(is ? "yes" : ""); };
    const auto end_of = [&](double Interval::*end) {
      return row.interval ? Cell{(*row.interval).*end} : Cell{};
    };
    table.rows.push_back({row.metric, row.reading, yes_if(is_nearest(claim, row)), row.subject,
                          row.unit, bound(row.demand.above), bound(row.demand.below), row.value,
                          end_of(&Interval::low), end_of(&Interval::high),
                          row.rounds == 0 ? Cell{} : Cell{std::int64_t{row.rounds}},
                          row.processes == 0 ? Cell{} : Cell{std::int64_t{row.processes}},
                          std::string(stand_word(row)), row.unjudged, yes_if(row.on_stand_in)});
  }
  return table;
}

Table matrix_table(const Claim& claim) {
  Table table{.id = "matrix_" + claim.id,
              .caption = fmt::format(
                  "Matrix of the claim: {}. \u2713 holds, \u00b1 undecided, \u2717 fails, "
                  "(number) not judged.",
                  claim.statement),
              .columns = {{"metric"}, {"reading"}, {"demanded"}}};
  const std::vector<std::string> subjects = subjects_of(claim);
  for (const std::string& subject : subjects) {
    table.columns.push_back({subject});
  }
  for (const std::vector<const ClaimRow*>& line : lines_of(claim)) {
    std::vector<Cell> cells{line[0]->metric, line[0]->reading, words_of(line[0]->demand)};
    for (const std::string& subject : subjects) {
      const auto row = std::find_if(line.begin(), line.end(),
                                    [&](const ClaimRow* one) { return one->subject == subject; });
      cells.push_back(row == line.end() ? Cell{} : Cell{marked(**row)});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string to_csv(const Table& table) {
  std::vector<std::string> cells;
  for (const Column& column : table.columns) {
    cells.push_back(
        csv_field(column.unit.empty() ? column.name : column.name + " [" + column.unit + "]"));
  }
  std::string text = csv_line(cells);
  for (const std::vector<Cell>& row : table.rows) {
    cells.clear();
    for (const Cell& cell : row) {
      cells.push_back(std::visit(CsvCell{}, cell));
    }
    text += csv_line(cells);
  }
  return text;
}

std::string to_text(const Cell& cell) {
  return std::visit(PageCell{}, cell);
}

}  // namespace soms::reproduce
