#include "soms/query/overlap.h"

#include "soms/base/error.h"
#include "soms/base/hash.h"
#include "soms/query/detail/pair_walk.h"
#include "soms/query/traversal/named_overlap.h"
#include "soms/tree/layout/wide_tree.h"

#include <algorithm>
#include <string>

namespace soms {

namespace {

using detail::Collector;
using detail::PairWalk;
using detail::PlacePair;
using detail::PlaceStack;
using detail::RelativePose;
using detail::Viewer;
using detail::WalkSide;
using detail::Watch;

/// Pairs of places that a query is cut into for several threads.
constexpr std::size_t kFrontier = 256;
/// Poses that a thread takes at a time.
constexpr std::size_t kBlock = 128;

/// The tree in whose axes a pair is seen is the larger one, and of the coarser unit.
bool first_is_viewer(const WideTree& a, const WideTree& b) {
  if (a.exponent() != b.exponent()) {
    return a.exponent() < b.exponent();
  }
  const auto size = [](const WideTree& tree) {
    const Vec3 extent = tree.bounds().extent();
    return std::max({extent.x, extent.y, extent.z});
  };
  return size(a) > size(b);
}

bool empty(const Shape& shape) {
  return shape.layout().nodes().empty();
}

Coverage coverage_of(OverlapMode mode, const Collector& collector, bool late) {
  if (collector.full() || late) {
    return mode == OverlapMode::any && collector.any() && !collector.full() ? Coverage::first
                                                                            : Coverage::cut;
  }
  return mode != OverlapMode::all && collector.any() ? Coverage::first : Coverage::complete;
}

/// One query on several threads: the frontier's pairs are shared out, and answers joined in its
/// order.
void run_parallel(const RelativePose& relative, const WalkSide& x, const WalkSide& y, bool swapped,
                  const OverlapOptions& options, const Parallel& parallel, Overlap& answer) {
  PlaceStack stack;
  PairWalk head(relative, x, y, swapped, stack);
  const std::vector<PlacePair> frontier = head.frontier(kFrontier);
  answer.cost = head.cost();

  struct Part {
    std::vector<TrianglePair> pairs;
    Cost cost;
    bool late = false;
  };

  std::vector<Part> parts(frontier.size());
  std::atomic<bool> done = false;
  for_each_chunk(frontier.size(), 1, parallel, [&](std::size_t begin, std::size_t) {
    Part& part = parts[begin];
    PlaceStack own;
    Watch watch(options, parallel, &done);
    PairWalk walk(relative, x, y, swapped, own);
    Collector collector(options.mode, options.limit, part.pairs);
    if (!done) {
      walk.run(frontier[begin], collector, watch);
    }
    collector.finish();
    part.cost = walk.cost();
    part.late = watch.late();
    if (options.mode == OverlapMode::any && collector.any()) {
      done = true;
    }
  });
  Collector collector(options.mode, options.limit, answer.pairs);
  bool late = false;
  for (const Part& part : parts) {
    answer.cost += part.cost;
    late = late || part.late;
    for (const TrianglePair& pair : part.pairs) {
      if (collector.add(pair)) {
        break;
      }
    }
    if (options.mode == OverlapMode::any && collector.any()) {
      break;
    }
  }
  collector.finish();
  answer.any = collector.any();
  answer.coverage = coverage_of(options.mode, collector, late);
}

/// One query on the caller's thread; pairs are appended to `pairs`.
struct Verdict {
  bool any = false;
  Coverage coverage = Coverage::complete;
  Cost cost;
};

Verdict run_single(const RelativePose& relative, const WalkSide& x, const WalkSide& y, bool swapped,
                   const OverlapOptions& options, const Parallel& parallel, PlaceStack& stack,
                   std::vector<TrianglePair>& pairs) {
  Watch watch(options, parallel);
  Collector collector(options.mode, options.limit, pairs);
  PairWalk walk(relative, x, y, swapped, stack);
  walk.run(collector, watch);
  collector.finish();
  return {collector.any(), coverage_of(options.mode, collector, watch.late()), walk.cost()};
}

void check_pose(const Pose& pose, const Shape& shape) {
  check(pose);
  check_range(pose, shape.bounds());
}

/// Checks all poses of a batch; an error names the first one at fault.
void check_poses(std::span<const Pose> poses, const Shape& shape) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    try {
      check_pose(poses[i], shape);
    } catch (const Error& error) {
      throw Error(error.kind(), "pose " + std::to_string(i) + ": " + error.place(), error.remedy());
    }
  }
}

/// What a block of poses found.
struct Block {
  std::vector<TrianglePair> pairs;
  std::vector<std::uint64_t> counts;
  Cost cost;
};

