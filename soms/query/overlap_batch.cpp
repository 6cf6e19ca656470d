#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/query/detail/overlap_query.h"
#include "soms/query/overlap.h"
#include "soms/query/overlap_run.h"

#include <algorithm>
#include <string>

namespace soms {

namespace {

/// Poses that a thread takes at a time.
constexpr std::size_t kBlock = 256;

/// Checks all poses of a batch; an error names the first one at fault.
void check_poses(std::span<const Pose> poses, const Shape& shape) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    try {
      detail::check_pose(poses[i], shape);
    } catch (const Error& error) {
      throw Error(error.kind(), "pose " + std::to_string(i) + ": " + error.place(), error.remedy());
    }
  }
}

/// Puts the blocks' answers into the batch, in the order of poses.
void join(std::span<const RunAnswers> blocks, OverlapBatch& batch) {
  std::size_t total = 0;
  for (const RunAnswers& block : blocks) {
    total += block.pairs.size();
  }
  batch.pairs.reserve(total);
  for (const RunAnswers& block : blocks) {
    for (std::size_t i = 0; i < block.poses.size(); ++i) {
      const RunAnswers::Answer& answer = block.poses[i];
      const auto pairs = block.pairs_of(i);
      batch.any.push_back(answer.any ? 1 : 0);
      batch.coverage.push_back(answer.coverage);
      batch.pairs.insert(batch.pairs.end(), pairs.begin(), pairs.end());
      batch.offsets.push_back(batch.pairs.size());
      batch.costs.push_back(answer.cost);
      batch.cost += answer.cost;
    }
    batch.traversals.insert(batch.traversals.end(), block.traversals.begin(),
                            block.traversals.end());
  }
}

}  // namespace

OverlapBatch overlap(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                     const OverlapOptions& options, const Parallel& parallel) {
  const PlainArithmetic plain;
  check(options);
  check_poses(poses, mover);
  detail::check_pose(fixed.pose, fixed.shape);
  // A named traversal may go on from where its last pose ended.
  const bool named = options.traversal.traversal != Traversal::fast;
  const std::size_t size = named ? std::max<std::size_t>(poses.size(), 1) : kBlock;
  std::vector<RunAnswers> blocks(std::max<std::size_t>((poses.size() + size - 1) / size, 1));
  const auto ask = [&](std::size_t begin, std::size_t end) {
    std::vector<const Pose*> block;
    for (const Pose& pose : poses.subspan(begin, end - begin)) {
      block.push_back(&pose);
    }
    OverlapRun().ask(mover, block, fixed, options, parallel, blocks[begin / size]);
  };
  if (named) {
    ask(0, poses.size());
  } else {
    for_each_chunk(poses.size(), size, parallel, ask);
  }
  OverlapBatch batch;
  batch.offsets.push_back(0);
  join(blocks, batch);
  return batch;
}

}  // namespace soms
