#include "soms/robot/detail/path_query.h"

#include "soms/base/double_limits.h"
#include "soms/base/error.h"
#include "soms/motion/detail/contact_query.h"
#include "soms/motion/detail/motion_bounds.h"
#include "soms/motion/detail/moved_bounds.h"
#include "soms/query/detail/relative_pose.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soms::detail {

namespace {

void fold_in(RobotSegment& segment, const FirstContact& found) {
  segment.cost += found.cost;
  segment.coverage = found.coverage == Coverage::cut ? Coverage::cut : segment.coverage;
}

/// The last state is in contact, and nothing before is proved to be.
void end_in_contact(RobotSegment& segment, const RobotAnswer& last) {
  segment.t.lower = std::min(segment.t.lower, std::nextafter(1.0, 0.0));
  segment.t.upper = 1;
  segment.verdict = ContactVerdict::contact;
  segment.pair = last.contacts.front().pair;
  segment.point.reset();
}

}  // namespace

PathQuery::PathQuery(const RobotModel& model, const RobotChains& chains, const Limits& limits)
    : model_(model),
      chains_(chains),
      alone_(limits.alone()),
      broad_phase_(broad_phase_of(model)),
      boxes_(model.bodies()) {
  for (std::size_t i = model.link_bodies().size(); i < model.bodies(); ++i) {
    const Body& body = model.body(i).part.body;
    boxes_[i] = moved_bounds(body.pose, body.shape.bounds());
  }
}

RobotSegment PathQuery::answer(std::span<const double> from, std::span<const double> to,
                               const RobotAnswer& first, const RobotAnswer& last) {
  check_stop(alone_);
  RobotSegment segment{.t = {1, kInfinity}, .undecided = first.undecided + last.undecided};
  if (first.verdict == RobotVerdict::contact) {
    segment.verdict = ContactVerdict::started;
    segment.t = {0, 0};
    segment.pair = first.contacts.front().pair;
    return segment;
  }
  const bool cut = first.coverage == Coverage::cut || last.coverage == Coverage::cut;
  if (cut || alone_.late()) {
    segment.verdict = ContactVerdict::grazing;
    segment.t.lower = 0;
    segment.coverage = Coverage::cut;
    return segment;
  }
  follow(StateMotion(chains_, from, to), last, segment);
  if (segment.verdict != ContactVerdict::contact && last.verdict == RobotVerdict::contact) {
    end_in_contact(segment, last);
  }
  if (segment.verdict == ContactVerdict::free && segment.undecided != 0) {
    segment.verdict = ContactVerdict::grazing;
    segment.t.lower = std::nextafter(1.0, 0.0);
  }
  segment.t.lower = first.undecided != 0 ? 0 : segment.t.lower;
  return segment;
}

void PathQuery::follow(const StateMotion& motion, const RobotAnswer& last, RobotSegment& segment) {
  sweep_boxes(motion);
  std::vector<Near> all;
  for (const auto& [i, j] : broad_phase_.find(boxes_)) {
    if (model_.compares(i, j)) {
      all.push_back({model_.pair_of(i, j), i, j});
    }
  }
  std::sort(all.begin(), all.end());
  const EndsOfWay ends =
      last.verdict == RobotVerdict::contact ? EndsOfWay::unknown : EndsOfWay::free;
  for (const Near& near : all) {
    const ChainLaw law = law_of(motion, near.i, near.j);
    if (near.j >= model_.link_bodies().size() && law.rests()) {
      continue;  // at the same pose, bit by bit, as in the first state
    }
    const FirstContact found =
        first_contact_by(law, shape(near.i), shape(near.j), {}, alone_, {.ends = ends});
    fold_in(segment, found);
    if (found.verdict != ContactVerdict::free) {
      add(near, found, segment);
    }
  }
}

/// A body stays in the hull of its boxes at both ends, but for what its curves leave their chords
/// by, the slack of both, and an end's rounding, which the slack is far above. Nor does it leave
/// its reach, which keeps the ends in range.
void PathQuery::sweep_boxes(const StateMotion& motion) {
  for (std::uint32_t i = 0; i < model_.link_bodies().size(); ++i) {
    const Box& bounds = shape(i).bounds();
    if (bounds.empty()) {
      continue;
    }
    const ChainLaw law(motion, model_.body(i).owner, bounds, Pose());
    Box& box = boxes_[i];
    box = moved_bounds(law.at(0), bounds);
    box.grow(moved_bounds(law.at(1), bounds));
    const double arm = law.arm(farthest(bounds));
    const double more = MotionBounds::bow(law.curvature(0, 1).of(arm), 1) + 4 * law.slack();
    for (std::size_t k = 0; k < 3; ++k) {
      box.lower[k] = std::max(box.lower[k] - more, -law.reach());
      box.upper[k] = std::min(box.upper[k] + more, law.reach());
    }
  }
}

ChainLaw PathQuery::law_of(const StateMotion& motion, std::uint32_t i, std::uint32_t j) const {
  const std::uint32_t link = model_.body(i).owner;
  if (j >= model_.link_bodies().size()) {
    return ChainLaw(motion, link, shape(i).bounds(), model_.body(j).part.body.pose);
  }
  return ChainLaw(motion, link, shape(i).bounds(), model_.body(j).owner, shape(j).bounds());
}

/// A contact goes before what is not proved to be one; of contacts the earliest is named, of all
/// others the one that is not free first.
void PathQuery::add(const Near& near, const FirstContact& found, RobotSegment& segment) const {
  const bool is_contact = found.t.upper < kInfinity;
  const bool has_contact = segment.t.upper < kInfinity;
  if (is_contact ? found.t.upper < segment.t.upper
                 : !has_contact && found.t.lower < segment.t.lower) {
    segment.pair = near.pair;
    segment.point = found.triangles ? std::optional(found.point) : std::nullopt;
  }
  if (is_contact || !has_contact) {
    segment.verdict = is_contact ? ContactVerdict::contact : ContactVerdict::grazing;
  }
  segment.t.lower = std::min(segment.t.lower, found.t.lower);
  segment.t.upper = std::min(segment.t.upper, found.t.upper);
}

}  // namespace soms::detail
