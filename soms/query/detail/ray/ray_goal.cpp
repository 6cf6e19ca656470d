#include "soms/query/detail/ray/ray_goal.h"

#include "soms/query/detail/ray/moved_triangle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace soms::detail {

namespace {

/// Bounds of a time in units of the scaled direction.
TimeBounds bounds_of(const ExactRay& exact, const RayTarget& target, const Triangle& triangle) {
  if (exact.side() != 0) {
    if (const auto bounds = time_bounds(target.line, target.direction, triangle)) {
      return *bounds;
    }
  }
  constexpr double kRounding = 0x1p-50;
  constexpr double kLeast = 0x1p-1000;  // beyond what underflows
  const Bracket t = bracket(exact.time());
  const int exponent = target.direction.exponent;
  return {std::ldexp(t.lower, exponent) * (1 - kRounding) - kLeast,
          std::ldexp(t.upper, exponent) * (1 + kRounding) + kLeast, exact.side()};
}

/// Calls `of(id, inside)` for the triangles of a block that are still to be decided.
template <class Of>
void for_each_candidate(const RayTarget& target, const LineBlockTask& task, std::uint32_t lanes,
                        const Of& of) {
  for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    const TriangleId id = task.block->id[lane];
    if (id != target.skip && !(task.near[lane] > target.course.numbers.far_open)) {
      of(id, (task.through >> lane & 1U) != 0);
    }
  }
}

}  // namespace

std::optional<Meeting> meet(RayTarget& target, TriangleId id, bool inside) {
  const Triangle triangle = moved_triangle(*target.body, id);
  if (inside) {
    if (const auto bounds = time_bounds(target.line, target.direction, triangle)) {
      if (bounds->upper < 0 || bounds->lower > target.course.longest) {
        return std::nullopt;
      }
      if (bounds->lower > 0 && bounds->upper < target.course.shortest) {
        return Meeting{{*bounds, id, true}, nullptr};
      }
    }
  }
  ++target.cost.exact_tests;
  auto exact = std::make_unique<ExactRay>(target.line, triangle);
  if (!exact->hit()) {
    return std::nullopt;
  }
  return Meeting{{bounds_of(*exact, target, triangle), id, false}, std::move(exact)};
}

bool ClosestHitGoal::look(RayTarget& target, const LineBlockTask& task) {
  for_each_candidate(target, task, task.through | task.open,
                     [&](TriangleId id, bool inside) { offer(target, id, inside); });
  return false;
}

void ClosestHitGoal::offer(RayTarget& target, TriangleId id, bool inside) {
  std::optional<Meeting> meeting = meet(target, id, inside);
  if (!meeting || (found_ && !is_nearer(target, *meeting))) {
    return;
  }
  const double known = found_ ? best_.hit.bounds.upper : std::numeric_limits<double>::infinity();
  meeting->hit.bounds.upper = std::min(meeting->hit.bounds.upper, known);
  best_ = std::move(*meeting);
  found_ = true;
  target.course.set_far(best_.hit.bounds.upper);
}

/// Nearer than the best one, or as near and of a lesser number.
bool ClosestHitGoal::is_nearer(RayTarget& target, Meeting& meeting) {
  const FoundHit& hit = meeting.hit;
  const FoundHit& best = best_.hit;
  if (hit.bounds.upper < best.bounds.lower || hit.bounds.lower > best.bounds.upper) {
    return hit.bounds.upper < best.bounds.lower;
  }
  for (Meeting* one : {&meeting, &best_}) {
    if (!one->exact) {
      ++target.cost.exact_tests;
      one->exact =
          std::make_unique<ExactRay>(target.line, moved_triangle(*target.body, one->hit.id));
    }
  }
  const auto order = compare(meeting.exact->time(), best_.exact->time());
  return order < 0 || (order == 0 && hit.id < best.id);
}

ClosestHit ClosestHitGoal::end(RayTarget& target, bool complete) {
  ClosestHit answer;
  answer.coverage = complete ? Coverage::complete : Coverage::cut;
  if (found_) {
    const TriangleId id = best_.hit.id;
    answer.triangle = id;
    answer.front = best_.hit.bounds.side > 0;
    const Triangle triangle = moved_triangle(*target.body, id);
    std::optional<PlaneHit> hit;
    if (!best_.exact) {
      hit = plane_hit(target.line, target.direction, triangle);
    }
    if (hit) {
      answer.t = hit->t;
      answer.point = hit->point;
    } else {
      if (!best_.exact) {
        ++target.cost.exact_tests;
        best_.exact = std::make_unique<ExactRay>(target.line, triangle);
      }
      answer.t = bracket(best_.exact->time());
      answer.point = best_.exact->point();
      answer.front = best_.exact->side() > 0;
    }
  }
  answer.cost = target.cost;
  return answer;
}

bool AnyHitGoal::look(RayTarget& target, const LineBlockTask& task) {
  for_each_candidate(target, task, task.sure, [&](TriangleId, bool) { hit_ = true; });
  if (!hit_) {
    for_each_candidate(
        target, task, (task.through & ~task.sure) | task.open,
        [&](TriangleId id, bool inside) { hit_ = hit_ || meet(target, id, inside).has_value(); });
  }
  return hit_;
}

AnyHit AnyHitGoal::end(RayTarget& target, bool complete) const {
  return {hit_, complete ? Coverage::complete : Coverage::cut, target.cost};
}

bool AllHitsGoal::look(RayTarget& target, const LineBlockTask& task) {
  for_each_candidate(target, task, task.through | task.open, [&](TriangleId id, bool inside) {
    if (const auto meeting = meet(target, id, inside)) {
      found_.push_back(meeting->hit);
    }
  });
  return false;
}

AllHitsGoal::Answer AllHitsGoal::end(RayTarget& target, bool complete) {
  Answer answer;
  form_crossings(*target.body, target.line, target.direction, found_, answer.row, target.cost);
  answer.coverage = complete ? Coverage::complete : Coverage::cut;
  answer.cost = target.cost;
  return answer;
}

}  // namespace soms::detail
