#include "soms/query/detail/parity/parity_traversal.h"

#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/query/detail/parity/triangle_crossing.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

/// Counts crossings modulo 2. The first triangle that a point is on decides.
class Parity {
 public:
  using State = bool;  // an odd number so far

  explicit Parity(std::span<Side> sides) : sides_(sides) {}

  void miss(std::size_t i) { sides_[i] = Side::outside; }

  void launch(bool& odd, std::size_t i) {
    odd = false;
    sides_[i] = Side::undecided;
  }

  static void cross(bool& odd, std::size_t /*i*/, const TriangleBlock& /*block*/,
                    std::uint32_t lanes) {
    odd = odd != (std::popcount(lanes) % 2 != 0);
  }

  static void cross(bool& odd, std::size_t /*i*/, TriangleId /*triangle*/) { odd = !odd; }

  /// True: nothing more needs to be known of the point.
  bool meet(std::size_t i, TriangleId /*triangle*/) {
    sides_[i] = Side::on;
    return true;
  }

  void arrive(bool odd, std::size_t i) {
    if (sides_[i] == Side::undecided) {
      sides_[i] = odd ? Side::inside : Side::outside;
    }
  }

 private:
  std::span<Side> sides_;
};

/// Lists crossings.
class Listing {
 public:
  struct State {};

  explicit Listing(std::span<PointCrossings> rows) : rows_(rows) {}

  void miss(std::size_t i) {
    clear(rows_[i]);
    rows_[i].complete = true;
  }

  void launch(State /*state*/, std::size_t i) { clear(rows_[i]); }

  void cross(State /*state*/, std::size_t i, const TriangleBlock& block, std::uint32_t lanes) {
    for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
      rows_[i].crossed.push_back(block.id[static_cast<std::size_t>(std::countr_zero(left))]);
    }
  }

  void cross(State /*state*/, std::size_t i, TriangleId triangle) {
    rows_[i].crossed.push_back(triangle);
  }

  bool meet(std::size_t i, TriangleId triangle) {
    rows_[i].on.push_back(triangle);
    return false;
  }

  void arrive(State /*state*/, std::size_t i) { rows_[i].complete = true; }

 private:
  static void clear(PointCrossings& row) {
    row.crossed.clear();
    row.on.clear();
    row.complete = false;
  }

  std::span<PointCrossings> rows_;
};

/// A point whose ray is on its way.
template <class State>
struct RayOnItsWay {
  RayStart start;
  Vec3 point;
  std::size_t index = 0;
  State state = {};                  // of the tally
  std::vector<std::uint32_t> stack;  // tokens of nodes and of blocks, the next one last
};

/// Rays through one tree. Those in flight take turns, so that one computes while others load. A
/// `Tally` learns what each of them meets.
template <class Source, class Tally>
class ParityTraversal {
 public:
  ParityTraversal(const Body& body, const ParityFrame& frame)
      : body_(body), frame_(frame), kernels_(kernels()), source_(body.shape) {}

  void run(std::span<const Vec3> points, Tally tally, std::span<Cost> costs, Limit& limit) {
    tally_ = &tally;
    costs_ = costs;
    std::size_t next = 0;
    std::size_t count = 0;
    for (;;) {
      for (; count < kInFlight && next < points.size(); ++next) {
        if (frame_.outside(points[next])) {
          tally.miss(next);
        } else {
          launch(rays_[count++], points[next], next);
        }
      }
      if (count == 0 || limit.spend(count)) {
        return;
      }
      count = advance(count);
    }
  }

 private:
  static constexpr std::size_t kInFlight = Source::kInPlace ? 16 : 1;

  using Ray = RayOnItsWay<typename Tally::State>;

  void launch(Ray& ray, const Vec3& point, std::size_t index) {
    ray.start = frame_.start(point);
    ray.point = point;
    ray.index = index;
    ray.stack.assign(1, kRootId);
    tally_->launch(ray.state, index);
  }

