#include "thesis/page/page_table.h"

#include "soms/base/text.h"

#include "thesis/page/html.h"
#include "thesis/page/paper.h"
#include "thesis/page/percent_encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace soms::reproduce {

namespace {

/// Tables with more rows are folded; of still longer ones the page shows the first rows.
constexpr std::size_t kFoldedFrom = 24;
constexpr std::size_t kMostRows = 40;
/// Bytes of words that stay on one line.
constexpr std::size_t kShortWords = 24;

/// A link to the file of a table, or to one inside the link.
std::string link_to(const Table& table, PageFiles files) {
  if (files == PageFiles::inside) {
    return fmt::format("<a href=\"data:text/csv;charset=utf-8,{}\" download=\"{}.csv\">CSV</a>",
                       percent_encoded(to_csv(table)), xml_text(table.id));
  }
  return fmt::format("<a href=\"{}\">CSV</a>", xml_text(file_of(table).generic_string()));
}

/// Writes a table part by part.
class TablePart {
 public:
  TablePart(PageFiles files, const Table& of_file) : files_(files), of_file_(of_file) {}

  std::string write(const Table& table) {
    const bool on_paper = files_ == PageFiles::paper;
    const std::size_t shown =
        on_paper ? rows_on_paper(table) : std::min(table.rows.size(), kMostRows);
    const std::vector<bool> none(table.columns.size(), false);
    const TableFit fit = on_paper ? fit_on_paper(table, shown) : TableFit{0, none, none};
    const bool folded = table.rows.size() > kFoldedFrom;
    if (folded) {
      put("<details>\n<summary>{} <span class=\"faint\">({})</span></summary>\n",
          xml_text(table.caption), counted(table.rows.size(), "row"));
    }
    put("<div class=\"scroll{}\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">\n"
        "<table id=\"t-{}\"{}>\n",
        folded ? " tall" : "", xml_text(table.caption), xml_text(table.id),
        on_paper ? fmt::format(" style=\"font-size:{}pt\"", fit.type_size) : "");
    if (!folded) {
      put("<caption>{}</caption>\n", xml_text(table.caption));
    }
    put_rows(table, shown, fit);
    put("</table>\n</div>\n");
    put_left_out(table, fit);
    put_rows_and_file(table, shown);
    put("{}", folded ? "</details>\n" : "");
    return std::move(out_);
  }

 private:
  template <typename... Values>
  void put(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<Values>(values)...);
  }

  void put_rows(const Table& table, std::size_t shown, const TableFit& fit) {
    std::vector<std::string> classes;
    put("<thead><tr>");
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      classes.push_back(class_of(table, k));
      if (fit.turned[k] && !fit.left_out[k]) {
        put("<th class=\"turned\"><div>{}</div></th>", title_of(table.columns[k]));
      } else if (!fit.left_out[k]) {
        put("<th{}>{}</th>", classes[k], title_of(table.columns[k]));
      }
    }
    put("</tr></thead>\n<tbody>\n");
    for (std::size_t row = 0; row < shown; ++row) {
      put("<tr>");
      for (std::size_t k = 0; k < table.rows[row].size(); ++k) {
        if (k >= fit.left_out.size() || !fit.left_out[k]) {
          put("<td{}>{}</td>", k < classes.size() ? classes[k] : std::string(),
              xml_text(to_text(table.rows[row][k])));
        }
      }
      put("</tr>\n");
    }
    put("</tbody>\n");
  }

  /// The columns that are left out, with the one value of each.
  void put_left_out(const Table& table, const TableFit& fit) {
    std::string words;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      if (fit.left_out[k]) {
        const std::string value = to_text(table.rows.front()[k]);
        words += fmt::format("{}{}: {}", words.empty() ? "" : ", ", title_of(table.columns[k]),
                             value.empty() ? "none" : xml_text(value));
      }
    }
    if (!words.empty()) {
      put("<p class=\"note\">In all rows {}.</p>\n", words);
    }
  }

  /// How many rows of all the page shows, and the file that has them.
  void put_rows_and_file(const Table& table, std::size_t shown) {
    put("<p class=\"note\">");
    if (shown < table.rows.size()) {
      put("The first {} of {}; all of them are in {}", to_text(static_cast<std::int64_t>(shown)),
          counted(table.rows.size(), "row"), files_ == PageFiles::paper ? "" : "the ");
    }
    put("{}</p>\n", link_to(of_file_, files_));
  }

  [[nodiscard]] static std::string title_of(const Column& column) {
    std::string words = column.name;
    std::replace(words.begin(), words.end(), '_', ' ');
    words = xml_text(words);
    return column.unit.empty() ? words
                               : fmt::format("{} <span>[{}]</span>", words, xml_text(column.unit));
  }

  /// Attribute of a column's cells: numbers stand right, times lean, short words do not wrap.
  [[nodiscard]] static std::string class_of(const Table& table, std::size_t column) {
    std::size_t longest = 0;
    for (const std::vector<Cell>& row : table.rows) {
      const auto* words = column < row.size() ? std::get_if<std::string>(&row[column]) : nullptr;
      longest = words == nullptr ? longest : std::max(longest, words->size());
    }
    std::string names = longest == 0 ? "number" : longest <= kShortWords ? "short" : "";
    if (table.columns[column].kind == ColumnKind::timed) {
      names += names.empty() ? "timed" : " timed";
    }
    return names.empty() ? names : fmt::format(" class=\"{}\"", names);
  }

  PageFiles files_;
  const Table& of_file_;
  std::string out_;
};

}  // namespace

std::string markup_of(const Table& table, PageFiles files) {
  return TablePart(files, table).write(table);
}

std::string markup_of(const Table& table, PageFiles files, const Table& of_file) {
  return TablePart(files, of_file).write(table);
}

std::string file_note(const Table& table, PageFiles files) {
  return fmt::format("<p class=\"note\">All numbers: {}</p>\n", link_to(table, files));
}

}  // namespace soms::reproduce
