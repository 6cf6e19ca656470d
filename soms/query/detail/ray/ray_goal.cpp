#include "soms/query/detail/ray/ray_goal.h"

#include "soms/geometry/detail/exact/power_of_two.h"
#include "soms/query/detail/engine/fetch.h"
#include "soms/query/detail/moved_triangle.h"

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
  return {times_power_of_two(t.lower, exponent) * (1 - kRounding) - kLeast,
          times_power_of_two(t.upper, exponent) * (1 + kRounding) + kLeast, exact.side()};
}

/// Calls `of(lane, id)` for the triangles of a block that are still to be looked at.
template <class Of>
void for_each_candidate(const RayTarget& target, const LineBlockTask& task, std::uint32_t lanes,
                        const Of& of) {
  for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    const TriangleId id = task.block->id[lane];
    if (id != target.skip && !(task.near[lane] > target.course.numbers.far_open)) {
      of(lane, id);
    }
  }
}

bool is_in(std::uint32_t lanes, std::size_t lane) {
  return (lanes >> lane & 1U) != 0;
}

const ExactRay& exact_ray(RayTarget& target, Meeting& meeting) {
  if (!meeting.exact) {
    ++target.cost.exact_tests;
    meeting.exact =
        std::make_unique<ExactRay>(target.line, moved_triangle(*target.body, meeting.hit.id));
  }
  return *meeting.exact;
}

/// `a` is nearer, or as near and of a lesser number.
bool is_nearer(RayTarget& target, Meeting& a, Meeting& b) {
  if (a.hit.bounds.upper < b.hit.bounds.lower || a.hit.bounds.lower > b.hit.bounds.upper) {
    return a.hit.bounds.upper < b.hit.bounds.lower;
  }
  const auto order = compare(exact_ray(target, a).time(), exact_ray(target, b).time());
  return order < 0 || (order == 0 && a.hit.id < b.hit.id);
}

/// Its triangle is known, and nothing else.
bool is_unfinished(const ClosestHit& answer) {
  return answer.triangle && std::isinf(answer.t.lower);
}

/// What the answer says of the first triangle.
void describe(RayTarget& target, Meeting& first, ClosestHit& answer) {
  answer.triangle = first.hit.id;
  if (!first.exact) {
    const Triangle triangle = moved_triangle(*target.body, first.hit.id);
    if (const auto hit = plane_hit(target.line, target.direction, triangle)) {
      answer.t = hit->t;
      answer.point = hit->point;
      answer.front = hit->side > 0;
      return;
    }
  }
  const ExactRay& exact = exact_ray(target, first);
  answer.t = bracket(exact.time());
  answer.point = exact.point();
  answer.front = exact.side() > 0;
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
  for_each_candidate(target, task, task.through | task.open, [&](std::size_t lane, TriangleId id) {
    const bool inside = is_in(task.through, lane);
    if (is_in(task.sure, lane) || meet(target, id, inside)) {
      offer(target, {task.near[lane], task.far[lane], id, inside});
    }
  });
  return false;
}

void ClosestHitGoal::offer(RayTarget& target, const Candidate& candidate) {
  float& far = target.course.numbers.far_open;
  if (candidate.far < far) {
    far = candidate.far;
    std::erase_if(nearest_, [&](const Candidate& other) { return other.near > far; });
  }
  nearest_.push_back(candidate);
}

ClosestHit ClosestHitGoal::end(RayTarget& target, bool complete) {
  ClosestHit answer;
  answer.coverage = complete ? Coverage::complete : Coverage::cut;
  if (nearest_.size() == 1 && nearest_[0].inside) {
    answer.triangle = nearest_[0].id;
  } else if (!nearest_.empty()) {
    std::optional<Meeting> first;
    for (const Candidate& candidate : nearest_) {
      std::optional<Meeting> other = meet(target, candidate.id, candidate.inside);
      if (!first || is_nearer(target, *other, *first)) {
        first = std::move(other);
      }
    }
    describe(target, *first, answer);
  }
  answer.cost = target.cost;
  return answer;
}

void ClosestHitGoal::finish(RayTarget& target, ClosestHit& answer) {
  if (is_unfinished(answer)) {
    target.cost = answer.cost;
    Meeting first{{{}, *answer.triangle, true}, nullptr};
    describe(target, first, answer);
    answer.cost = target.cost;
  }
}

void ClosestHitGoal::finish_all(RayTarget& target, std::span<const RayLine> lines,
                                std::span<ClosestHit> answers) {
  constexpr std::size_t kAhead = 8;
  const MeshView& mesh = target.body->shape.mesh();
  const auto is_open = [&](std::size_t i) {
    return i < answers.size() && is_unfinished(answers[i]);
  };
  for (std::size_t i = 0; i < answers.size() + 2 * kAhead; ++i) {
    if (is_open(i)) {
      fetch(mesh.triangles[*answers[i].triangle]);
    }
    if (i >= kAhead && is_open(i - kAhead)) {
      for (const std::uint32_t corner : mesh.triangles[*answers[i - kAhead].triangle]) {
        fetch(mesh.vertices[corner]);
      }
    }
    if (i >= 2 * kAhead && is_open(i - 2 * kAhead)) {
      target.line = lines[i - 2 * kAhead];
      target.direction = ScaledDirection(target.line);
      finish(target, answers[i - 2 * kAhead]);
    }
  }
}

bool AnyHitGoal::look(RayTarget& target, const LineBlockTask& task) {
  for_each_candidate(target, task, task.sure, [&](std::size_t, TriangleId) { hit_ = true; });
  for_each_candidate(target, task, (task.through & ~task.sure) | task.open,
                     [&](std::size_t lane, TriangleId id) {
                       hit_ = hit_ || meet(target, id, is_in(task.through, lane)).has_value();
                     });
  return hit_;
}

AnyHit AnyHitGoal::end(RayTarget& target, bool complete) const {
  return {hit_, complete ? Coverage::complete : Coverage::cut, target.cost};
}

bool AllHitsGoal::look(RayTarget& target, const LineBlockTask& task) {
  for_each_candidate(target, task, task.through | task.open, [&](std::size_t lane, TriangleId id) {
    if (const auto meeting = meet(target, id, is_in(task.through, lane))) {
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
