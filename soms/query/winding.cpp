#include "soms/query/winding.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/near/point_query.h"
#include "soms/query/detail/parity/parity_traversal.h"
#include "soms/query/detail/winding/winding_tree.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace soms {

namespace {

using detail::CrossingMemory;
using detail::Limit;
using detail::ParityFrame;
using detail::PointCrossings;
using detail::WindingTree;

/// Points that a thread takes at a time.
constexpr std::size_t kPointsOfWindingBlock = 256;

constexpr Bracket kAllNumbers{-std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()};

void check_width(double width) {
  if (!(width >= 0 && width <= 1)) {
    throw Error(ErrorKind::usage, "WindingOptions::width must be 0 to 1",
                "the default, 1e-9, suits most");
  }
}

Side side_of(const Bracket& number, bool on) {
  if (on) {
    return Side::on;
  }
  return number.lower > 0.5   ? Side::inside
         : number.upper < 0.5 ? Side::outside
                              : Side::undecided;
}

/// What a thread keeps.
struct WindingMemory {
  std::unique_ptr<CrossingMemory> rays;
  std::vector<PointCrossings> met;
  WindingTree::Memory walk;
};

/// Points into columns that are there.
class WindingRun {
 public:
  WindingRun(const WindingIndex& index, std::span<const Vec3> points, const WindingOptions& options,
             WindingBatch& answer)
      : body_(index.body()),
        tree_(detail::tree_of(index)),
        points_(points),
        options_(options),
        frame_(body_.shape.layout(), body_.pose),
        answer_(answer) {}

  [[nodiscard]] WindingMemory memory() const {
    return {detail::crossing_memory(body_, frame_), {}, {}};
  }

  void decide(std::size_t begin, std::size_t end, WindingMemory& memory, Limit& limit) const {
    const std::size_t count = end - begin;
    memory.met.resize(std::max(memory.met.size(), count));
    for (PointCrossings& met : memory.met) {
      met.complete = false;
    }
    memory.rays->list(points_.subspan(begin, count), std::span(memory.met).first(count),
                      std::span(answer_.costs).subspan(begin, count), limit);
    for (std::size_t k = 0; k < count && !limit.late(); ++k) {
      if (memory.met[k].complete) {
        decide(begin + k, memory.met[k], memory.walk, limit);
      }
    }
  }

 private:
  void decide(std::size_t i, const PointCrossings& met, WindingTree::Memory& memory,
              Limit& limit) const {
    const bool forward = frame_.start(points_[i]).sign > 0;
    Cost& cost = answer_.costs[i];
    const std::uint64_t before = cost.triangle_tests + cost.node_tests;
    answer_.number[i] = tree_.number(body_, points_[i], frame_.axis(), forward, met, options_.width,
                                     memory, cost);
    answer_.side[i] = side_of(answer_.number[i], !met.on.empty());
    answer_.coverages[i] = Coverage::complete;
    static_cast<void>(limit.spend(1 + cost.triangle_tests + cost.node_tests - before));
  }

  const Body& body_;
  const WindingTree& tree_;
  std::span<const Vec3> points_;
  const WindingOptions& options_;
  ParityFrame frame_;
  WindingBatch& answer_;
};

}  // namespace

WindingIndex::WindingIndex(Body body, const Parallel& parallel) : body_(std::move(body)) {
  const PlainArithmetic plain;
  detail::check_pose(body_.pose, body_.shape);
  tree_ = std::make_shared<const WindingTree>(body_, parallel);
}

std::uint64_t WindingIndex::boundary_edges() const {
  return tree_->boundary_edges();
}

std::size_t WindingIndex::memory() const {
  return tree_->memory();
}

const WindingTree& detail::tree_of(const WindingIndex& index) {
  return *index.tree_;
}

Winding winding(const WindingIndex& index, const Vec3& point, const WindingOptions& options) {
  detail::check_point(point);
  return winding(index, std::span(&point, 1), options).at(0);
}

Winding WindingBatch::at(std::size_t point) const {
  return {side[point], number[point], coverages[point], costs[point]};
}

WindingBatch winding(const WindingIndex& index, std::span<const Vec3> points,
                     const WindingOptions& options, const Parallel& parallel) {
  const PlainArithmetic plain;
  check_width(options.width);
  detail::check_points(points);
  WindingBatch answer;
  answer.costs.resize(points.size());
  if (detail::is_empty(index.body().shape)) {
    answer.side.assign(points.size(), Side::outside);
    answer.number.assign(points.size(), {});
    answer.coverages.assign(points.size(), Coverage::complete);
    return answer;
  }
  answer.side.assign(points.size(), Side::undecided);
  answer.number.assign(points.size(), kAllNumbers);
  answer.coverages.assign(points.size(), Coverage::cut);
  const WindingRun run(index, points, options, answer);
  detail::MemoryPool<WindingMemory> pool;
  for_each_chunk(points.size(), kPointsOfWindingBlock, parallel,
                 [&](std::size_t begin, std::size_t end) {
                   auto place = pool.take([&] { return run.memory(); });
                   Limit limit(options.deadline, parallel);
                   run.decide(begin, end, place->memory, limit);
                   pool.give_back(std::move(place));
                 });
  for (std::size_t i = 0; i < points.size(); ++i) {
    answer.cost += answer.costs[i];
    answer.coverage = answer.coverages[i] == Coverage::cut ? Coverage::cut : answer.coverage;
  }
  return answer;
}

}  // namespace soms
