/// \file
/// A clash list as JSON and CSV.
#pragma once

#include "apps/soms/clash/clash_rows.h"

#include <cstdint>
#include <ostream>
#include <utility>

namespace soms::command {

class JsonListWriter;

/// A row as JSON has it: the sides, the class and what is known of it, and its key.
[[nodiscard]] Json row_as_json(const ClashReport& report, const ClashRow& row);

/// What the two parts of a clash stand for.
[[nodiscard]] std::pair<const PartBody&, const PartBody&> bodies_in(const ClashModels& models,
                                                                    const Clash& clash);

/// How many rows have a status.
[[nodiscard]] std::uint64_t count_status(const ClashReport& report, ClashStatus status);

/// A row a clash, and an end that counts them (soms.clash/1). `verified` adds the key of this name.
void write_clashes_as_json(const ClashReport& report, bool verified, JsonListWriter& list);

/// A head, and a row a clash; those that are resolved come last.
void write_clashes_as_csv(const ClashReport& report, std::ostream& out);

}  // namespace soms::command
