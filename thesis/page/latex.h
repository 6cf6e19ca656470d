/// \file
/// Tables for LaTeX, to be put into a paper.
#pragma once

#include "thesis/page/report.h"
#include "thesis/run/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace soms::reproduce {

/// A document with all tables of a run, beside them.
inline constexpr std::string_view kLatexOfAll = "latex/all.tex";

/// "latex/ID.tex".
[[nodiscard]] std::filesystem::path latex_file_of(const Table& table);

/// The table with its caption and the label "tab:ID", for \\input: a `table`, or a `longtable` if
/// it has more than 40 rows. Needs the packages array and booktabs, and longtable. Of more than 400
/// rows the first 400, and a comment that names the CSV file with all. Units stand in brackets
/// below the names of columns; columns of times are in italics.
[[nodiscard]] std::string to_latex(const Table& table);

/// The document: complete, with a section for each experiment that has tables, which it reads by
/// \\input from its own folder.
[[nodiscard]] std::string latex_of_all(const Report& report);

/// Words as LaTeX typesets them: its special characters escaped, ligatures of signs broken, line
/// breaks and other control characters as spaces. Letters of Latin-1 stay; other characters beyond
/// ASCII, which not every font has, become "U+4E2D", and bytes that are not UTF-8 "?".
[[nodiscard]] std::string latex_text(std::string_view words);

}  // namespace soms::reproduce
