/// \file
/// What an experiment finds: tables, figures, claims of the thesis with their matrices, remarks.
#pragma once

#include "thesis/claims/claim.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace soms::reproduce {

/// A cell of a table: empty (not applicable), words, a count, or a measured number.
using Cell = std::variant<std::monostate, std::string, std::int64_t, double>;

/// What a column holds, which decides whether two runs agree on it to the byte.
enum class ColumnKind {
  counted,  ///< words and numbers that are the same in every run on every machine
  timed,    ///< times and what follows from them: differ from run to run
};

/// A column of a table.
struct Column {
  std::string name;                       ///< snake_case, as in the CSV's first line
  std::string unit = {};                  ///< "ms", "%", ...; empty for none
  ColumnKind kind = ColumnKind::counted;  ///< `timed` columns are masked where runs are compared
};

/// A table, written as <id>.csv.
struct Table {
  std::string id;       ///< snake_case, unique in a run: "table_5_3"
  std::string caption;  ///< one sentence: what is in it, with the options that hold for all rows
  std::vector<Column> columns = {};
  std::vector<std::vector<Cell>> rows = {};  ///< each as long as `columns`
};

/// A drawing, written as <id>.svg.
struct Figure {
  std::string id;        ///< snake_case, unique in a run: "figure_5_2"
  std::string caption;   ///< one sentence, with what the reader should see
  std::string svg;       ///< a whole SVG document
  bool timed = false;    ///< true if it shows times, so that runs differ
  std::string alt = {};  ///< what it shows, in words for who cannot see it; the caption if empty
};

/// All that one experiment found.
struct Result {
  std::vector<Table> tables = {};
  std::vector<Figure> figures = {};
  std::vector<Claim> claims = {};
  std::vector<std::string> remarks = {};  ///< sentences for the page, in order
};

/// The matrix of a claim as a table "claim_ID": a row for each of its rows, with the ends of the
/// range that is demanded (`above`, `below`; empty where there is none) and how the row stands.
/// Both verdicts follow from the columns `value`, `low`, `high`, `above`, `below`, `unjudged`,
/// `subject` and `nearest` and from the claim's scope; `on_stand_in` marks rows that are not judged
/// for no other reason than that their model is a stand-in.
[[nodiscard]] Table claim_table(const Claim& claim);

/// The same for readers on paper, "matrix_ID": a line for each metric and reading, a column for
/// each subject.
[[nodiscard]] Table matrix_table(const Claim& claim);

/// The table as CSV (RFC 4180): a line of column names, units in brackets where there are any, then
/// the rows. Numbers of double are written with six significant digits, "." as the mark.
[[nodiscard]] std::string to_csv(const Table& table);

/// A cell as the page shows it: counts with thousands separated by commas, measured numbers with
/// three significant digits.
[[nodiscard]] std::string to_text(const Cell& cell);

}  // namespace soms::reproduce
