/// \file
/// A query of nearness of two bodies, and of a batch of poses, whatever its question is.
#pragma once

#include "soms/describe/columns.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/near/near_query.h"

#include <cstddef>
#include <span>

namespace soms::detail {

/// The answer about two bodies. `Question` has
///
///     Answer ask(a, b, frame, parallel, memory) const;   // neither mesh is empty
///     Answer of_empty() const;
///
/// \errors Those of a pose; ErrorKind::cancelled.
template <class Question>
[[nodiscard]] auto ask_near(const Question& question, const Body& a, const Body& b,
                            const Limits& limits) {
  check_pose(a.pose, a.shape);
  check_pose(b.pose, b.shape);
  check_stop(limits);
  if (is_empty(a.shape) || is_empty(b.shape)) {
    return question.of_empty();
  }
  PairFrame frame(a, b);
  NearMemory memory;
  return question.ask(a, b, frame, limits, memory);
}

/// Answers every pose into a column.
///
/// \errors As `ask_near`; a pose at fault is named by its index.
template <Described Answer, class Question>
[[nodiscard]] BatchOf<Answer> ask_near_batch(const Question& question, const Shape& mover,
                                             std::span<const Pose> poses, const Body& fixed,
                                             const Limits& limits) {
  BatchOf<Answer> batch;
  resize_columns<Answer>(batch, poses.size());
  check_pose(fixed.pose, fixed.shape);
  check_stop(limits);
  const bool empty = is_empty(mover) || is_empty(fixed.shape);
  const Limits alone = limits.alone();
  for_each_pose(
      poses, mover, limits, [&] { return NearBatch(mover, fixed); },
      [&](NearBatch& memory, const Pose& pose, std::size_t i) {
        const Answer answer = empty ? question.of_empty()
                                    : question.ask(Body(mover, pose), fixed, memory.place(pose),
                                                   alone, memory.memory());
        put_columns(answer, i, batch);
      });
  sum_costs<Answer>(batch);
  return batch;
}

}  // namespace soms::detail
