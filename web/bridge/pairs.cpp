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
#include <utility>

using soms::Body;
using soms::Pose;
using soms::web::Answer;
using soms::web::answer_of;
using soms::web::deadline_after;
using soms::web::guarded;
using soms::web::HeldShape;

/// `limit` is infinite for none. Columns: any u8, coverage u8, offsets u32, pairs u32 x 2, cost.
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
    options.deadline = deadline_after(milliseconds);
    soms::OverlapBatch found =
        overlap(mover->shape(), std::span(poses, count), Body(fixed->shape(), *pose), options);
    return answer_of(std::move(found.any), found.coverage, found.offsets, std::move(found.pairs),
                     found.cost);
  });
}

/// Columns: lower f64, upper f64, triangles i32 x 2, points of both f64 x 3, farther u8, coverage
/// u8, cost.
SOMS_EXPORT(soms_distance)

Answer* soms_distance(const HeldShape* mover, const Pose* poses, std::uint32_t count,
                      const HeldShape* fixed, const Pose* pose, double at_most,
                      double milliseconds) {
  return guarded([&] {
    soms::DistanceOptions options;
    options.at_most = at_most;
    options.deadline = deadline_after(milliseconds);
    soms::DistanceBatch found =
        distance(mover->shape(), std::span(poses, count), Body(fixed->shape(), *pose), options);
    return answer_of(std::move(found.lower), std::move(found.upper), found.triangles,
                     std::move(found.point_a), std::move(found.point_b), std::move(found.farther),
                     found.coverage, found.cost);
  });
}
