#include "soms/query/overlap.h"

#include "soms/base/arithmetic.h"
#include "soms/base/hash.h"
#include "soms/base/idle_option.h"
#include "soms/query/detail/check_options.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/overlap_search.h"

namespace soms {

std::uint64_t Overlap::hash() const {
  Fnv1a hash;
  for (const auto& [i, j] : pairs) {
    hash.add(i);
    hash.add(j);
  }
  return hash.value();
}

void detail::check_options(const OverlapOptions& options) {
  const bool limited = options.limit != OverlapOptions{}.limit && options.limit > 0;
  if (limited && options.mode != OverlapMode::all) {
    refuse_idle("overlap options",
                {"limit", "modes any and first return one pair at most", "mode", "all"});
  }
}

Overlap overlap(const Body& a, const Body& b, const OverlapOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_options(options);
  detail::check_pose(a.pose, a.shape);
  detail::check_pose(b.pose, b.shape);
  check_stop(limits);
  Overlap answer;
  if (detail::is_empty(a.shape) || detail::is_empty(b.shape)) {
    return answer;
  }
  detail::PairFrame frame(a, b);
  detail::search_overlap(frame, options, limits, answer);
  return answer;
}

}  // namespace soms