void run_block(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
               const OverlapOptions& options, const Parallel& parallel, Block& block,
               std::span<std::uint8_t> any, std::span<Coverage> coverage) {
  PlaceStack stack;
  block.counts.reserve(poses.size());
  block.pairs.reserve(poses.size());
  const bool mover_views = first_is_viewer(mover.layout(), fixed.shape.layout());
  const Viewer fixed_viewer(fixed.shape.layout(), fixed.pose);
  const WalkSide fixed_side{&fixed.shape, &fixed.pose};
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const WalkSide mover_side{&mover, &poses[k]};
    const std::size_t before = block.pairs.size();
    Verdict verdict;
    if (mover_views) {
      const RelativePose relative(fixed.shape.layout(), fixed.pose,
                                  Viewer(mover.layout(), poses[k]));
      verdict =
          run_single(relative, fixed_side, mover_side, true, options, parallel, stack, block.pairs);
    } else {
      const RelativePose relative(mover.layout(), poses[k], fixed_viewer);
      verdict = run_single(relative, mover_side, fixed_side, false, options, parallel, stack,
                           block.pairs);
    }
    any[k] = verdict.any ? 1 : 0;
    coverage[k] = verdict.coverage;
    block.counts.push_back(block.pairs.size() - before);
    block.cost += verdict.cost;
  }
}

OverlapBatch named_batch(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                         const OverlapOptions& options, const Parallel& parallel) {
  OverlapBatch batch;
  detail::NamedOverlap ask(mover, fixed.shape, options.traversal);
  batch.offsets.push_back(0);
  for (const Pose& pose : poses) {
    const Overlap answer = ask(pose, fixed.pose, options, parallel);
    batch.any.push_back(answer.any ? 1 : 0);
    batch.coverage.push_back(answer.coverage);
    batch.pairs.insert(batch.pairs.end(), answer.pairs.begin(), answer.pairs.end());
    batch.offsets.push_back(batch.pairs.size());
    batch.cost += answer.cost;
  }
  return batch;
}

}  // namespace

std::uint64_t Overlap::hash() const {
  Fnv1a hash;
  for (const auto& [i, j] : pairs) {
    hash.add(i);
    hash.add(j);
  }
  return hash.value();
}

Overlap overlap(const Body& a, const Body& b, const OverlapOptions& options,
                const Parallel& parallel) {
  if (options.traversal.traversal != Traversal::fast) {
    return detail::named_overlap(a, b, options, parallel);
  }
  check_pose(a.pose, a.shape);
  check_pose(b.pose, b.shape);
  check_stop(parallel);
  Overlap answer;
  if (empty(a.shape) || empty(b.shape)) {
    return answer;
  }
  const bool swapped = first_is_viewer(a.shape.layout(), b.shape.layout());
  const Body& x = swapped ? b : a;
  const Body& y = swapped ? a : b;
  const RelativePose relative(x.shape.layout(), x.pose, Viewer(y.shape.layout(), y.pose));
  const WalkSide side_x{&x.shape, &x.pose};
  const WalkSide side_y{&y.shape, &y.pose};
  // The first pairs in the order of one thread are best found by one thread.
  const bool limited = options.limit != std::numeric_limits<std::uint64_t>::max();
  if (parallel.threads != 1 && !limited) {
    run_parallel(relative, side_x, side_y, swapped, options, parallel, answer);
    return answer;
  }
  PlaceStack stack;
  const Verdict verdict =
      run_single(relative, side_x, side_y, swapped, options, parallel, stack, answer.pairs);
  answer.any = verdict.any;
  answer.coverage = verdict.coverage;
  answer.cost = verdict.cost;
  return answer;
}

OverlapBatch overlap(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                     const OverlapOptions& options, const Parallel& parallel) {
  check_poses(poses, mover);
  check_pose(fixed.pose, fixed.shape);
  if (options.traversal.traversal != Traversal::fast) {
    return named_batch(mover, poses, fixed, options, parallel);
  }
  OverlapBatch batch;
  batch.any.assign(poses.size(), 0);
  batch.coverage.assign(poses.size(), Coverage::complete);
  batch.offsets.assign(poses.size() + 1, 0);
  if (empty(mover) || empty(fixed.shape)) {
    return batch;
  }
  std::vector<Block> blocks(poses.size() / kBlock + 1);
  for_each_chunk(poses.size(), kBlock, parallel, [&](std::size_t begin, std::size_t end) {
    run_block(mover, poses.subspan(begin, end - begin), fixed, options, parallel,
              blocks[begin / kBlock], std::span(batch.any).subspan(begin, end - begin),
              std::span(batch.coverage).subspan(begin, end - begin));
  });
  std::size_t pose = 0;
  for (const Block& block : blocks) {
    batch.cost += block.cost;
    batch.pairs.insert(batch.pairs.end(), block.pairs.begin(), block.pairs.end());
    for (const std::uint64_t count : block.counts) {
      batch.offsets[pose + 1] = batch.offsets[pose] + count;
      ++pose;
    }
  }
  return batch;
}

}  // namespace soms
