#include "soms/thesis/fast_steps.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/overlap_traversal.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <utility>

namespace soms::thesis {

namespace {

using soms::detail::BlockTask;
using soms::detail::index_of;
using soms::detail::NodeTask;
using soms::detail::PairFrame;
using soms::detail::TraversalRound;

constexpr std::uint32_t kWidth = WideNode::kWidth;

/// Pairs of lanes by the order of NodeTask::pairs.
template <class Take>
void for_each_pair(std::uint32_t pairs, const Take& take) {
  for (std::uint32_t left = pairs; left != 0; left &= left - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(left));
    const std::uint32_t x = bit % kWidth;
    take(x, (x + bit / kWidth) % kWidth);
  }
}

/// Turns the tests of a round into steps, from sides x and y to those of the caller.
class Notes {
 public:
  explicit Notes(const PairFrame& frame)
      : swapped_(frame.swapped()),
        blocks_x_(frame.x().layout().blocks()),
        blocks_y_(frame.y().layout().blocks()) {}

  /// \pre The tests have not been made: `pairs` says which boxes are wanted.
  void wanted(const TraversalRound& round, std::vector<FastStep>& steps) const {
    for (const NodeTask& task : std::span(round.nodes).first(round.node_count)) {
      std::uint32_t x_boxes = 0;
      std::uint32_t y_boxes = 0;
      for_each_pair(task.pairs, [&](std::uint32_t x, std::uint32_t y) {
        x_boxes |= 1U << x;
        y_boxes |= 1U << y;
      });
      steps.push_back(step(FastTest::nodes, index_of(task.node_id_x), index_of(task.node_id_y),
                           x_boxes, y_boxes));
      steps.back().node_tests = static_cast<std::uint64_t>(std::popcount(task.pairs));
    }
    for (const NodeTask& task : std::span(round.larger).first(round.larger_count)) {
      steps.push_back(step(FastTest::larger, index_of(task.node_id_x), index_of(task.node_id_y),
                           task.descends_x() ? task.pairs : 0, task.descends_x() ? 0 : task.pairs));
      steps.back().node_tests = static_cast<std::uint64_t>(std::popcount(task.pairs));
    }
    for (const BlockTask& task : std::span(round.blocks).first(round.block_count)) {
      steps.push_back(step(FastTest::leaves, static_cast<std::uint32_t>(task.x - blocks_x_.data()),
                           static_cast<std::uint32_t>(task.y - blocks_y_.data()), 0, 0));
      steps.back().node_tests = task.x->count + task.y->count;
    }
  }

  /// \pre `steps` are those of `wanted`, and the tests have been made.
  void made(const TraversalRound& round, std::span<FastStep> steps) const {
    for (std::size_t i = 0; i < round.node_count; ++i) {
      for_each_pair(round.nodes[i].pairs,
                    [&](std::uint32_t x, std::uint32_t y) { steps[i].meet |= bit_of(x, y); });
    }
    for (std::size_t i = 0; i < round.larger_count; ++i) {
      const NodeTask& task = round.larger[i];
      for (std::uint32_t lane = 0; lane < kWidth; ++lane) {
        if ((task.pairs >> lane & 1U) != 0) {
          steps[round.node_count + i].meet |= task.descends_x() ? bit_of(lane, 0) : bit_of(0, lane);
        }
      }
    }
  }

 private:
  [[nodiscard]] FastStep step(FastTest test, std::uint32_t x, std::uint32_t y,
                              std::uint32_t x_boxes, std::uint32_t y_boxes) const {
    FastStep step{.test = test,
                  .a = x,
                  .b = y,
                  .boxes_a = static_cast<std::uint8_t>(x_boxes),
                  .boxes_b = static_cast<std::uint8_t>(y_boxes)};
    if (swapped_) {
      std::swap(step.a, step.b);
      std::swap(step.boxes_a, step.boxes_b);
    }
    return step;
  }

  [[nodiscard]] std::uint16_t bit_of(std::uint32_t x, std::uint32_t y) const {
    return static_cast<std::uint16_t>(1U << (swapped_ ? kWidth * y + x : kWidth * x + y));
  }

  bool swapped_;
  std::span<const TriangleBlock> blocks_x_;
  std::span<const TriangleBlock> blocks_y_;
};

/// The steps before the first round.
void note_start(const Cost& cost, bool at_roots, std::vector<FastStep>& steps) {
  steps.push_back({.test = FastTest::whole, .node_tests = 1});
  if (!at_roots && cost.node_tests > 1) {
    steps.push_back({.test = FastTest::one_box, .node_tests = cost.node_tests - 1});
  }
}

std::uint64_t node_tests_of(std::span<const FastStep> steps) {
  std::uint64_t sum = 0;
  for (const FastStep& step : steps) {
    sum += step.node_tests;
  }
  return sum;
}

}  // namespace

FastSteps fast_steps(const Body& a, const Body& b, std::size_t most, const Limits& limits) {
  const PlainArithmetic plain;
  soms::detail::check_pose(a.pose, a.shape);
  soms::detail::check_pose(b.pose, b.shape);
  FastSteps all;
  if (soms::detail::is_empty(a.shape) || soms::detail::is_empty(b.shape)) {
    return all;
  }
  if (soms::detail::any_compact(a.shape, b.shape)) {
    throw Error(ErrorKind::usage, "steps of the default traversal: a body is kept compact",
                "build it with Layout::wide");
  }
  PairFrame frame(a, b);
  soms::detail::TraversalMemory memory;
  soms::detail::Limit limit(limits);
  soms::detail::OverlapTraversal<soms::detail::WideSource> traversal(frame, OverlapMode::all,
                                                                     memory);
  std::vector<TrianglePair> pairs;
  soms::detail::Collector collector(OverlapMode::all, std::numeric_limits<std::uint64_t>::max(),
                                    pairs);
  traversal.start();
  note_start(traversal.cost(),
             memory.node_ids.size() == 1 && memory.node_ids.at(0).x == soms::detail::kRootId &&
                 memory.node_ids.at(0).y == soms::detail::kRootId && memory.blocks.empty(),
             all.steps);
  const Notes notes(frame);
  TraversalRound round;
  bool goes_on = true;
  while (goes_on) {
    const Cost before = traversal.cost();
    if (!traversal.gather(round)) {
      break;
    }
    all.cut = all.steps.size() >= most;
    if (all.cut) {
      break;
    }
    std::vector<FastStep> steps;
    notes.wanted(round, steps);
    test_round(soms::detail::kernels(), round);
    notes.made(round, steps);
    const Cost gathered = traversal.cost();
    goes_on = traversal.take_up(round, collector, limit);
    const std::uint64_t large = gathered.node_tests - before.node_tests - node_tests_of(steps);
    if (large > 0) {
      steps.insert(steps.begin(), {.test = FastTest::large_leaves, .node_tests = large});
    }
    if (!steps.empty()) {
      steps.back().node_tests += traversal.cost().node_tests - gathered.node_tests;
      steps.back().triangle_tests = traversal.cost().triangle_tests - gathered.triangle_tests;
    }
    for (FastStep& step : steps) {
      step.found = pairs.size();
      all.steps.push_back(step);
    }
    round.clear();
  }
  all.cost = traversal.cost();
  return all;
}

}  // namespace soms::thesis
