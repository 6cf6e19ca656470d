/// \file
/// A table as a part of the page.
#pragma once

#include "reproduce/report.h"
#include "reproduce/result.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace soms::reproduce {

/// "1 row", "1,000 rows".
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// The table with its caption and its file; a long one is folded and shows its first rows.
[[nodiscard]] std::string markup_of(const Table& table, PageFiles files);

}  // namespace soms::reproduce
