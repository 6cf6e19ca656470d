#include "thesis/page/latex.h"

#include "tests/reproduce/well_formed.h"

#include <gtest/gtest.h>

namespace soms::reproduce {
namespace {

Table nasty_table() {
  return {.id = "table_9_9",
          .caption = "50 % of $x_1$ & {more} #1, by --empty-side",
          .columns = {{"model"},
                      {"one_leaf", "%"},
                      {"median_time", "us", ColumnKind::timed},
                      {"words"}},
          .rows = {{std::string("a_b^c~d\\e"), std::int64_t{-1234567}, 0.04321,
                    std::string("[first] <x|y> \"quoted\" `so'")},
                   {std::string("gro\xc3\x9f \xe4\xb8\xad \xff\n2"),
                    {},
                    -12.5,
                    std::string("a cell of more than thirty-two letters")}}};
}

TEST(Latex, EscapesWhateverATableHolds) {
  EXPECT_EQ(to_latex(nasty_table()), R"tex(\begin{table}[htbp]
\centering
\setlength{\belowcaptionskip}{6pt}
\caption{50 \% of \$x\_1\$ \& \{more\} \#1, by -{}-empty-side. Times, in italics, differ from run to run.}
\label{tab:table_9_9}
\normalsize
\setlength{\tabcolsep}{3pt}
\begin{tabular}{@{}lr>{\itshape}r>{\raggedright\arraybackslash}p{16em}@{}}
\toprule
\shortstack[l]{model} & \shortstack[r]{one\\leaf\\{[}\%]} & \shortstack[r]{median\\time\\{[}us]} & \shortstack[l]{words} \\
\midrule
a\_b\textasciicircum{}c\textasciitilde{}d\textbackslash{}e & $-$1,234,567 & 0.0432 & {[}first] \textless{}x\textbar{}y\textgreater{} ''quoted'' \textasciigrave{}so' \\
)tex"
                                     "gro\xc3\x9f U+4E2D ? 2 &  & $-$12.5 & a cell of more than "
                                     R"tex(thirty-two letters \\
\bottomrule
\end{tabular}
\end{table}
)tex");
}

Table long_table(std::int64_t rows) {
  Table table{.id = "long_table", .caption = "Many rows.", .columns = {{"n"}}};
  for (std::int64_t k = 0; k < rows; ++k) {
    table.rows.push_back({k});
  }
  return table;
}

TEST(Latex, BreaksTablesOfMoreThanFortyRowsBetweenPages) {
  EXPECT_EQ(test::count_of(to_latex(long_table(40)), "longtable"), 0U);
  const std::string text = to_latex(long_table(41));
  EXPECT_EQ(test::count_of(text, "{longtable}"), 2U);
  EXPECT_EQ(test::count_of(text, "\\caption"), 1U);
  EXPECT_EQ(test::count_of(text, "\\toprule"), 2U);
  EXPECT_EQ(test::count_of(text, "\n40 \\\\\n"), 1U);
  EXPECT_EQ(test::count_of(text, "%"), 0U);
}

TEST(Latex, WritesTheFirstRowsOfVeryLongTablesAndSaysWhereAllAre) {
  const std::string text = to_latex(long_table(1000));
  EXPECT_TRUE(
      text.starts_with("% The first 400 of 1000 rows; all of them are in tables/long_table.csv.\n"))
      << text.substr(0, 100);
  EXPECT_EQ(test::count_of(text, "\\caption{Many rows. The first 400 of 1,000 rows.}"), 1U);
  EXPECT_EQ(test::count_of(text, "\n399 \\\\\n"), 1U);
  EXPECT_EQ(test::count_of(text, "\n400 \\\\\n"), 0U);
}

TEST(Latex, SetsWideAndHighTablesSmaller) {
  EXPECT_EQ(test::count_of(to_latex(long_table(28)), "\\normalsize\n"), 1U);
  EXPECT_EQ(test::count_of(to_latex(long_table(29)), "\\footnotesize\n"), 1U);
  EXPECT_EQ(test::count_of(to_latex(long_table(41)), "\\normalsize\n"), 1U);
  Table table = nasty_table();
  for (int k = 0; k < 20; ++k) {
    table.columns.push_back({"another_number"});
  }
  EXPECT_EQ(test::count_of(to_latex(table), "\\tiny\n"), 1U);
}

TEST(Latex, HasADocumentThatReadsTheTablesOfEachExperiment) {
  constexpr Experiment kOne{"table-9.9", "Leaves & nodes", Chapter::thesis, {}, 1, {}};
  constexpr Experiment kNone{"figure-9.9", "No table", Chapter::thesis, {}, 1, {}};
  Report report;
  report.machine.version = "1.2.3";
  report.machine.commit = "abc";
  report.date = "2026-01-01T00:00:00Z";
  Result result;
  result.tables = {nasty_table(), long_table(1)};
  report.entries = {{&kOne, result, 1}, {&kNone, {}, 1}};
  EXPECT_EQ(latex_of_all(report), R"tex(% Written by soms 1.2.3, commit abc, 2026-01-01T00:00:00Z.
% Long tables have the right widths after LaTeX ran three or four times.
\documentclass{article}
\usepackage[T1]{fontenc}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\usepackage[utf8]{inputenc}
\usepackage[a4paper,landscape,margin=15mm]{geometry}
\usepackage{array}
\usepackage{booktabs}
\usepackage{longtable}
\begin{document}
\clearpage
\section*{table-9.9: Leaves \& nodes}
\input{table_9_9.tex}
\input{long_table.tex}
\end{document}
)tex");
}

}  // namespace
}  // namespace soms::reproduce