  /// Takes each ray a node or a block further; returns how many are still on their way, which
  /// are the first ones then.
  std::size_t advance(std::size_t count) {
    std::size_t nodes = 0;
    std::size_t blocks = 0;
    for (std::size_t i = 0; i < count; ++i) {
      Ray& ray = rays_[i];
      const std::uint32_t token = ray.stack.back();
      ray.stack.pop_back();
      if ((token & WideNode::kLeafBit) == 0) {
        node_ray_[nodes] = i;
        node_task_[nodes++] = {&frame_.numbers(), &ray.start, &source_.node(token), 0};
      } else {
        block_ray_[blocks] = i;
        block_token_[blocks] = token;
        block_task_[blocks++] = {&frame_.numbers(), &ray.start, &source_.block(token), 0, 0};
      }
    }
    kernels_.ray_nodes(node_task_.data(), nodes);
    for (std::size_t k = 0; k < nodes; ++k) {
      descend(node_task_[k], rays_[node_ray_[k]]);
    }
    kernels_.ray_blocks(block_task_.data(), blocks);
    for (std::size_t k = 0; k < blocks; ++k) {
      count_crossings(block_task_[k], block_token_[k], rays_[block_ray_[k]]);
    }
    for (std::size_t i = 0; i < count;) {
      if (arrived(rays_[i])) {
        std::swap(rays_[i], rays_[--count]);
      } else {
        ++i;
      }
    }
    return count;
  }

  void descend(const RayNodeTask& task, Ray& ray) {
    costs_[ray.index].node_tests += task.node->count;
    for (std::uint32_t left = task.lanes; left != 0; left &= left - 1) {
      ray.stack.push_back(task.node->child[static_cast<std::size_t>(std::countr_zero(left))]);
    }
  }

  void count_crossings(const RayBlockTask& task, std::uint32_t token, Ray& ray) {
    const TriangleBlock& block = *task.block;
    Cost& cost = costs_[ray.index];
    cost.triangle_tests += block.count;
    tally_->cross(ray.state, ray.index, block, task.cross);
    for (std::uint32_t left = task.open; left != 0; left &= left - 1) {
      const TriangleId id = block.id[static_cast<std::size_t>(std::countr_zero(left))];
      bool exact = false;
      const RayHit hit = triangle_crossing(moved_triangle(body_, id), ray.point, frame_.axis(),
                                           ray.start.sign > 0, exact);
      cost.exact_tests += exact ? 1U : 0U;
      if (hit == RayHit::cross) {
        tally_->cross(ray.state, ray.index, id);
      } else if (hit == RayHit::on && tally_->meet(ray.index, id)) {
        ray.stack.clear();
        return;
      }
    }
    if (block.following != 0) {
      ray.stack.push_back(source_.next(token));
    }
  }

  /// Starts to load what comes next, or ends it.
  bool arrived(const Ray& ray) {
    if (!ray.stack.empty()) {
      const std::uint32_t token = ray.stack.back();
      if ((token & WideNode::kLeafBit) == 0) {
        source_.fetch_node(token);
      } else {
        source_.fetch_block(token);
      }
      return false;
    }
    tally_->arrive(ray.state, ray.index);
    return true;
  }

  const Body& body_;
  const ParityFrame& frame_;
  const Kernels& kernels_;
  Source source_;
  Tally* tally_ = nullptr;
  std::span<Cost> costs_;
  std::array<Ray, kInFlight> rays_;
  std::array<RayNodeTask, kInFlight> node_task_;
  std::array<RayBlockTask, kInFlight> block_task_;
  std::array<std::size_t, kInFlight> node_ray_;
  std::array<std::size_t, kInFlight> block_ray_;
  std::array<std::uint32_t, kInFlight> block_token_;
};

template <class Source>
class ParityOfPoints : public ParityMemory {
 public:
  ParityOfPoints(const Body& body, const ParityFrame& frame) : rays_(body, frame) {}

  void decide(std::span<const Vec3> points, std::span<Side> sides, std::span<Cost> costs,
              Limit& limit) override {
    rays_.run(points, Parity(sides), costs, limit);
  }

 private:
  ParityTraversal<Source, Parity> rays_;
};

template <class Source>
class CrossingsOfPoints : public CrossingMemory {
 public:
  CrossingsOfPoints(const Body& body, const ParityFrame& frame) : rays_(body, frame) {}

  void list(std::span<const Vec3> points, std::span<PointCrossings> rows, std::span<Cost> costs,
            Limit& limit) override {
    rays_.run(points, Listing(rows), costs, limit);
  }

 private:
  ParityTraversal<Source, Listing> rays_;
};

}  // namespace

std::unique_ptr<ParityMemory> parity_memory(const Body& body, const ParityFrame& frame) {
  if (body.shape.layout().compact() != nullptr) {
    return std::make_unique<ParityOfPoints<CompactSource>>(body, frame);
  }
  return std::make_unique<ParityOfPoints<WideSource>>(body, frame);
}

std::unique_ptr<CrossingMemory> crossing_memory(const Body& body, const ParityFrame& frame) {
  if (body.shape.layout().compact() != nullptr) {
    return std::make_unique<CrossingsOfPoints<CompactSource>>(body, frame);
  }
  return std::make_unique<CrossingsOfPoints<WideSource>>(body, frame);
}

}  // namespace soms::detail
