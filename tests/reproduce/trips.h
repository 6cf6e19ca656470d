/// \file
/// What the tests of the experiments about traversals share: small models, cells, what may differ.
#pragma once

#include "thesis/run/experiment.h"
#include "thesis/run/result.h"
#include "thesis/trips/models.h"

#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce::trips {

/// Experiments about traversals: their items.
[[nodiscard]] std::vector<std::string_view> traversal_items();

/// A knot of 60 triangles in the place of the bunny, and a ball in the way of the drive in the
/// place of a scene: every experiment about traversals takes moments.
[[nodiscard]] Models small_models();

/// The small models, and a ball in the place of another object.
[[nodiscard]] Models two_objects();

/// Runs an experiment by its item, quick.
[[nodiscard]] Result run_quick(std::string_view item, const Models& models);

/// The table with this id. \pre The result has it.
[[nodiscard]] const Table& table_of(const Result& result, std::string_view id);

/// Text of a cell in a column, as in the CSV.
[[nodiscard]] std::string cell(const Table& table, std::size_t row, std::string_view column);

/// The table as CSV with empty cells where runs may differ.
[[nodiscard]] std::string masked_csv(Table table);

}  // namespace soms::reproduce::trips
