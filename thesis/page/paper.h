/// \file
/// The page of a run on paper: what differs from the page on a screen, and how Chromium prints it.
#pragma once

#include "thesis/run/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// The markup of a page for paper, where nobody can click: all that is folded is open, a link to a
/// file becomes the file's name, links within the page stay.
[[nodiscard]] std::string opened_for_paper(std::string_view page);

/// How a table fits the width of a sheet.
struct TableFit {
  double type_size = 0;             ///< points
  std::vector<bool> left_out = {};  ///< columns with one value in all rows, said below the table
  std::vector<bool> turned = {};    ///< columns whose title stands upright
};

/// How the first `rows` rows of a table fit the width of the text, by an estimate of the width of
/// letters. Only where smaller type does not do, columns that say nothing are left out; only where
/// that does not do, titles are turned.
[[nodiscard]] TableFit fit_on_paper(const Table& table, std::size_t rows);

/// The rows of a table that paper shows: all of them if they fit a page, else the first ones.
[[nodiscard]] std::size_t rows_on_paper(const Table& table);

/// What Chromium reads and writes.
struct PrintJob {
  std::filesystem::path page;     ///< an absolute path
  std::filesystem::path pdf;      ///< written
  std::filesystem::path profile;  ///< a folder that is Chromium's alone
  bool as_root = false;           ///< as root Chromium runs without its own sandbox only
};

/// Names under which Chromium is installed, the most likely first.
[[nodiscard]] std::vector<std::string> chromium_names();

/// The words of Chromium's command line, after its name, that print a page without asking a network
/// for anything.
[[nodiscard]] std::vector<std::string> chromium_words(const PrintJob& job);

}  // namespace soms::reproduce
