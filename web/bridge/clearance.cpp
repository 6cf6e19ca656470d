// Clearance and solids, for a batch of poses of the first body.
#include "soms/query/solid.h"
#include "soms/query/within.h"

#include "web/bridge/answer.h"
#include "web/bridge/arguments.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <span>

using soms::Body;
using soms::Pose;
using soms::web::Answer;
using soms::web::answer_of_batch;
using soms::web::guarded;
using soms::web::HeldShape;
using soms::web::within_time;

// Columns are those of the fields of the answer (fields.js), and its cost.

SOMS_EXPORT(soms_within)

Answer* soms_within(const HeldShape* mover, const Pose* poses, std::uint32_t count,
                    const HeldShape* fixed, const Pose* pose, double clearance,
                    double milliseconds) {
  return guarded([&] {
    return answer_of_batch<soms::Within>(within(mover->shape(), std::span(poses, count),
                                                Body(fixed->shape(), *pose), clearance,
                                                within_time(milliseconds)));
  });
}

SOMS_EXPORT(soms_solid)

Answer* soms_solid(HeldShape* mover, const Pose* poses, std::uint32_t count, HeldShape* fixed,
                   const Pose* pose, double milliseconds) {
  return guarded([&]() -> Answer* {
    const soms::ClosedBody closed = mover->closed_at(count > 0 ? *poses : Pose());
    return answer_of_batch<soms::Solid>(
        solid(closed, std::span(poses, count), fixed->closed_at(*pose), within_time(milliseconds)));
  });
}
