#include "thesis/page/latex.h"

#include "soms/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace soms::reproduce {

namespace {

/// A table with more rows may break between pages; of still longer ones the first rows are written.
constexpr std::size_t kMostRowsOnAPage = 40;
constexpr std::size_t kMostRowsInLatex = 400;
/// Columns of longer words have lines of this length.
constexpr std::size_t kMostInALine = 32;

/// What stands for a character of ASCII; empty where it stands for itself.
std::string_view escaped(char c) {
  constexpr std::array<std::pair<char, std::string_view>, 16> kSpecial{{
      {'\\', "\\textbackslash{}"},
      {'{', "\\{"},
      {'}', "\\}"},
      {'$', "\\$"},
      {'&', "\\&"},
      {'#', "\\#"},
      {'_', "\\_"},
      {'%', "\\%"},
      {'~', "\\textasciitilde{}"},
      {'^', "\\textasciicircum{}"},
      {'<', "\\textless{}"},
      {'>', "\\textgreater{}"},
      {'|', "\\textbar{}"},
      {'`', "\\textasciigrave{}"},
      // A quote begins a short form of some languages, a bracket the argument of a line's end.
      {'"', "''"},
      {'[', "{[}"},
  }};
  const auto* const found = std::find_if(kSpecial.begin(), kSpecial.end(),
                                         [&](const auto& special) { return special.first == c; });
  return found == kSpecial.end() ? std::string_view() : found->second;
}

/// The number of a character of UTF-8. \pre its bytes are well formed.
std::uint32_t code_point(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  std::uint32_t code = first & (0xFFU >> (character.size() + 1));
  for (const char c : character.substr(1)) {
    code = code << 6U | (static_cast<unsigned char>(c) & 0x3FU);
  }
  return code;
}

std::string beyond_ascii(std::string_view character) {
  constexpr std::uint32_t kFirstLetter = 0xC0;
  constexpr std::uint32_t kLastLetter = 0xFF;
  const std::uint32_t code = code_point(character);
  return code >= kFirstLetter && code <= kLastLetter ? std::string(character)
                                                     : fmt::format("U+{:04X}", code);
}

/// True for two signs that would become another one.
bool is_ligature(char last, char next) {
  return last == next && (next == '-' || next == '\'' || next == ',');
}

bool is_numeric(const Cell& cell) {
  return std::holds_alternative<std::int64_t>(cell) || std::holds_alternative<double>(cell);
}

std::string cell_text(const Cell& cell) {
  std::string text = latex_text(to_text(cell));
  if (is_numeric(cell) && text.starts_with('-')) {
    text.replace(0, 1, "$-$");
  }
  return text;
}

/// Words of a column's name and of its unit, a line each.
std::vector<std::string> latex_lines(const Column& column) {
  std::string words = column.name;
  std::replace(words.begin(), words.end(), '_', ' ');
  words += column.unit.empty() ? "" : " [" + column.unit + "]";
  std::vector<std::string> lines(1);
  for (const char c : words) {
    if (c == ' ') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

/// How a column is set.
struct Setting {
  bool numbers = false;   ///< stands right
  bool folded = false;    ///< has lines of kMostInALine
  std::size_t width = 0;  ///< characters
};

Setting setting_of(const Table& table, std::size_t column) {
  Setting setting{.numbers = true};
  for (const std::string& line : latex_lines(table.columns[column])) {
    setting.width = std::max(setting.width, line.size());
  }
  for (const std::vector<Cell>& row : table.rows) {
    if (column < row.size()) {
      setting.numbers = setting.numbers && !std::holds_alternative<std::string>(row[column]);
      setting.width = std::max(setting.width, to_text(row[column]).size());
    }
  }
  setting.folded = !setting.numbers && setting.width > kMostInALine;
  setting.width = setting.folded ? kMostInALine : setting.width;
  return setting;
}

/// A smaller size for wide and for high tables, so that they fit on a page of A4 in landscape.
std::string_view size_for(std::size_t characters, std::size_t rows) {
  constexpr std::size_t kMostRowsAtFullSize = 28;
  constexpr std::array<std::pair<std::size_t, std::string_view>, 4> kSizesByCharacters{
      {{130, "\\normalsize"}, {145, "\\small"}, {165, "\\footnotesize"}, {190, "\\scriptsize"}}};
  for (std::size_t k = rows > kMostRowsAtFullSize ? 2 : 0; k < kSizesByCharacters.size(); ++k) {
    if (characters <= kSizesByCharacters[k].first) {
      return kSizesByCharacters[k].second;
    }
  }
  return "\\tiny";
}

/// Writes one table.
class Writer {
 public:
  explicit Writer(const Table& table) : table_(table) {
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      settings_.push_back(setting_of(table, k));
    }
  }

  std::string write() {
    const std::size_t shown = std::min(table_.rows.size(), kMostRowsInLatex);
    if (shown < table_.rows.size()) {
      put("% The first {} of {} rows; all of them are in {}.\n", shown, table_.rows.size(),
          file_of(table_).generic_string());
    }
    const bool is_long = shown > kMostRowsOnAPage;
    begin(is_long);
    for (std::size_t row = 0; row < shown; ++row) {
      put_row(table_.rows[row]);
    }
    out_ +=
        is_long ? "\\end{longtable}\n\\endgroup\n" : "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
    return std::move(out_);
  }

 private:
  template <typename... Values>
  void put(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<Values>(values)...);
  }

  void begin(bool is_long) {
    constexpr std::size_t kCharactersBetween = 2;
    std::size_t width = 0;
    for (const Setting& setting : settings_) {
      width += setting.width + kCharactersBetween;
    }
    const std::string_view size = size_for(width, is_long ? 0 : table_.rows.size());
    if (is_long) {
      put("\\begingroup\n{}\n\\setlength{{\\tabcolsep}}{{3pt}}\n"
          "\\setlength{{\\LTcapwidth}}{{\\linewidth}}\n\\begin{{longtable}}{{@{{}}{}@{{}}"
          "}}\n{}\\\\\n\\toprule\n",
          size, columns(), caption());
      put_head();
      put("\\endfirsthead\n\\toprule\n");
      put_head();
      put("\\endhead\n\\bottomrule\n\\endfoot\n");
    } else {
      put("\\begin{{table}}[htbp]\n\\centering\n\\setlength{{\\belowcaptionskip}}{{6pt}}\n{}\n{}"
          "\n\\setlength{{\\tabcolsep}}{{3pt}}\n"
          "\\begin{{tabular}}{{@{{}}{}@{{}}}}\n\\toprule\n",
          caption(), size, columns());
      put_head();
    }
  }

  [[nodiscard]] std::string caption() const {
    std::string text = latex_text(table_.caption);
    if (!text.empty() && text.back() != '.') {
      text += '.';
    }
    if (table_.rows.size() > kMostRowsInLatex) {
      text += fmt::format(" The first {} of {} rows.",
                          to_text(static_cast<std::int64_t>(kMostRowsInLatex)),
                          to_text(static_cast<std::int64_t>(table_.rows.size())));
    }
    if (std::any_of(table_.columns.begin(), table_.columns.end(),
                    [](const Column& column) { return column.kind == ColumnKind::timed; })) {
      text += " Times, in italics, differ from run to run.";
    }
    return fmt::format("\\caption{{{}}}\n\\label{{tab:{}}}", text, table_.id);
  }

  [[nodiscard]] std::string columns() const {
    std::string text;
    for (std::size_t k = 0; k < settings_.size(); ++k) {
      const Setting& setting = settings_[k];
      std::string before = table_.columns[k].kind == ColumnKind::timed ? "\\itshape" : "";
      before += setting.folded ? "\\raggedright\\arraybackslash" : "";
      text += before.empty() ? "" : fmt::format(">{{{}}}", before);
      text += setting.folded    ? fmt::format("p{{{}em}}", kMostInALine / 2)
              : setting.numbers ? "r"
                                : "l";
    }
    return text;
  }

  void put_head() {
    for (std::size_t k = 0; k < settings_.size(); ++k) {
      put("{}\\shortstack[{}]{{", k == 0 ? "" : " & ", settings_[k].numbers ? "r" : "l");
      std::string_view between;
      for (const std::string& line : latex_lines(table_.columns[k])) {
        put("{}{}", between, latex_text(line));
        between = "\\\\";
      }
      put("}}");
    }
    put(" \\\\\n\\midrule\n");
  }

  void put_row(const std::vector<Cell>& row) {
    for (std::size_t k = 0; k < settings_.size(); ++k) {
      put("{}{}", k == 0 ? "" : " & ", k < row.size() ? cell_text(row[k]) : std::string());
    }
    put(" \\\\\n");
  }

  const Table& table_;
  std::vector<Setting> settings_;
  std::string out_;
};

}  // namespace

