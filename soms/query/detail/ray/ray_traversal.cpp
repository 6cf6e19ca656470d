#include "soms/query/detail/ray/ray_traversal.h"

#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/kernels/instruction_set.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

/// A node, or a block, that is still to be looked at.
struct Ahead {
  float near;  // nothing in it is nearer along the ray
  std::uint32_t token;
};

/// A ray on its way.
template <class Goal>
struct Flight {
  RayTarget target;
  Goal goal;
  std::size_t index = 0;
  std::vector<Ahead> stack;  // the next one last
};

/// Rays through one tree, the nearest boxes first. Those in flight take turns, so that one computes
/// while others load.
template <class Source, class Goal>
class RayTraversal : public RayMemory<Goal> {
 public:
  using Answer = typename Goal::Answer;

  RayTraversal(const Body& body, const RayFrame& frame, std::optional<TriangleId> skip)
      : frame_(frame), kernels_(kernels()), source_(body.shape) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (Flight<Goal>& flight : flights_) {
      flight.target.body = &body;
      flight.target.skip = skip;
    }
  }

  void answer(std::span<const RayLine> lines, std::span<Answer> answers, Limit& limit) override {
    answers_ = answers;
    std::size_t next = 0;
    std::size_t count = 0;
    for (;;) {
      for (; count < kInFlight && next < lines.size(); ++next) {
        Flight<Goal>& flight = at(count);
        if (launch(flight, lines[next], next)) {
          ++count;
        } else {
          answers_[next] = flight.goal.end(flight.target, true);
        }
      }
      if (count == 0) {
        return;
      }
      if (limit.spend(count + std::exchange(exact_tests_, 0) * kExactWork)) {
        break;
      }
      count = advance(count);
    }
    for (std::size_t i = 0; i < count; ++i) {
      answers_[at(i).index] = at(i).goal.end(at(i).target, false);
    }
    for (; next < lines.size(); ++next) {
      answers_[next].coverage = Coverage::cut;
    }
  }

 private:
  static constexpr std::size_t kInFlight = Source::kInPlace ? 16 : 1;
  static constexpr std::uint64_t kExactWork = 100;  // some microseconds

  [[nodiscard]] Flight<Goal>& at(std::size_t i) { return flights_[order_[i]]; }

  /// False if the ray misses the whole body.
  bool launch(Flight<Goal>& flight, const RayLine& line, std::size_t index) {
    flight.target.line = line;
    flight.target.direction = ScaledDirection(line);
    flight.target.cost = {};
    flight.goal.begin();
    flight.index = index;
    flight.stack.assign(1, {-std::numeric_limits<float>::infinity(), kRootId});
    return frame_.start(line, flight.target.direction, flight.target.course);
  }

  /// Takes each ray a node or a block further; returns how many are still on their way, which are
  /// the first ones then.
  std::size_t advance(std::size_t count) {
    std::size_t nodes = 0;
    std::size_t blocks = 0;
    for (std::size_t i = 0; i < count; ++i) {
      Flight<Goal>& flight = at(i);
      const Ahead ahead = flight.stack.back();
      flight.stack.pop_back();
      const LineNumbers* const line = &flight.target.course.numbers;
      if ((ahead.token & WideNode::kLeafBit) == 0) {
        node_flight_[nodes] = &flight;
        node_task_[nodes++] = {line, &source_.node(ahead.token), 0, {}};
      } else {
        block_flight_[blocks] = &flight;
        block_ahead_[blocks] = ahead;
        block_task_[blocks++] = {line, &source_.block(ahead.token), 0, 0, 0, {}};
      }
    }
    kernels_.line_nodes(node_task_.data(), nodes);
    for (std::size_t k = 0; k < nodes; ++k) {
      descend(node_task_[k], *node_flight_[k]);
    }
    kernels_.line_blocks(block_task_.data(), blocks);
    for (std::size_t k = 0; k < blocks; ++k) {
      look(block_task_[k], block_ahead_[k], *block_flight_[k]);
    }
    for (std::size_t i = 0; i < count;) {
      if (arrived(at(i))) {
        std::swap(order_[i], order_[--count]);
      } else {
        ++i;
      }
    }
    return count;
  }

  void descend(const LineNodeTask& task, Flight<Goal>& flight) {
    const WideNode& node = *task.node;
    flight.target.cost.node_tests += node.count;
    const std::size_t begin = flight.stack.size();
    for (std::uint32_t left = task.lanes; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      flight.stack.push_back({task.near[lane], node.child[lane]});
      if constexpr (Goal::kNearestFirst) {
        for (std::size_t i = flight.stack.size() - 1;
             i > begin && flight.stack[i].near > flight.stack[i - 1].near; --i) {
          std::swap(flight.stack[i], flight.stack[i - 1]);
        }
      }
    }
  }

  void look(const LineBlockTask& task, const Ahead& ahead, Flight<Goal>& flight) {
    Cost& cost = flight.target.cost;
    cost.triangle_tests += task.block->count;
    const std::uint64_t before = cost.exact_tests;
    if (flight.goal.look(flight.target, task)) {
      flight.stack.clear();
    } else if (task.block->following != 0) {
      flight.stack.push_back({ahead.near, source_.next(ahead.token)});
    }
    exact_tests_ += cost.exact_tests - before;
  }

  /// Starts to load what comes next, or ends it.
  bool arrived(Flight<Goal>& flight) {
    std::vector<Ahead>& stack = flight.stack;
    while (!stack.empty() && stack.back().near > flight.target.course.numbers.far_open) {
      stack.pop_back();
    }
    if (stack.empty()) {
      answers_[flight.index] = flight.goal.end(flight.target, true);
      return true;
    }
    const std::uint32_t token = stack.back().token;
    if ((token & WideNode::kLeafBit) == 0) {
      source_.fetch_node(token);
    } else {
      source_.fetch_block(token);
    }
    return false;
  }

  const RayFrame& frame_;
  const Kernels& kernels_;
  Source source_;
  std::span<Answer> answers_;
  std::uint64_t exact_tests_ = 0;  // since the limit was last looked at
  std::array<Flight<Goal>, kInFlight> flights_;
  std::array<std::size_t, kInFlight> order_;  // those on their way first
  std::array<LineNodeTask, kInFlight> node_task_;
  std::array<LineBlockTask, kInFlight> block_task_;
  std::array<Flight<Goal>*, kInFlight> node_flight_;
  std::array<Flight<Goal>*, kInFlight> block_flight_;
  std::array<Ahead, kInFlight> block_ahead_;
};

}  // namespace

template <class Goal>
std::unique_ptr<RayMemory<Goal>> ray_memory(const Body& body, const RayFrame& frame,
                                            std::optional<TriangleId> skip) {
  if (body.shape.layout().compact() != nullptr) {
    return std::make_unique<RayTraversal<CompactSource, Goal>>(body, frame, skip);
  }
  return std::make_unique<RayTraversal<WideSource, Goal>>(body, frame, skip);
}

template std::unique_ptr<RayMemory<ClosestHitGoal>> ray_memory(const Body&, const RayFrame&,
                                                               std::optional<TriangleId>);
template std::unique_ptr<RayMemory<AnyHitGoal>> ray_memory(const Body&, const RayFrame&,
                                                           std::optional<TriangleId>);
template std::unique_ptr<RayMemory<AllHitsGoal>> ray_memory(const Body&, const RayFrame&,
                                                            std::optional<TriangleId>);

}  // namespace soms::detail
