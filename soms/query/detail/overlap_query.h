/// \file
/// What single overlap queries and batches share.
#pragma once

#include "soms/query/detail/collector.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/overlap.h"

namespace soms::detail {

/// Coverage of a traversal that ended with `collector`; `late` if a deadline ended it.
[[nodiscard]] Coverage coverage_of(OverlapMode mode, const Collector& collector, bool late);

/// The least pair of triangles that overlap, by (i, j).
struct LeastOverlap {
  TrianglePair triangles;
  Cost cost;
  bool late = false;  ///< a deadline ended the search; there may be a lesser pair
};

/// The least pair of a and b, given one that overlaps.
/// \errors ErrorKind::cancelled.
[[nodiscard]] LeastOverlap least_overlap(PairFrame& frame, const TrianglePair& known,
                                         const Limits& limits);

}  // namespace soms::detail
