/// \file
/// What `info` reports about a folder of tiles.
#pragma once

#include "apps/model/models.h"

#include <string>

namespace soms::command {

class Console;

/// Prints what the manifest says; with `verify` after looking at every tile and every box.
/// \errors As `TileSet::open` and `open_tile`; ErrorKind::usage for options of models.
void print_tiles(const std::string& folder, ModelOptions model, bool verify, Console& console);

}  // namespace soms::command
