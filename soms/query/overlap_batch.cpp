#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/overlap_query.h"
#include "soms/query/detail/pair_walk.h"
#include "soms/query/detail/scouts.h"
#include "soms/query/overlap.h"
#include "soms/query/traversal/named_overlap.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>

namespace soms {

namespace {

using detail::Collector;
using detail::PairWalk;
using detail::RelativePose;
using detail::Viewer;
using detail::WalkMemory;
using detail::WalkRound;
using detail::WalkSide;
using detail::Watch;

/// Poses that a thread takes at a time.
constexpr std::size_t kBlock = 256;
/// Where both trees are larger than what a core has close at hand, queries wait for memory.
constexpr std::size_t kClose = std::size_t{2} << 20;

/// Queries in flight: while one waits for memory, others work. Where none has to wait, they would
/// only be in each other's way.
std::size_t flights_of(const Shape& a, const Shape& b) {
  return std::min(a.layout().memory(), b.layout().memory()) > kClose ? detail::WalkRound::kWalks
                                                                     : 1;
}

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

/// What is asked of every pose.
struct Question {
  const Shape& mover;
  std::span<const Pose> poses;
  const Body& fixed;
  const OverlapOptions& options;
  const Parallel& parallel;
};

/// What the poses of one block gave: pairs in the order in which queries ended.
struct Block {
  std::vector<TrianglePair> pairs;
  std::vector<std::array<std::uint64_t, 2>> runs;  // begin and end of each pose's pairs
};

/// A query in flight.
struct Flight {
  std::optional<RelativePose> relative;
  std::optional<PairWalk> walk;
  std::optional<Collector> collector;
  std::optional<Watch> watch;
  WalkMemory memory;
  std::vector<TrianglePair> pairs;
  std::size_t pose = 0;
  bool over = false;
};

/// Asks about a block of poses, several queries in flight. Each takes the steps that it would take
/// alone, so answers and costs do not depend on its neighbors.
class BlockRun {
 public:
  BlockRun(const Question& question, OverlapBatch& batch, Block& block, std::size_t begin,
           std::size_t end)
      : question_(question),
        mover_views_(
            detail::first_is_viewer(question.mover.layout(), question.fixed.shape.layout())),
        fixed_viewer_(question.fixed.shape.layout(), question.fixed.pose),
        batch_(batch),
        block_(block),
        begin_(begin),
        next_(begin),
        end_(end) {
    block_.runs.resize(end - begin);
    block_.pairs.reserve(end - begin);
  }

  void run() {
    const std::size_t most = flights_of(question_.mover, question_.fixed.shape);
    const auto flights = std::make_unique_for_overwrite<Flight[]>(most);
    std::array<Flight*, WalkRound::kWalks> open = {};
    std::size_t count = 0;
    while (count < most && take_off(flights[count])) {
      open[count] = &flights[count];
      ++count;
    }
    const detail::Kernels& kernels = detail::kernels();
    WalkRound round;
    while (count > 0) {
      round.clear();
      for (std::size_t i = 0; i < count;) {
        Flight& flight = *open[i];
        if (!flight.over && flight.walk->gather(round)) {
          ++i;
          continue;
        }
        land(flight);
        if (!take_off(flight)) {
          open[i] = open[--count];
        }
      }
      PairWalk::test(kernels, round);
      for (std::size_t i = 0; i < count; ++i) {
        Flight& flight = *open[i];
        flight.over = !flight.walk->take_up(round, *flight.collector, *flight.watch);
      }
    }
  }

 private:
  /// Brings the next group of queries to where their walks begin; false if there is none left.
  bool send_scouts() {
    scouts_->clear();
    scouted_ = 0;
    for (; next_ < end_ && !scouts_->full(); ++next_) {
      const Pose& pose = question_.poses[next_];
      const Body& fixed = question_.fixed;
      if (mover_views_) {
        scouts_->add(fixed.shape.layout(), fixed.pose, Viewer(question_.mover.layout(), pose));
      } else {
        scouts_->add(question_.mover.layout(), pose, fixed_viewer_);
      }
    }
    scouts_->look(mover_views_ ? question_.mover.layout() : question_.fixed.shape.layout());
    return scouts_->size() != 0;
  }

  /// Begins the next walk; false if there is none left. Most queries of small bodies need none.
  bool take_off(Flight& flight) {
    while (scouted_ < scouts_->size() || send_scouts()) {
      const std::size_t pose = next_ - scouts_->size() + scouted_;
      detail::Scout& scout = (*scouts_)[scouted_++];
      if (!scout.seeds.empty()) {
        take_off(flight, scout, pose);
        return true;
      }
      flight.pairs.clear();
      const Collector nothing(question_.options.mode, question_.options.limit, flight.pairs);
      const Watch watch(question_.options, question_.parallel);
      batch_.coverage[pose] = coverage_of(question_.options.mode, nothing, watch.late());
      batch_.costs[pose] = scout.cost;
    }
    return false;
  }

