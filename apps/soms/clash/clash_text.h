/// \file
/// A clash list as text.
#pragma once

#include "apps/soms/clash/clash_rows.h"

namespace soms::command {

class Console;

/// For people: how many of each kind, and the first rows, the worst of each class first. On a
/// terminal they are a table.
void print_clashes_as_text(const ClashReport& report, Console& console);

}  // namespace soms::command
