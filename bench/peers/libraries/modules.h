/// \file
/// Peers that are installed: each is a module beside the program, loaded when it runs.
#pragma once

#include "bench/peers/libraries/library.h"

#include <filesystem>
#include <string>
#include <vector>

namespace soms::bench {

/// Adds the libraries of every module in `folder`, in the order of their names; says of each
/// module that cannot be loaded (its library is not installed) why.
[[nodiscard]] std::vector<std::string> add_modules(Roster& roster,
                                                   const std::filesystem::path& folder);

/// Where modules lie: the folder soms-peers beside this program.
[[nodiscard]] std::filesystem::path module_folder();

}  // namespace soms::bench
