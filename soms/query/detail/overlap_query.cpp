#include "soms/query/detail/overlap_query.h"

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

}  // namespace soms::detail
