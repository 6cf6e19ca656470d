#include "soms/base/arithmetic.h"
#include "soms/query/detail/check_options.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/overlap_run.h"
#include "soms/query/overlap.h"

#include <utility>

namespace soms {

namespace {

std::vector<const Pose*> addresses(std::span<const Pose> poses) {
  std::vector<const Pose*> result;
  result.reserve(poses.size());
  for (const Pose& pose : poses) {
    result.push_back(&pose);
  }
  return result;
}

/// Puts the blocks' answers one after the other.
OverlapBatch join(std::span<OverlapBatch> blocks) {
  if (blocks.size() == 1) {
    return std::move(blocks[0]);
  }
  std::size_t poses = 0;
  std::size_t pairs = 0;
  for (const OverlapBatch& block : blocks) {
    poses += block.size();
    pairs += block.pairs.size();
  }
  OverlapBatch batch;
  batch.any.reserve(poses);
  batch.coverage.reserve(poses);
  batch.offsets.reserve(poses + 1);
  batch.pairs.reserve(pairs);
  batch.costs.reserve(poses);
  batch.offsets.push_back(0);
  for (const OverlapBatch& block : blocks) {
    detail::append(batch.any, block.any);
    detail::append(batch.coverage, block.coverage);
    detail::append_rows(batch.offsets, batch.pairs, block.offsets, block.pairs);
    detail::append(batch.costs, block.costs);
    batch.cost += block.cost;
  }
  return batch;
}

}  // namespace

Overlap OverlapBatch::at(std::size_t pose) const {
  const std::span<const TrianglePair> own = pairs_of(pose);
  return {any[pose] != 0, {own.begin(), own.end()}, coverage[pose], costs[pose]};
}

OverlapBatch overlap(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                     const OverlapOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_options(options);
  detail::check_poses(poses, mover);
  detail::check_pose(fixed.pose, fixed.shape);
  std::vector<OverlapBatch> blocks((poses.size() + detail::kPosesOfBlock - 1) /
                                   detail::kPosesOfBlock);
  detail::for_each_block(
      poses.size(), limits, [] { return detail::OverlapRun(); },
      [&](detail::OverlapRun& run, std::size_t begin, std::size_t end) {
        run.ask(mover, addresses(poses.subspan(begin, end - begin)), fixed, options, limits,
                blocks[begin / detail::kPosesOfBlock]);
      });
  return join(blocks);
}

}  // namespace soms
