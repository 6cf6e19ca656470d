/// \file
/// What single overlap queries and batches share.
#pragma once

#include "soms/query/detail/collector.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/overlap.h"

namespace soms::detail {

/// Coverage of a traversal that ended with `collector`; `late` if a deadline ended it.
[[nodiscard]] Coverage coverage_of(OverlapMode mode, const Collector& collector, bool late);

}  // namespace soms::detail
