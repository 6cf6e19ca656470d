#include "soms/motion/detail/contact_query.h"

#include "soms/base/double_limits.h"
#include "soms/geometry/triangle_distance.h"
#include "soms/motion/detail/contact_normal.h"
#include "soms/motion/detail/contact_traversal.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/overlap.h"
#include "soms/query/within.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

/// Triangles in contact at the end of the bracket are this many margins deep in each other at most,
/// or no normal is named.
constexpr double kDepth = 16;

/// One question and its answer.
class ContactQuery {
 public:
  ContactQuery(const MotionLaw& law, const Shape& mover, const Shape& other,
               const FirstContactOptions& options, const Limits& limits, const KnownOfWay& known)
      : law_(law),
        mover_(mover),
        other_(other),
        clearance_(options.within),
        parting_(options.parting),
        limits_(limits),
        known_(known),
        bounds_(law, other, options.within) {}

  [[nodiscard]] FirstContact ask() {
    const bool started = in_contact_at(0);
    if (started && !parting_) {
      answer_.verdict = ContactVerdict::started;
      answer_.t = {0, 0};
      name(0);
      return answer_;
    }
    ContactGoal goal;
    if (started) {
      goal.leave_out(pairs_at(0));
      answer_.triangles.reset();
    }
    if (answer_.coverage == Coverage::cut) {
      leave_open(0);
    } else {
      const double proved = traverse(goal);
      finish(goal, proved);
    }
    answer_.verdict = started ? ContactVerdict::started : answer_.verdict;
    return answer_;
  }

 private:
  /// Decides poses of the caller, at 0 and 1, as they are.
  [[nodiscard]] bool in_contact_at(double t) {
    if (known_.ends == EndsOfWay::free) {
      return false;
    }
    const Within found =
        within(Body(mover_, law_.mover_at(t)), Body(other_, law_.other_at(t)), clearance_, limits_);
    answer_.cost += found.cost;
    answer_.coverage = found.within ? Coverage::complete : found.coverage;
    if (found.within) {
      answer_.triangles = found.triangles;
    }
    return found.within;
  }

  /// All pairs in contact then, sorted.
  [[nodiscard]] std::vector<TrianglePair> pairs_at(double t) {
    Overlap found = overlap(Body(mover_, law_.mover_at(t)), Body(other_, law_.other_at(t)),
                            {.mode = OverlapMode::all}, limits_.alone());
    answer_.cost += found.cost;
    answer_.coverage = found.coverage;
    return std::move(found.pairs);
  }

  /// Decides the poses at the end as they are, but for pairs that are left out.
  [[nodiscard]] bool in_contact_at_end(const ContactGoal& goal) {
    if (!parting_) {
      return in_contact_at(1);
    }
    for (const TrianglePair& pair : pairs_at(1)) {
      if (!goal.leaves_out(pair)) {
        answer_.triangles = pair;
        return true;
      }
    }
    return false;
  }

  /// All before what it returns is free but for what the goal knows; infinity if all is.
  [[nodiscard]] double traverse(ContactGoal& goal) {
    return any_compact(mover_, other_) ? traverse_by<CompactSource>(goal)
                                       : traverse_by<WideSource>(goal);
  }

  template <class Source>
  [[nodiscard]] double traverse_by(ContactGoal& goal) {
    Limit limit(limits_);
    ContactTraversal<Source> traversal(bounds_, mover_, other_, known_.nodes, goal);
    const bool complete = traversal.run(limit);
    answer_.cost += traversal.cost();
    answer_.coverage = complete ? Coverage::complete : Coverage::cut;
    return complete ? kInfinity : traversal.free_until();
  }

  void finish(const ContactGoal& goal, double proved) {
    const double free_until = std::min(goal.free_until(), proved);
    if (goal.proved()) {
      answer_.verdict = ContactVerdict::contact;
      answer_.t = {std::min(free_until, goal.limit()), goal.limit()};
      answer_.triangles = goal.triangles();
      name(goal.limit());
    } else if (answer_.coverage == Coverage::cut) {
      answer_.triangles = goal.triangles();
      leave_open(free_until);
    } else if (!bounds_.exact() && in_contact_at_end(goal)) {
      answer_.verdict = ContactVerdict::contact;
      answer_.t = {std::min(free_until, std::nextafter(1.0, 0.0)), 1};
      name(1);
    } else if (answer_.coverage == Coverage::cut || goal.triangles()) {
      answer_.triangles = goal.triangles();
      leave_open(free_until);
    } else {
      answer_.t = {1, kInfinity};
    }
  }

  void leave_open(double free_until) {
    answer_.verdict = ContactVerdict::grazing;
    answer_.t = {std::min(free_until, 1.0), kInfinity};
    if (answer_.triangles) {
      name(answer_.t.lower);
    }
  }

  /// Says where the pair of triangles meets at `t`.
  void name(double t) {
    const Corners moving = corners_of(mover_.mesh().triangle(answer_.triangles->a));
    const Corners x = placed(moving, law_.mover_at(t));
    const Corners y =
        placed(corners_of(other_.mesh().triangle(answer_.triangles->b)), law_.other_at(t));
    answer_.point = triangle_distance(triangle_of(x), triangle_of(y)).point_b;
    if (clearance_ == 0 && answer_.verdict == ContactVerdict::contact) {
      const Corners before = placed(placed(moving, law_.at(answer_.t.lower)), law_.frame_at(t));
      answer_.normal = contact_normal(x, y, kDepth * bounds_.rounding(), before);
    }
  }

  const MotionLaw& law_;
  const Shape& mover_;
  const Shape& other_;
  double clearance_;
  bool parting_;
  const Limits& limits_;
  KnownOfWay known_;
  MotionBounds bounds_;
  FirstContact answer_;
};

}  // namespace

FirstContact first_contact_by(const MotionLaw& law, const Shape& mover, const Shape& other,
                              const FirstContactOptions& options, const Limits& limits,
                              const KnownOfWay& known) {
  return ContactQuery(law, mover, other, options, limits, known).ask();
}

}  // namespace soms::detail
