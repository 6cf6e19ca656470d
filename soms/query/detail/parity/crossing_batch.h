/// \file
/// Batches of points whose queries need to know which triangles a ray meets.
#pragma once

#include "soms/base/parallel.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/parity/parity_frame.h"
#include "soms/query/detail/parity/parity_traversal.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace soms::detail {

/// Points that a thread takes at a time.
inline constexpr std::size_t kPointsOfListing = 256;

/// Calls `answer(memory, i, met, limit)` for each point, once it is known what its ray meets, and
/// for none whose ray was not finished in time. `memory` is a `Memory` of the thread. Costs of the
/// rays are added to `costs`.
/// \pre    The body is not empty.
/// \errors Those of `answer`; ErrorKind::cancelled.
template <class Memory, class Answer>
void for_each_crossing(const Body& body, const ParityFrame& frame, std::span<const Vec3> points,
                       std::span<Cost> costs, const Limits& limits, const Answer& answer) {
  struct ThreadMemory {
    std::unique_ptr<CrossingMemory> rays;
    std::vector<PointCrossings> met;
    Memory own = {};
  };

  const auto make = [&] {
    return ThreadMemory{crossing_memory(body, frame),
                        std::vector<PointCrossings>(std::min(points.size(), kPointsOfListing))};
  };
  MemoryPool<ThreadMemory> pool;
  for_each_chunk(points.size(), kPointsOfListing, limits.without_deadline(),
                 [&](std::size_t begin, std::size_t end) {
                   auto place = pool.take(make);
                   ThreadMemory& memory = place->memory;
                   const std::span<PointCrossings> met(memory.met.data(), end - begin);
                   for (PointCrossings& row : met) {
                     row.complete = false;
                   }
                   Limit limit(limits);
                   memory.rays->list(points.subspan(begin, met.size()), met,
                                     costs.subspan(begin, met.size()), limit);
                   for (std::size_t k = 0; k < met.size() && !limit.late(); ++k) {
                     if (met[k].complete) {
                       answer(memory.own, begin + k, met[k], limit);
                     }
                   }
                   pool.give_back(std::move(place));
                 });
}

}  // namespace soms::detail
