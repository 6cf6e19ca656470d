#include "soms/thesis/overlap.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/query/detail/check_options.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/thesis/named_overlap.h"
#include "soms/thesis/traversals.h"

#include <cstddef>
#include <utility>

namespace soms::thesis {

namespace {

std::vector<CountedOverlap> answers_of(const OverlapBatch& batch) {
  std::vector<CountedOverlap> answers;
  answers.reserve(batch.size());
  for (std::size_t k = 0; k < batch.size(); ++k) {
    answers.push_back({batch.at(k), {}});
  }
  return answers;
}

}  // namespace

CountedOverlap overlap(const Body& a, const Body& b, const TraversalOptions& traversal,
                       const OverlapOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_options(options);
  check(traversal);
  if (traversal.traversal == Traversal::fast) {
    return {soms::overlap(a, b, options, limits), {}};
  }
  NamedOverlap query(a.shape, b.shape, traversal);
  Overlap answer = query(a.pose, b.pose, options, limits);
  return {std::move(answer), query.counts()};
}

std::vector<CountedOverlap> overlap(const Shape& mover, std::span<const Pose> poses,
                                    const Body& fixed, const TraversalOptions& traversal,
                                    const OverlapOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_options(options);
  check(traversal);
  if (traversal.traversal == Traversal::fast) {
    return answers_of(soms::overlap(mover, poses, fixed, options, limits));
  }
  detail::check_poses(poses, mover);
  NamedOverlap query(mover, fixed.shape, traversal);
  std::vector<CountedOverlap> answers;
  answers.reserve(poses.size());
  for (const Pose& pose : poses) {
    Overlap answer = query(pose, fixed.pose, options, limits);
    answers.push_back({std::move(answer), query.counts()});
  }
  return answers;
}

TraversalMethod::TraversalMethod(const TraversalOptions& traversal) : traversal_(traversal) {
  check(traversal);
  if (traversal.traversal == Traversal::fast) {
    throw Error(ErrorKind::usage, "traversal fast is no method of its own",
                "leave StepOptions::method empty, or name another traversal");
  }
}

TraversalMethod::~TraversalMethod() = default;

OverlapBatch TraversalMethod::ask(const Shape& mover, std::span<const Pose* const> poses,
                                  const Body& fixed, const OverlapOptions& options,
                                  const Limits& limits) const {
  NamedOverlap query(mover, fixed.shape, traversal_);
  OverlapBatch batch;
  batch.offsets.push_back(0);
  for (const Pose* const pose : poses) {
    const Overlap answer = query(*pose, fixed.pose, options, limits);
    batch.any.push_back(answer.any ? 1 : 0);
    batch.coverage.push_back(answer.coverage);
    batch.pairs.insert(batch.pairs.end(), answer.pairs.begin(), answer.pairs.end());
    batch.offsets.push_back(batch.pairs.size());
    batch.costs.push_back(answer.cost);
    batch.cost += answer.cost;
  }
  return batch;
}

}  // namespace soms::thesis