  void take_off(Flight& flight, detail::Scout& scout, std::size_t pose) {
    flight.pose = pose;
    const Body& fixed = question_.fixed;
    const WalkSide mover_side{&question_.mover, &question_.poses[pose]};
    const WalkSide fixed_side{&fixed.shape, &fixed.pose};
    flight.relative = scout.relative;
    flight.pairs.clear();
    flight.collector.emplace(question_.options.mode, question_.options.limit, flight.pairs);
    flight.watch.emplace(question_.options, question_.parallel);
    flight.walk.emplace(*flight.relative, mover_views_ ? fixed_side : mover_side,
                        mover_views_ ? mover_side : fixed_side, mover_views_,
                        question_.options.mode, flight.memory);
    flight.walk->start(scout.seeds, scout.cost);
    flight.over = false;
  }

  void land(Flight& flight) {
    flight.collector->finish();
    batch_.any[flight.pose] = flight.collector->any() ? 1 : 0;
    batch_.coverage[flight.pose] =
        coverage_of(question_.options.mode, *flight.collector, flight.watch->late());
    const std::uint64_t first = block_.pairs.size();
    block_.pairs.insert(block_.pairs.end(), flight.pairs.begin(), flight.pairs.end());
    block_.runs[flight.pose - begin_] = {first, block_.pairs.size()};
    batch_.costs[flight.pose] = flight.walk->cost();
  }

  const Question& question_;
  bool mover_views_;
  Viewer fixed_viewer_;
  OverlapBatch& batch_;
  Block& block_;
  std::size_t begin_;
  std::size_t next_;
  std::size_t end_;
  std::unique_ptr<detail::Scouts> scouts_ = std::make_unique_for_overwrite<detail::Scouts>();
  std::size_t scouted_ = 0;
};

/// Puts the blocks' pairs into the batch, in the order of poses.
void join(const std::vector<Block>& blocks, OverlapBatch& batch) {
  std::size_t total = 0;
  for (const Block& block : blocks) {
    total += block.pairs.size();
  }
  batch.pairs.reserve(total);
  for (const Cost& cost : batch.costs) {
    batch.cost += cost;
  }
  std::size_t pose = 0;
  for (const Block& block : blocks) {
    for (const auto& [begin, end] : block.runs) {
      batch.pairs.insert(batch.pairs.end(),
                         block.pairs.begin() + static_cast<std::ptrdiff_t>(begin),
                         block.pairs.begin() + static_cast<std::ptrdiff_t>(end));
      batch.offsets[++pose] = batch.pairs.size();
    }
  }
}

/// Adds a pose's answer; poses come in order.
void add(const Overlap& answer, OverlapBatch& batch) {
  batch.any.push_back(answer.any ? 1 : 0);
  batch.coverage.push_back(answer.coverage);
  batch.pairs.insert(batch.pairs.end(), answer.pairs.begin(), answer.pairs.end());
  batch.offsets.push_back(batch.pairs.size());
  batch.costs.push_back(answer.cost);
  batch.cost += answer.cost;
}

/// Poses one by one: what compact layouts write out is of no use to other queries.
OverlapBatch compact_batch(const Question& question) {
  std::vector<Overlap> answers(question.poses.size());
  for_each_chunk(answers.size(), kBlock, question.parallel,
                 [&](std::size_t begin, std::size_t end) {
                   const Parallel alone{1, question.parallel.stop, {}};
                   for (std::size_t i = begin; i < end; ++i) {
                     answers[i] = overlap(Body{question.mover, question.poses[i]}, question.fixed,
                                          question.options, alone);
                   }
                 });
  OverlapBatch batch;
  batch.offsets.push_back(0);
  for (const Overlap& answer : answers) {
    add(answer, batch);
  }
  return batch;
}

OverlapBatch named_batch(const Question& question) {
  OverlapBatch batch;
  detail::NamedOverlap ask(question.mover, question.fixed.shape, question.options.traversal);
  batch.offsets.push_back(0);
  for (const Pose& pose : question.poses) {
    add(ask(pose, question.fixed.pose, question.options, question.parallel), batch);
  }
  return batch;
}

}  // namespace

OverlapBatch overlap(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                     const OverlapOptions& options, const Parallel& parallel) {
  const PlainArithmetic plain;
  check_poses(poses, mover);
  detail::check_pose(fixed.pose, fixed.shape);
  const Question question{mover, poses, fixed, options, parallel};
  if (options.traversal.traversal != Traversal::fast) {
    return named_batch(question);
  }
  if (detail::any_compact(mover, fixed.shape)) {
    return compact_batch(question);
  }
  OverlapBatch batch;
  batch.any.assign(poses.size(), 0);
  batch.coverage.assign(poses.size(), Coverage::complete);
  batch.costs.assign(poses.size(), {});
  batch.offsets.assign(poses.size() + 1, 0);
  if (poses.empty() || detail::is_empty(mover) || detail::is_empty(fixed.shape)) {
    return batch;
  }
  std::vector<Block> blocks((poses.size() - 1) / kBlock + 1);
  for_each_chunk(poses.size(), kBlock, parallel, [&](std::size_t begin, std::size_t end) {
    BlockRun(question, batch, blocks[begin / kBlock], begin, end).run();
  });
  join(blocks, batch);
  return batch;
}

}  // namespace soms
