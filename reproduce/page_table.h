/// \file
/// A table as a part of the page.
#pragma once

#include "reproduce/report.h"
#include "reproduce/result.h"

#include <string>

namespace soms::reproduce {

/// The table with its caption and its file; a long one is folded and shows its first rows.
[[nodiscard]] std::string markup_of(const Table& table, PageFiles files);

}  // namespace soms::reproduce
