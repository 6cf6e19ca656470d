/// \file
/// What `thesis` says of its tests, for programs.
#pragma once

#include "apps/output/json.h"
#include "apps/soms/thesis/thesis_output.h"

#include <ostream>

namespace soms::command {

/// One document: the options, then each test with its summary and its frames.
[[nodiscard]] Json thesis_json(const ThesisReport& report);

/// A row for each frame of each test.
void write_thesis_csv(std::ostream& out, const ThesisReport& report);

}  // namespace soms::command
