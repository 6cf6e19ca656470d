/// \file
/// CGAL queried for points.
#pragma once

#include "bench/peers/libraries/library.h"

namespace soms::bench {

void add_cgal_surface(Roster& roster);

}  // namespace soms::bench
