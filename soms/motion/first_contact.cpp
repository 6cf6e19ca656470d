#include "soms/motion/first_contact.h"

#include "soms/base/arithmetic.h"
#include "soms/base/double_limits.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/describe/columns.h"
#include "soms/motion/detail/contact_query.h"
#include "soms/motion/detail/relative_law.h"
#include "soms/motion/detail/rigid_law.h"
#include "soms/query/detail/near/near_query.h"

#include <string>

namespace soms {

namespace {

using detail::kInfinity;
using detail::RelativeLaw;
using detail::RigidLaw;

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
void check_motions(const Shape& mover, std::span<const RigidMotion> motions, const Body& fixed) {
  const bool empty = one_is_empty(mover, fixed);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    try {
      check_motion(mover, motions[i]);
      if (!empty) {
        static_cast<void>(RigidLaw(mover, motions[i], fixed));
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
  return detail::first_contact_by(RigidLaw(mover, motion, fixed), mover, fixed.shape, options,
                                  limits);
}

void check_options(const FirstContactOptions& options) {
  detail::check_length(options.within, "first contact options: within");
  if (options.parting && options.within > 0) {
    throw Error(ErrorKind::usage, "first contact options: parting with a clearance",
                "leave one of them out");
  }
}

}  // namespace

FirstContact first_contact(const Shape& mover, const RigidMotion& motion, const Body& fixed,
                           const FirstContactOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  check_options(options);
  check_motion(mover, motion);
  detail::check_pose(fixed.pose, fixed.shape);
  check_stop(limits);
  return answer_of(mover, motion, fixed, options, limits);
}

FirstContact first_contact(const Shape& mover, const RigidMotion& motion, const Shape& other,
                           const RigidMotion& motion_of_other, const FirstContactOptions& options,
                           const Limits& limits) {
  const PlainArithmetic plain;
  check_options(options);
  check_motion(mover, motion);
  check_motion(other, motion_of_other);
  check_stop(limits);
  if (detail::is_empty(mover) || detail::is_empty(other)) {
    return {.t = {1, kInfinity}};
  }
  return detail::first_contact_by(RelativeLaw(mover, motion, other, motion_of_other), mover, other,
                                  options, limits);
}

FirstContact FirstContactBatch::at(std::size_t motion) const {
  return row_of<FirstContact>(*this, motion);
}

std::optional<std::size_t> FirstContactBatch::first_blocked() const {
  const auto found = std::find_if(verdict.begin(), verdict.end(), [](ContactVerdict proved) {
    return proved != ContactVerdict::free;
  });
  return found == verdict.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - verdict.begin()));
}

FirstContactBatch first_contact(const Shape& mover, std::span<const RigidMotion> motions,
                                const Body& fixed, const FirstContactOptions& options,
                                const Limits& limits) {
  const PlainArithmetic plain;
  check_options(options);
  detail::check_pose(fixed.pose, fixed.shape);
  check_motions(mover, motions, fixed);
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
