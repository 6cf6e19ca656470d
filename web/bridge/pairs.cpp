// Overlap and distance of two surfaces, for a batch of poses of the first.
#include "soms/query/distance.h"
#include "soms/query/overlap.h"

#include "web/bridge/answer.h"
#include "web/bridge/arguments.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <cmath>
#include <limits>
#include <span>

using soms::Body;
using soms::Pose;
using soms::web::Answer;
using soms::web::answer_of_batch;
using soms::web::answer_of_lists;
using soms::web::guarded;
using soms::web::HeldShape;
using soms::web::within_time;

// Columns are those of the fields of the answer (fields.js), and its cost.

/// `limit` is infinite for none.
SOMS_EXPORT(soms_overlap)

Answer* soms_overlap(const HeldShape* mover, const Pose* poses, std::uint32_t count,
                     const HeldShape* fixed, const Pose* pose, std::uint32_t mode, double limit,
                     double milliseconds) {
  return guarded([&] {
    soms::OverlapOptions options;
    options.mode = static_cast<soms::OverlapMode>(mode);
    if (std::isfinite(limit)) {
      options.limit = static_cast<std::uint64_t>(limit);
    }
    return answer_of_lists(overlap(mover->shape(), std::span(poses, count),
                                   Body(fixed->shape(), *pose), options,
                                   within_time(milliseconds)));
  });
}

SOMS_EXPORT(soms_distance)

Answer* soms_distance(const HeldShape* mover, const Pose* poses, std::uint32_t count,
                      const HeldShape* fixed, const Pose* pose, double at_most,
                      double milliseconds) {
  return guarded([&] {
    soms::DistanceOptions options;
    options.at_most = at_most;
    return answer_of_batch<soms::Distance>(distance(mover->shape(), std::span(poses, count),
                                                    Body(fixed->shape(), *pose), options,
                                                    within_time(milliseconds)));
  });
}
