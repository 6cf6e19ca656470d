#include "soms/query/detail/overlap_query.h"

#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/overlap_traversal.h"

#include <vector>

namespace soms::detail {

Coverage coverage_of(OverlapMode mode, const Collector& collector, bool late) {
  if (collector.full()) {
    return Coverage::cut;
  }
  if (mode == OverlapMode::any && collector.any()) {
    return Coverage::first;
  }
  if (late) {
    return Coverage::cut;
  }
  return mode == OverlapMode::first && collector.any() ? Coverage::first : Coverage::complete;
}

namespace {

template <class Source>
LeastOverlap search(PairFrame& frame, const TrianglePair& known, Limit& limit) {
  TraversalMemory memory;
  std::vector<TrianglePair> pairs;
  Collector collector(OverlapMode::first, 1, pairs);
  static_cast<void>(collector.add(known));
  OverlapTraversal<Source> traversal(frame, OverlapMode::first, memory);
  traversal.start();
  traversal.run(collector, limit);
  collector.finish();
  return {pairs.front(), traversal.cost(), limit.late()};
}

}  // namespace

LeastOverlap least_overlap(PairFrame& frame, const TrianglePair& known, const Limits& limits) {
  Limit limit(limits);
  return any_compact(*frame.x().shape, *frame.y().shape)
             ? search<CompactSource>(frame, known, limit)
             : search<WideSource>(frame, known, limit);
}

}  // namespace soms::detail
