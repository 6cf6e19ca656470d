/// \file
/// Where a run's results come from, as parts of its page: program, machine, load, files of models.
#pragma once

#include "thesis/page/report.h"

#include <string>

namespace soms::reproduce {

/// The facts of a run as a list: the short ones, and the others folded away.
[[nodiscard]] std::string run_facts(const Report& report);

/// A paragraph that warns of a busy machine; empty if it was not.
[[nodiscard]] std::string load_warning(const Load& load);

/// A folded table of the models' files with their sizes and SHA-256; empty if there are none.
[[nodiscard]] std::string model_files(const Models& models);

}  // namespace soms::reproduce
