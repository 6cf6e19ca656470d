#include "soms/query/self_overlap.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/parts/joined.h"
#include "soms/query/detail/check_options.h"
#include "soms/query/detail/overlap_search.h"
#include "soms/query/detail/self/duplicates.h"
#include "soms/query/detail/self/self_frame.h"

#include <utility>

namespace soms {

SelfOverlap self_overlap(const Shape& shape, const SelfOverlapOptions& options,
                         const Limits& limits) {
  const PlainArithmetic plain;
  const OverlapOptions wanted{options.mode, options.limit};
  detail::check_options(wanted);
  check_stop(limits);
  if (detail::is_empty(shape)) {
    return {};
  }
  std::vector<std::uint32_t> joined;
  if (options.by == CommonCorners::position) {
    if (limits.late()) {
      SelfOverlap nothing;
      nothing.coverage = Coverage::cut;
      return nothing;
    }
    Limits joining;  // one bar of progress is enough
    joining.stop = limits.stop;
    detail::Work work(joining, detail::joining_work(shape.mesh()));
    joined = detail::joined_by_position(shape.mesh(), work);
  }
  const Body body{shape};
  detail::SelfFrame frame(body, joined);
  Overlap found;
  detail::search_overlap(frame, wanted, limits, found);
  SelfOverlap answer{found.any, std::move(found.pairs), {}, found.coverage, found.cost};
  if (frame.met_duplicates() && options.mode == OverlapMode::all &&
      !detail::list_duplicates(frame, options.limit, limits, answer.duplicates)) {
    answer.coverage = Coverage::cut;
  }
  return answer;
}

}  // namespace soms
