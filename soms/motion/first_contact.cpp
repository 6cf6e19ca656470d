#include "soms/motion/first_contact.h"

#include "soms/base/arithmetic.h"
#include "soms/base/double_limits.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/describe/columns.h"
#include "soms/geometry/triangle_distance.h"
#include "soms/motion/detail/contact_normal.h"
#include "soms/motion/detail/contact_traversal.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/query/detail/near/near_query.h"
#include "soms/query/within.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace soms {

namespace {

using detail::ContactGoal;
using detail::ContactTraversal;
using detail::kInfinity;
using detail::MotionBounds;

/// Triangles in contact at the end of the bracket are this many margins deep in each other at most,
/// or no normal is named.
constexpr double kDepth = 16;

/// One question and its answer.
class ContactQuery {
 public:
  ContactQuery(const Shape& mover, const RigidMotion& motion, const Body& fixed,
               const FirstContactOptions& options, const Limits& limits)
      : mover_(mover),
        motion_(motion),
        fixed_(fixed),
        clearance_(options.within),
        limits_(limits),
        bounds_(mover, motion, fixed, options.within) {}

  [[nodiscard]] FirstContact ask() {
    if (in_contact_at(motion_.start())) {
      answer_.verdict = ContactVerdict::started;
      answer_.t = {0, 0};
      name(0);
      return answer_;
    }
    if (answer_.coverage == Coverage::cut) {
      leave_open(0);
      return answer_;
    }
    ContactGoal goal;
    const double proved = traverse(goal);
    finish(goal, proved);
    return answer_;
  }

 private:
  /// Decides a pose of the caller as it is.
  [[nodiscard]] bool in_contact_at(const Pose& pose) {
    const Within found = within(Body(mover_, pose), fixed_, clearance_, limits_);
    answer_.cost += found.cost;
    answer_.coverage = found.within ? Coverage::complete : found.coverage;
    if (found.within) {
      answer_.triangles = found.triangles;
    }
    return found.within;
  }

  /// All before what it returns is free but for what the goal knows; infinity if all is.
  [[nodiscard]] double traverse(ContactGoal& goal) {
    return detail::any_compact(mover_, fixed_.shape) ? traverse_by<detail::CompactSource>(goal)
                                                     : traverse_by<detail::WideSource>(goal);
  }

  template <class Source>
  [[nodiscard]] double traverse_by(ContactGoal& goal) {
    detail::Limit limit(limits_);
    ContactTraversal<Source> traversal(bounds_, mover_, fixed_, goal);
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
    } else if (!bounds_.exact() && in_contact_at(motion_.end())) {
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
    const Triangle body = mover_.mesh().triangle(answer_.triangles->a);
    const Triangle resting = detail::moved_triangle(fixed_, answer_.triangles->b);
    const Triangle moved = placed(body, motion_.pose_at(t));
    answer_.point = triangle_distance(moved, resting).point_b;
    if (clearance_ == 0 && answer_.verdict == ContactVerdict::contact) {
      const Triangle before = placed(body, motion_.law_at(answer_.t.lower));
      answer_.normal =
          detail::contact_normal(detail::corners_of(moved), detail::corners_of(resting),
                                 kDepth * bounds_.rounding(), detail::corners_of(before));
    }
  }

  [[nodiscard]] static Triangle placed(const Triangle& t, const Pose& pose) {
    return {pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
  }

  const Shape& mover_;
  const RigidMotion& motion_;
  const Body& fixed_;
  double clearance_;
  const Limits& limits_;
  MotionBounds bounds_;
  FirstContact answer_;
};

/// Motions that a thread takes at a time.
constexpr std::size_t kMotionsOfChunk = 8;

bool one_is_empty(const Shape& mover, const Body& fixed) {
  return detail::is_empty(mover) || detail::is_empty(fixed.shape);
}

/// \errors Those of a motion.
void check_motion(const Shape& mover, const RigidMotion& motion) {
  detail::check_pose(motion.start(), mover);
  detail::check_pose(motion.end(), mover);
}

/// The same for many, with the number of the first one at fault, and where it may lead too far.
void check_motions(const Shape& mover, std::span<const RigidMotion> motions, const Body& fixed,
                   double clearance) {
  const bool empty = one_is_empty(mover, fixed);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    try {
      check_motion(mover, motions[i]);
      if (!empty) {
        static_cast<void>(MotionBounds(mover, motions[i], fixed, clearance));
      }
    } catch (const Error& error) {
      throw Error(error.kind(), "motion " + std::to_string(i) + ": " + error.place(),
                  error.remedy());
    }
  }
}

FirstContact answer_of(const Shape& mover, const RigidMotion& motion, const Body& fixed,
                       const FirstContactOptions& options, const Limits& limits) {
  if (one_is_empty(mover, fixed)) {
    return {.t = {1, kInfinity}};
  }
  return ContactQuery(mover, motion, fixed, options, limits).ask();
}

void check_within(const FirstContactOptions& options) {
  detail::check_length(options.within, "first contact options: within");
}

}  // namespace

FirstContact first_contact(const Shape& mover, const RigidMotion& motion, const Body& fixed,
                           const FirstContactOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  check_within(options);
  check_motion(mover, motion);
  detail::check_pose(fixed.pose, fixed.shape);
  check_stop(limits);
  return answer_of(mover, motion, fixed, options, limits);
}

FirstContact FirstContactBatch::at(std::size_t motion) const {
  return row_of<FirstContact>(*this, motion);
}

FirstContactBatch first_contact(const Shape& mover, std::span<const RigidMotion> motions,
                                const Body& fixed, const FirstContactOptions& options,
                                const Limits& limits) {
  const PlainArithmetic plain;
  check_within(options);
  detail::check_pose(fixed.pose, fixed.shape);
  check_motions(mover, motions, fixed, options.within);
  check_stop(limits);
  FirstContactBatch batch;
  resize_columns<FirstContact>(batch, motions.size());
  const Limits alone = limits.alone();
  for_each_chunk(motions.size(), kMotionsOfChunk, limits.without_deadline(),
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     put_columns(answer_of(mover, motions[i], fixed, options, alone), i, batch);
                   }
                 });
  sum_costs<FirstContact>(batch);
  return batch;
}

}  // namespace soms
