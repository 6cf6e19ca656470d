/// \file
/// Embree queried for points and rays.
#pragma once

#include "bench/peers/libraries/library.h"

namespace soms::bench {

void add_embree_surface(Roster& roster);

}  // namespace soms::bench
