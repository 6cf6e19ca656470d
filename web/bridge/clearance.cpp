// Clearance and solids, for a batch of poses of the first body.
#include "soms/query/solid.h"
#include "soms/query/within.h"

#include "web/bridge/answer.h"
#include "web/bridge/arguments.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <span>
#include <utility>

using soms::Body;
using soms::Pose;
using soms::web::Answer;
using soms::web::answer_of;
using soms::web::deadline_after;
using soms::web::guarded;
using soms::web::HeldShape;

/// Columns: within u8, triangles i32 x 2, points of both f64 x 3, lower bounds f64, coverage u8,
/// cost.
SOMS_EXPORT(soms_within)

Answer* soms_within(const HeldShape* mover, const Pose* poses, std::uint32_t count,
                    const HeldShape* fixed, const Pose* pose, double clearance,
                    double milliseconds) {
  return guarded([&] {
    soms::WithinOptions options;
    options.deadline = deadline_after(milliseconds);
    soms::WithinBatch found = within(mover->shape(), std::span(poses, count),
                                     Body(fixed->shape(), *pose), clearance, options);
    return answer_of(std::move(found.within), found.triangles, std::move(found.point_a),
                     std::move(found.point_b), std::move(found.at_least), found.coverage,
                     found.cost);
  });
}

/// Columns: relation u8, surfaces meet u8, why it is undecided u8, coverage u8, cost.
SOMS_EXPORT(soms_solid)

Answer* soms_solid(HeldShape* mover, const Pose* poses, std::uint32_t count, HeldShape* fixed,
                   const Pose* pose, double milliseconds) {
  return guarded([&]() -> Answer* {
    soms::SolidOptions options;
    options.deadline = deadline_after(milliseconds);
    const soms::ClosedBody closed = mover->closed_at(count > 0 ? *poses : Pose());
    soms::SolidBatch found =
        solid(closed, std::span(poses, count), fixed->closed_at(*pose), options);
    return answer_of(found.relation, std::move(found.surfaces_meet), found.why, found.coverage,
                     found.cost);
  });
}
