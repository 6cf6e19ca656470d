#include "thesis/page/paper.h"

#include "thesis/page/percent_encoding.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <variant>

namespace soms::reproduce {

namespace {

/// Width of the text in points: 172 mm, less what an estimate may be wrong by.
constexpr double kTextWidth = 172 / 25.4 * 72 * 0.97;
/// Of the type size: width of a letter, and what a column has beside its letters.
constexpr double kLetter = 0.54;
constexpr double kPadding = 0.95;
/// A column of words is not made narrower than this many letters, if it has more.
constexpr std::size_t kNarrowest = 12;
/// Width in letters of a column whose title is turned and that has nothing in it.
constexpr std::size_t kTurned = 2;
constexpr std::array kSizes{8.0, 7.5, 7.0};
constexpr std::array kSizesTurned{8.0, 7.5, 7.0, 6.5, 6.0, 5.5, 5.0, 4.5, 4.0};
/// Rows that fit a page below their caption, and rows of tables that do not.
constexpr std::size_t kRowsOfAPage = 64;
constexpr std::size_t kRowsOfALongTable = 16;
/// Rows of a table of frames, which a figure shows better.
constexpr std::size_t kFrames = 6;

std::size_t longest_word(std::string_view text) {
  std::size_t longest = 0;
  std::size_t length = 0;
  for (const char c : text) {
    const bool between = c == ' ' || c == '_';  // titles show the one for the other
    length = between ? 0 : length + 1;
    longest = std::max(longest, length);
  }
  return longest;
}

/// Letters that a column needs for its cells.
std::size_t letters_of_cells(const Table& table, std::size_t column, std::size_t rows) {
  std::size_t most = 0;
  for (std::size_t row = 0; row < std::min(rows, table.rows.size()); ++row) {
    if (column >= table.rows[row].size()) {
      continue;
    }
    const Cell& cell = table.rows[row][column];
    const auto* const words = std::get_if<std::string>(&cell);
    most = std::max(most, words == nullptr ? to_text(cell).size()
                                           : std::max(longest_word(*words),
                                                      std::min(words->size(), kNarrowest)));
  }
  return most;
}

std::size_t letters_of_title(const Column& column) {
  return std::max(longest_word(column.name), column.unit.empty() ? 0 : column.unit.size() + 2);
}

/// True if all rows, and there are some, have the same cell in a column.
bool is_constant(const Table& table, std::size_t column) {
  return table.rows.size() > 1 &&
         std::all_of(table.rows.begin(), table.rows.end(), [&](const std::vector<Cell>& row) {
           return column < row.size() && row[column] == table.rows.front()[column];
         });
}

/// Points that columns of so many letters need.
double width_of(const std::vector<std::size_t>& letters, const std::vector<bool>& left_out,
                double type_size) {
  double ems = 0;
  for (std::size_t k = 0; k < letters.size(); ++k) {
    ems += left_out[k] ? 0 : kLetter * static_cast<double>(letters[k]) + kPadding;
  }
  return ems * type_size;
}

/// The attribute's value after `key` in a tag; empty if there is none.
std::string_view value_in(std::string_view tag, std::string_view key) {
  const std::size_t at = tag.find(key);
  if (at == std::string_view::npos) {
    return {};
  }
  const std::size_t begin = at + key.size();
  return tag.substr(begin, tag.find('"', begin) - begin);
}

/// The name that stands in the place of a link: that of the file, or nothing for one in the page.
std::string name_for(std::string_view target) {
  return target.starts_with("data:") ? std::string() : "<code>" + std::string(target) + "</code>";
}

}  // namespace

std::string opened_for_paper(std::string_view page) {
  constexpr std::string_view kFold = "<details";
  constexpr std::string_view kLink = "<a ";
  constexpr std::string_view kLinkEnd = "</a>";
  std::string out;
  out.reserve(page.size());
  while (!page.empty()) {
    const std::size_t fold = page.find(kFold);
    const std::size_t link = page.find(kLink);
    const std::size_t at = std::min({fold, link, page.size()});
    out += page.substr(0, at);
    page.remove_prefix(at);
    const std::string_view tag = page.substr(0, std::min(page.find('>'), page.size()));
    if (at == fold && fold != std::string_view::npos) {
      out += kFold;
      out += tag.find(" open") == std::string_view::npos ? " open=\"\"" : "";
      page.remove_prefix(kFold.size());
    } else if (at == link && link != std::string_view::npos) {
      const std::string_view target = value_in(tag, "href=\"");
      const std::size_t end = page.find(kLinkEnd);
      if (target.starts_with('#') || end == std::string_view::npos) {
        out += kLink;
        page.remove_prefix(kLink.size());
      } else {
        out += name_for(target);
        page.remove_prefix(end + kLinkEnd.size());
      }
    }
  }
  return out;
}

TableFit fit_on_paper(const Table& table, std::size_t rows) {
  const std::size_t columns = table.columns.size();
  std::vector<std::size_t> cells;
  std::vector<std::size_t> both;
  const std::vector<bool> none(columns, false);
  std::vector<bool> constant;
  std::vector<bool> turned;
  for (std::size_t k = 0; k < columns; ++k) {
    cells.push_back(std::max(letters_of_cells(table, k, rows), kTurned));
    both.push_back(std::max(cells.back(), letters_of_title(table.columns[k])));
    constant.push_back(is_constant(table, k));
    turned.push_back(both.back() > cells.back());
  }
  for (const double size : kSizes) {
    if (width_of(both, none, size) <= kTextWidth) {
      return {size, none, none};
    }
  }
  for (const double size : kSizes) {
    if (width_of(both, constant, size) <= kTextWidth) {
      return {size, constant, none};
    }
  }
  for (const double size : kSizesTurned) {
    if (width_of(cells, constant, size) <= kTextWidth) {
      return {size, constant, turned};
    }
  }
  return {kSizesTurned.back(), constant, turned};
}

std::size_t rows_on_paper(const Table& table) {
  const bool by_frame = std::any_of(table.columns.begin(), table.columns.end(),
                                    [](const Column& column) { return column.name == "frame"; });
  const std::size_t of_a_long_table = by_frame ? kFrames : kRowsOfALongTable;
  return table.rows.size() <= kRowsOfAPage ? table.rows.size() : of_a_long_table;
}

std::vector<std::string> chromium_names() {
  return {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"};
}

std::vector<std::string> chromium_words(const PrintJob& job) {
  std::vector<std::string> words{
      "--headless", "--disable-gpu",
      // Containers have little shared memory.
      "--disable-dev-shm-usage", "--no-first-run", "--no-default-browser-check",
      "--disable-extensions", "--disable-sync", "--disable-component-update",
      "--disable-background-networking", "--disable-default-apps", "--disable-breakpad",
      "--password-store=basic",
      // No name of any machine is looked up, whatever asks for it.
      "--host-resolver-rules=MAP * ~NOTFOUND", "--user-data-dir=" + job.profile.string(),
      "--no-pdf-header-footer", "--generate-pdf-document-outline",
      "--print-to-pdf=" + job.pdf.string()};
  if (job.as_root) {
    words.emplace_back("--no-sandbox");
  }
  words.push_back("file://" + percent_encoded(job.page.string()));
  return words;
}

}  // namespace soms::reproduce
