#include "soms/robot/detail/state_query.h"

#include "soms/base/double_limits.h"
#include "soms/base/error.h"
#include "soms/motion/detail/moved_bounds.h"
#include "soms/query/contains.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace soms::detail {

namespace {

bool holds(const Box& box, const Vec3& p) {
  return box.lower.x <= p.x && p.x <= box.upper.x && box.lower.y <= p.y && p.y <= box.upper.y &&
         box.lower.z <= p.z && p.z <= box.upper.z;
}

/// At most the gap of two boxes along an axis.
double axis_gap(double lower_a, double upper_a, double lower_b, double upper_b) {
  const double gap = std::max(lower_b - upper_a, lower_a - upper_b);
  return gap > 0 ? std::nextafter(gap, 0.0) : 0;  // the difference was rounded, perhaps up
}

/// At most the distance of any points of two boxes.
double distance_bound(const Box& a, const Box& b) {
  const double x = axis_gap(a.lower.x, a.upper.x, b.lower.x, b.upper.x);
  const double y = axis_gap(a.lower.y, a.upper.y, b.lower.y, b.upper.y);
  const double z = axis_gap(a.lower.z, a.upper.z, b.lower.z, b.upper.z);
  const double largest = std::max({x, y, z});
  const double squares = (x * x + y * y) + z * z;
  // Squares that underflow, or overflow, say nothing. Five roundings add less than 2^-50.
  return squares > 0x1p-900 && squares < 0x1p900
             ? std::max(largest, std::sqrt(squares) * (1 - 0x1p-50))
             : largest;
}

/// The closed surface of a body whose inside is surely a part of it; null if there is none.
const std::optional<ClosedBody>& solid_of(const RobotBody& body) {
  return body.part.closed ? body.part.closed : body.core;
}

}  // namespace

BroadPhase broad_phase_of(const RobotModel& model) {
  std::vector<std::uint32_t> groups;
  for (std::size_t i = 0; i < model.bodies(); ++i) {
    groups.push_back(i < model.link_bodies().size() ? model.body(i).owner + 2 : 1);
  }
  BroadPhase broad_phase;
  broad_phase.set_filter(std::move(groups), {});
  return broad_phase;
}

StateQuery::StateQuery(const RobotModel& model, const RobotOptions& options, const Limits& limits)
    : model_(model),
      options_(options),
      alone_(limits.alone()),
      broad_phase_(broad_phase_of(model)),
      boxes_(model.bodies()),
      closed_(model.bodies()),
      was_closed_(model.bodies(), 0),
      exact_boxes_(model.bodies()) {
  for (std::size_t i = 0; i < model.bodies(); ++i) {
    bodies_.push_back(model.body(i).part.body);
    if (i >= model.link_bodies().size()) {
      boxes_[i] = bodies_[i].shape.bounds();
      closed_[i] = solid_of(model.body(i));
    }
  }
}

RobotAnswer StateQuery::answer(std::span<const double> state) {
  check_stop(alone_);
  RobotAnswer answer;
  answer.beyond_limits = model_.kinematics().beyond_limits(state);
  place_bodies(state);
  cut_ = alone_.late();
  if (cut_) {
    return answer;
  }
  find_contacts(answer);
  answer.verdict = !answer.contacts.empty() ? RobotVerdict::contact
                   : answer.undecided != 0  ? RobotVerdict::undecided
                                            : RobotVerdict::free;
  const bool stopped = options_.first_contact && !answer.contacts.empty();
  if (options_.distance && !cut_) {
    measure(answer);
  }
  answer.coverage = cut_ ? Coverage::cut : stopped ? Coverage::first : Coverage::complete;
  return answer;
}

