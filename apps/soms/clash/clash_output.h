/// \file
/// A clash list as text, JSON and CSV.
#pragma once

#include "apps/soms/clash/clash_rows.h"

#include <ostream>

namespace soms::command {

class Console;
class JsonListWriter;

/// A row as JSON has it: the sides, the class and what is known of it, and its key.
[[nodiscard]] Json row_as_json(const ClashReport& report, const ClashRow& row);

/// For people: how many of each kind, and the first rows.
void print_clashes_as_text(const ClashReport& report, Console& console);

/// A row a clash, and an end that counts them (soms.clash/1). `verified` adds the key of this name.
void write_clashes_as_json(const ClashReport& report, bool verified, JsonListWriter& list);

/// A head, and a row a clash; those that are resolved come last.
void write_clashes_as_csv(const ClashReport& report, std::ostream& out);

}  // namespace soms::command
