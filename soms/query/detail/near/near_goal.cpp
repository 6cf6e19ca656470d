#include "soms/query/detail/near/near_goal.h"

#include "soms/query/detail/leaf_pairs.h"

#include <algorithm>
#include <compare>
#include <limits>

namespace soms::detail {

PairDistance NearGoal::measure(const TrianglePair& ids) const {
  const Triangle x = moved(frame_->x(), ids.a);
  const Triangle y = moved(frame_->y(), ids.b);
  return frame_->swapped() ? PairDistance(y, x) : PairDistance(x, y);
}

bool NearestGoal::offer(const TrianglePair& ids, Cost& cost) {
  const TrianglePair pair = frame().in_callers_order(ids.a, ids.b);
  PairDistance here = measure(ids);
  ++cost.triangle_tests;
  const Bracket bounds = here.bounds();
  if (bounds.lower > upper_) {
    return false;
  }
  if (bounds.lower == 0 && here.compare(0.0) == 0) {
    touching_ = true;
    cost.exact_tests += here.exact_tests();
    nearest_ = here;
    triangles_ = pair;
    keep(ids, true);
    return true;
  }
  bool nearer = true;
  if (triangles_) {
    const std::uint64_t before = nearest_.exact_tests();
    const std::strong_ordering order = here.compare(nearest_);
    cost.exact_tests += nearest_.exact_tests() - before;
    nearer = order < 0 || (order == 0 && pair < *triangles_);
  } else if (bounds.upper > at_most_) {
    nearer = here.compare(at_most_) <= 0;
  }
  cost.exact_tests += here.exact_tests();
  if (nearer) {
    nearest_ = here;
    triangles_ = pair;
    keep(ids, false);
    upper_ = std::min(upper_, here.bounds().upper);
  }
  return false;
}

bool WithinGoal::offer(const TrianglePair& ids, Cost& cost) {
  const TrianglePair pair = frame().in_callers_order(ids.a, ids.b);
  PairDistance here = measure(ids);
  ++cost.triangle_tests;
  const bool within = here.compare(clearance_) <= 0;
  cost.exact_tests += here.exact_tests();
  if (within) {
    found_ = here;
    triangles_ = pair;
    keep(ids, true);
  }
  return within;
}

}  // namespace soms::detail