void StateQuery::place_bodies(std::span<const double> state) {
  const std::vector<Pose> poses = model_.kinematics().link_poses(state, model_.base());
  for (std::size_t i = 0; i < model_.link_bodies().size(); ++i) {
    const RobotBody& body = model_.link_bodies()[i];
    const Pose& pose = poses[body.owner];
    try {
      check(pose);
      check_range(pose, bodies_[i].shape.bounds());
    } catch (const Error& error) {
      throw Error(error.kind(), "link " + model_.link_names()[body.owner] + ": " + error.place(),
                  "give a state that keeps the robot in place");
    }
    bodies_[i].pose = pose;
    boxes_[i] = moved_bounds(pose, bodies_[i].shape.bounds());
    closed_[i].reset();
    was_closed_[i] = 0;
    exact_boxes_[i].clear();
  }
}

/// The pairs whose boxes meet, by pair of the robot, each decided by its pairs of bodies.
void StateQuery::find_contacts(RobotAnswer& answer) {
  std::vector<Candidate> candidates;
  for (const auto& [i, j] : broad_phase_.find(boxes_)) {
    if (model_.compares(i, j)) {
      candidates.push_back({model_.pair_of(i, j), i, j});
    }
  }
  std::sort(candidates.begin(), candidates.end());
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const bool is_new = k == 0 || candidates[k].pair != candidates[k - 1].pair;
    if (is_new && options_.first_contact && !answer.contacts.empty()) {
      return;
    }
    if (cut_) {
      ++answer.undecided;
    } else {
      decide(candidates[k], answer);
    }
  }
}

void StateQuery::decide(const Candidate& candidate, RobotAnswer& answer) {
  const std::size_t i = candidate.i;
  const std::size_t j = candidate.j;
  const bool is_known = !answer.contacts.empty() && answer.contacts.back().pair == candidate.pair;
  if (is_known && answer.contacts.back().surfaces_meet) {
    return;
  }
  const Overlap met =
      counted(overlap(bodies_[i], bodies_[j], {.mode = OverlapMode::any}, alone_), answer);
  if (met.any) {
    if (is_known) {
      answer.contacts.back().surfaces_meet = true;
    } else {
      answer.contacts.push_back({candidate.pair, true});
    }
    return;
  }
  if (cut_) {
    ++answer.undecided;
    return;
  }
  if (is_known) {
    return;
  }
  const std::uint64_t before = answer.undecided;
  if (is_inside(i, j, answer) || is_inside(j, i, answer)) {
    answer.undecided = before;
    answer.contacts.push_back({candidate.pair, false});
  }
  answer.undecided = std::min(answer.undecided, before + 1);  // either way, one pair
}

/// Whether a point of the first body is inside the second. As their surfaces do not meet, each
/// connected part of the first is inside or outside as a whole. \pre They do not meet.
bool StateQuery::is_inside(std::size_t inner, std::size_t outer, RobotAnswer& answer) {
  const RobotBody& body = model_.body(outer);
  if (body.part.closed && body.part.odd_edges != 0 && closed(outer) == nullptr) {
    const bool near = overlaps(exact_boxes(inner).back(), exact_boxes(outer).back());
    answer.undecided += near ? 1U : 0U;
    return false;
  }
  const bool has_solid = solid_of(body).has_value();
  for (const TriangleId triangle : model_.body(inner).connected) {
    const Vec3 point = moved_triangle(bodies_[inner], triangle).a;
    if (!has_solid || !holds(boxes_[outer], point) || closed(outer) == nullptr) {
      continue;
    }
    const Contains found = counted(contains(*closed(outer), point, alone_), answer);
    if (found.side == Side::inside) {
      return true;
    }
    if (cut_) {
      ++answer.undecided;
      return false;
    }
  }
  if (!body.part.closed && may_be_inside(inner, outer, answer)) {
    ++answer.undecided;
  }
  return false;
}

