/// \file
/// A query of nearness of two bodies, and of a batch of poses, whatever its question is.
#pragma once

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
                            const Parallel& parallel) {
  check_pose(a.pose, a.shape);
  check_pose(b.pose, b.shape);
  check_stop(parallel);
  if (is_empty(a.shape) || is_empty(b.shape)) {
    return question.of_empty();
  }
  PairFrame frame(a, b);
  NearMemory memory;
  return question.ask(a, b, frame, parallel, memory);
}

template <class... Columns>
void resize_columns(std::size_t size, Columns&... columns) {
  (columns.resize(size), ...);
}

/// Answers every pose into the columns that all batches of nearness have: a pair that is named,
/// coverage and costs. Those of its own a question fills by
///
///     void resize(Batch& batch, std::size_t size) const;
///     void put(const Answer& answer, std::size_t pose, Batch& batch) const;
///
/// \errors As `ask_near`; a pose at fault is named by its index.
template <class Batch, class Question>
[[nodiscard]] Batch ask_near_batch(const Question& question, const Shape& mover,
                                   std::span<const Pose> poses, const Body& fixed,
                                   const Parallel& parallel) {
  Batch batch;
  resize_columns(poses.size(), batch.triangles, batch.point_a, batch.point_b, batch.coverage,
                 batch.costs);
  question.resize(batch, poses.size());
  check_pose(fixed.pose, fixed.shape);
  check_stop(parallel);
  const bool empty = is_empty(mover) || is_empty(fixed.shape);
  const Parallel alone = {.stop = parallel.stop};
  for_each_pose(
      poses, mover, parallel, [&] { return NearBatch(mover, fixed); },
      [&](NearBatch& memory, const Pose& pose, std::size_t i) {
        const auto answer = empty ? question.of_empty()
                                  : question.ask(Body(mover, pose), fixed, memory.place(pose),
                                                 alone, memory.memory());
        batch.triangles[i] = answer.triangles;
        batch.point_a[i] = answer.point_a;
        batch.point_b[i] = answer.point_b;
        batch.coverage[i] = answer.coverage;
        batch.costs[i] = answer.cost;
        question.put(answer, i, batch);
      });
  batch.cost = sum_of(batch.costs);
  return batch;
}

}  // namespace soms::detail