std::filesystem::path latex_file_of(const Table& table) {
  return std::filesystem::path("latex") / (table.id + ".tex");
}

std::string latex_text(std::string_view words) {
  std::string text;
  char last = ' ';
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t size = utf8_character(words, at);
    const char c = words[at];
    if (size > 1) {
      text += beyond_ascii(words.substr(at, size));
    } else if (size == 0) {
      text += '?';
    } else if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') {
      text += ' ';
    } else {
      text += is_ligature(last, c) ? "{}" : "";
      const std::string_view special = escaped(c);
      text += special.empty() ? std::string_view(&c, 1) : special;
    }
    last = size == 1 ? c : ' ';
    at += std::max<std::size_t>(1, size);
  }
  return text;
}

std::string to_latex(const Table& table) {
  return Writer(table).write();
}

std::string latex_of_all(const Report& report) {
  const Machine& machine = report.machine;
  std::string text = fmt::format(
      "% Written by soms {}, commit {}, {}.\n"
      "% Long tables have the right widths after LaTeX ran three or four times.\n"
      "\\documentclass{{article}}\n"
      "\\usepackage[T1]{{fontenc}}\n"
      "\\IfFileExists{{lmodern.sty}}{{\\usepackage{{lmodern}}}}{{}}\n"
      "\\usepackage[utf8]{{inputenc}}\n"
      "\\usepackage[a4paper,landscape,margin=15mm]{{geometry}}\n"
      "\\usepackage{{array}}\n"
      "\\usepackage{{booktabs}}\n"
      "\\usepackage{{longtable}}\n"
      "\\begin{{document}}\n",
      machine.version, machine.commit, report.date);
  for (const Entry& entry : report.entries) {
    if (entry.result.tables.empty()) {
      continue;
    }
    text += fmt::format("\\clearpage\n\\section*{{{}: {}}}\n", latex_text(entry.experiment->item),
                        latex_text(entry.experiment->title));
    for (const Table& table : entry.result.tables) {
      text += fmt::format("\\input{{{}}}\n", latex_file_of(table).filename().string());
    }
  }
  return text + "\\end{document}\n";
}

}  // namespace soms::reproduce