/// Whether a part of the first body may be inside the second, which is open: a connected part lies
/// in its box, or goes through what closes it. \pre Their surfaces do not meet.
bool StateQuery::may_be_inside(std::size_t inner, std::size_t outer, RobotAnswer& answer) {
  const Box& box = exact_boxes(outer).back();
  const std::vector<Box>& inside = exact_boxes(inner);
  if (!overlaps(inside.back(), box)) {
    return false;
  }
  if (std::any_of(inside.begin(), inside.end(), [&](const Box& b) { return box.contains(b); })) {
    return true;
  }
  const Body caps(model_.body(outer).part.caps.shape, bodies_[outer].pose);
  return counted(overlap(bodies_[inner], caps, {.mode = OverlapMode::any}, alone_), answer).any ||
         cut_;
}

/// The closed surface of `solid_of` at a body's pose; null where rounding opens it there.
const ClosedBody* StateQuery::closed(std::size_t i) {
  if (i < model_.link_bodies().size() && was_closed_[i] == 0) {
    was_closed_[i] = 1;
    try {
      closed_[i] = solid_of(model_.body(i))->at(bodies_[i].pose);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::not_closed) {
        throw;
      }
    }
  }
  return closed_[i] ? &*closed_[i] : nullptr;
}

/// The boxes of the moved vertices.
const std::vector<Box>& StateQuery::exact_boxes(std::size_t i) {
  std::vector<Box>& boxes = exact_boxes_[i];
  if (boxes.empty()) {
    const RobotBody& body = model_.body(i);
    boxes.resize(body.connected.size() + 1);
    for (TriangleId t = 0; t < bodies_[i].shape.mesh().triangles.size(); ++t) {
      boxes[body.connected_of.empty() ? 0 : body.connected_of[t]].grow(
          bounds(moved_triangle(bodies_[i], t)));
    }
    for (std::size_t k = 0; k < body.connected.size(); ++k) {
      boxes.back().grow(boxes[k]);
    }
  }
  return boxes;
}

/// All pairs of bodies that may be within a distance, the nearest boxes first.
std::vector<StateQuery::Candidate> StateQuery::by_bound(double at_most) const {
  std::vector<Candidate> candidates;
  for (std::uint32_t i = 0; i < model_.link_bodies().size(); ++i) {
    for (std::uint32_t j = i + 1; j < model_.bodies(); ++j) {
      if (!model_.compares(i, j)) {
        continue;
      }
      const double bound = distance_bound(boxes_[i], boxes_[j]);
      if (bound <= at_most) {
        candidates.push_back({model_.pair_of(i, j), i, j, bound});
      }
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.bound, a.pair, a.i, a.j) < std::tie(b.bound, b.pair, b.i, b.j);
  });
  return candidates;
}

/// Which of several pairs with distances in the same bracket is named must not depend on the boxes,
/// so all that may be as near are measured.
void StateQuery::measure(RobotAnswer& answer) {
  RobotGap gap{.distance = {kInfinity, kInfinity}};
  if (!answer.contacts.empty()) {
    answer.gap = RobotGap{.distance = {0, 0}, .pair = answer.contacts.front().pair};
    return;
  }
  bool any = false;
  std::optional<Candidate> nearest;
  for (const Candidate& candidate : by_bound(options_.at_most)) {
    const double most = std::min(options_.at_most, gap.distance.upper);
    if (candidate.bound > most) {
      break;
    }
    const Distance found = counted(
        distance(bodies_[candidate.i], bodies_[candidate.j], {.at_most = most}, alone_), answer);
    if (cut_) {
      return;
    }
    any = true;
    if (found.farther || !found.triangles) {
      continue;
    }
    const auto key = [](const Bracket& b, const Candidate& c) {
      return std::tuple(b.lower, b.upper, c.pair, c.i, c.j);
    };
    if (!nearest || key(found.distance, candidate) < key(gap.distance, *nearest)) {
      nearest = candidate;
      gap = {.distance = found.distance,
             .pair = candidate.pair,
             .points = std::array{found.point_a, found.point_b}};
    }
  }
  const bool compares_any = any || !by_bound(kInfinity).empty();
  if (!nearest && compares_any && !std::isinf(options_.at_most)) {
    gap.farther = true;
    gap.distance = {options_.at_most, kInfinity};
  }
  answer.gap = gap;
}

}  // namespace soms::detail
