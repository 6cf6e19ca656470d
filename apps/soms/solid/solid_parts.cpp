#include "apps/soms/solid/solid_parts.h"

#include "soms/base/error.h"
#include "soms/query/overlap.h"

#include <utility>

namespace soms::command {

namespace {

/// A body at a pose, if it is closed there.
std::optional<ClosedBody> closed_at(const std::optional<ClosedBody>& body, const Pose& pose) {
  if (!body) {
    return std::nullopt;
  }
  try {
    return body->at(pose);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::not_closed) {
      throw;
    }
    return std::nullopt;
  }
}

/// A part where a pose has moved it, and the box around it.
struct PlacedPart {
  const PartBody* part;
  std::optional<ClosedBody> closed;
  Box box;
};

std::vector<PlacedPart> placed_parts(const std::vector<PartBody>& parts, const Pose& pose) {
  std::vector<PlacedPart> placed;
  for (const PartBody& part : parts) {
    placed.push_back({&part, closed_at(part.closed, pose), {}});
    for (const Vec3& v : part.body.shape.mesh().vertices) {
      placed.back().box.grow(pose.apply(v));
    }
  }
  return placed;
}

}  // namespace

Solid open_answer(const Body& a, const Body& b, const Limits& limits) {
  const Overlap met = overlap(a, b, {.mode = OverlapMode::any}, limits);
  return {
      .surfaces_meet = met.any, .why = Undecided::open, .coverage = met.coverage, .cost = met.cost};
}

std::vector<SolidPair> solid_pairs(const std::vector<PartBody>& a, const Pose& pose_a,
                                   const std::vector<PartBody>& b, const Pose& pose_b,
                                   const Limits& limits) {
  const std::vector<PlacedPart> placed_a = placed_parts(a, pose_a);
  const std::vector<PlacedPart> placed_b = placed_parts(b, pose_b);
  const Limits alone = limits.alone();
  std::vector<SolidPair> pairs;
  for (const PlacedPart& pa : placed_a) {
    check_stop(limits);
    for (const PlacedPart& pb : placed_b) {
      if (!overlaps(pa.box, pb.box)) {
        continue;
      }
      const Solid answer = pa.closed && pb.closed
                               ? solid(*pa.closed, *pb.closed, alone)
                               : open_answer(Body(pa.part->body.shape, pose_a),
                                             Body(pb.part->body.shape, pose_b), alone);
      if (answer.relation != Relation::clear) {
        pairs.push_back({pa.part, pb.part, answer});
      }
    }
  }
  return pairs;
}

}  // namespace soms::command
