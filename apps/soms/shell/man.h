/// \file
/// The verb `man`: pages of the manual, made from the text of --help.
#pragma once

#include "apps/cli/verb.h"

#include <string>

namespace soms::command {

/// Options of the verb `man`.
struct ManOptions {
  std::string verb;    ///< whose page is printed; empty: the command's
  std::string folder;  ///< gets all pages as files instead
};

[[nodiscard]] Action add_man(Parser& parser, Shared& shared);
[[nodiscard]] int run_man(const ManOptions& options, Console& console);

}  // namespace soms::command
