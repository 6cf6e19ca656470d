/// \file
/// A table as a part of the page.
#pragma once

#include "thesis/page/report.h"
#include "thesis/run/result.h"

#include <string>

namespace soms::reproduce {

/// The table with its caption and its file; a long one is folded and shows its first rows.
[[nodiscard]] std::string markup_of(const Table& table, PageFiles files);

/// The same, where the file is that of another table with the same numbers.
[[nodiscard]] std::string markup_of(const Table& table, PageFiles files, const Table& of_file);

/// A paragraph with the file of a table, or with the table itself as a file.
[[nodiscard]] std::string file_note(const Table& table, PageFiles files);

}  // namespace soms::reproduce
