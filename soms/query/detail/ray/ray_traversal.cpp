#include "soms/query/detail/ray/ray_traversal.h"

#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/kernels/instruction_set.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

/// Rays of a batch that take turns.
constexpr std::size_t kRaysInFlight = 8;
static_assert(kRaysInFlight <= kMostDescents);

/// The stack of a descent: as much as trees mostly need, and more where one is deeper.
class DescentStack {
 public:
  void begin(LineDescent& descent) {
    descent.stack = more_.empty() ? usual_.data() : more_.data();
    descent.room = more_.empty() ? usual_.size() : more_.size();
    descent.size = 0;
  }

  /// Makes room for a node's boxes.
  void reserve(LineDescent& descent) {
    if (descent.size + WideNode::kWidth > descent.room) {
      std::vector<Ahead> larger(2 * descent.room);
      std::copy(descent.stack, descent.stack + descent.size, larger.begin());
      more_ = std::move(larger);
      descent.stack = more_.data();
      descent.room = more_.size();
    }
  }

 private:
  std::array<Ahead, 64> usual_;
  std::vector<Ahead> more_;
};

/// A ray on its way.
template <class Goal>
struct PendingRay {
  RayTarget target;
  Goal goal;
  LineDescent descent;
  DescentStack stack;
  std::size_t index = 0;
};

/// Rays through one tree, the nearest boxes first.
template <class Source, class Goal, std::size_t kInFlight>
class RayTraversal final : public RayMemory<Goal> {
 public:
  using Answer = typename Goal::Answer;

  RayTraversal(const Body& body, const RayFrame& frame, std::optional<TriangleId> skip)
      : frame_(frame), kernels_(kernels()), source_(body.shape) {
    for (std::size_t i = 0; i < kInFlight; ++i) {
      PendingRay<Goal>& ray = rays_[i];
      ray.target.body = &body;
      ray.target.skip = skip;
      ray.descent.line = &ray.target.course.numbers;
      pending_[i] = &ray;
    }
  }

  void answer(std::span<const RayLine> lines, std::span<Answer> answers, Limit& limit) override {
    traverse(lines, answers, limit);
    if constexpr (kInFlight != 1) {
      Goal::finish_all(rays_[0].target, lines, answers);
    }
  }

 private:
  static constexpr std::uint64_t kExactWork = 100;  // some microseconds

  void traverse(std::span<const RayLine> lines, std::span<Answer> answers, Limit& limit) {
    answers_ = answers;
    std::size_t next = 0;
    std::size_t count = 0;
    std::uint64_t work = 1;
    while (!limit.spend(work)) {
      for (; count < kInFlight && next < lines.size(); ++next) {
        PendingRay<Goal>& ray = *pending_[count];
        ray.index = next;
        if (launch(ray, lines[next])) {
          ++count;
        } else {
          end(ray, true);
        }
      }
      if (count == 0) {
        return;
      }
      work = descend(count) + look(count);
      count = rest(count);
    }
    for (std::size_t i = 0; i < count; ++i) {
      end(*pending_[i], false);
    }
    for (; next < lines.size(); ++next) {
      answers_[next].coverage = Coverage::cut;
    }
  }

  /// False if the ray misses the whole body.
  bool launch(PendingRay<Goal>& ray, const RayLine& line) {
    ray.target.line = line;
    ray.target.direction = ScaledDirection(line);
    ray.target.cost = {};
    ray.goal.begin();
    ray.stack.begin(ray.descent);
    ray.descent.boxes = 0;
    ray.descent.stack[ray.descent.size++] = {-std::numeric_limits<float>::infinity(), kRootId};
    return frame_.start(line, ray.target.direction, ray.target.course);
  }

  void end(PendingRay<Goal>& ray, bool complete) {
    ray.target.cost.node_tests = ray.descent.boxes;
    answers_[ray.index] = ray.goal.end(ray.target, complete);
    if constexpr (kInFlight == 1) {
      Goal::finish(ray.target, answers_[ray.index]);
    }
  }

  /// Takes rays to blocks, or to their ends; returns the nodes entered.
  std::uint64_t descend(std::size_t count) {
    constexpr std::size_t kSteps = 1000;
    std::array<LineDescent*, kInFlight> descents;
    for (std::size_t i = 0; i < count; ++i) {
      descents[i] = &pending_[i]->descent;
      descents[i]->steps = kSteps;
      pending_[i]->stack.reserve(*descents[i]);
    }
    if constexpr (Source::kInPlace) {
      kernels_.line_descents(source_.nodes(), descents.data(), count);
    } else {
      for (std::size_t i = 0; i < count; ++i) {
        enter_one(*descents[i]);
      }
    }
    std::uint64_t entered = 0;
    for (std::size_t i = 0; i < count; ++i) {
      entered += kSteps - descents[i]->steps;
      if (on_block(*descents[i])) {
        source_.fetch_block(descents[i]->stack[descents[i]->size - 1].token);
      }
    }
    return entered;
  }

  /// A node that does not stay where it is.
  void enter_one(LineDescent& descent) {
    while (descent.size != 0 && descent.stack[descent.size - 1].near > descent.line->far_open) {
      --descent.size;
    }
    if (descent.size != 0 && !on_block(descent)) {
      --descent.steps;
      kernels_.line_node(source_.node(descent.stack[--descent.size].token), descent);
    }
  }

  static bool on_block(const LineDescent& descent) {
    return descent.size != 0 && (descent.stack[descent.size - 1].token & WideNode::kLeafBit) != 0;
  }

  /// Looks at the leaves that rays have come to; returns the work.
  std::uint64_t look(std::size_t count) {
    std::uint64_t work = 0;
    for (std::size_t i = 0; i < count; ++i) {
      PendingRay<Goal>& ray = *pending_[i];
      if (on_block(ray.descent)) {
        const std::uint64_t exact_tests = ray.target.cost.exact_tests;
        if (look_at(ray, ray.descent.stack[--ray.descent.size].token)) {
          ray.descent.size = 0;
        }
        work += 1 + (ray.target.cost.exact_tests - exact_tests) * kExactWork;
      }
    }
    return work;
  }

  /// True when nothing else matters.
  bool look_at(PendingRay<Goal>& ray, std::uint32_t token) {
    bool done = false;
    for (std::uint32_t following = 1; following != 0 && !done; token = source_.next(token)) {
      LineBlockTask task{ray.descent.line, &source_.block(token), 0, 0, 0, {}, {}};
      kernels_.line_block(task);
      ray.target.cost.triangle_tests += task.block->count;
      following = task.block->following;
      done = ray.goal.look(ray.target, task);
    }
    return done;
  }

  /// Ends rays with nothing left; returns how many are on their way, the first ones then.
  std::size_t rest(std::size_t count) {
    for (std::size_t i = 0; i < count;) {
      if (pending_[i]->descent.size == 0) {
        end(*pending_[i], true);
        std::swap(pending_[i], pending_[--count]);
      } else {
        ++i;
      }
    }
    return count;
  }

  const RayFrame& frame_;
  const Kernels& kernels_;
  Source source_;
  std::span<Answer> answers_;
  std::array<PendingRay<Goal>, kInFlight> rays_;
  std::array<PendingRay<Goal>*, kInFlight> pending_;  // those on their way first
};

}  // namespace

template <class Goal>
std::unique_ptr<RayMemory<Goal>> ray_memory(const Body& body, const RayFrame& frame,
                                            std::optional<TriangleId> skip) {
  if (body.shape.layout().compact() != nullptr) {
    return std::make_unique<RayTraversal<CompactSource, Goal, 1>>(body, frame, skip);
  }
  return std::make_unique<RayTraversal<WideSource, Goal, kRaysInFlight>>(body, frame, skip);
}

template <class Goal>
typename Goal::Answer answer_ray(const Body& body, std::optional<TriangleId> skip,
                                 const RayLine& line, Limit& limit) {
  const RayFrame frame(body.shape.layout(), body.pose);
  typename Goal::Answer answer;
  if (body.shape.layout().compact() != nullptr) {
    RayTraversal<CompactSource, Goal, 1>(body, frame, skip).answer({&line, 1}, {&answer, 1}, limit);
  } else {
    RayTraversal<WideSource, Goal, 1>(body, frame, skip).answer({&line, 1}, {&answer, 1}, limit);
  }
  return answer;
}

#define SOMS_RAYS_OF(Goal)                                                                       \
  template std::unique_ptr<RayMemory<Goal>> ray_memory(const Body&, const RayFrame&,             \
                                                       std::optional<TriangleId>);               \
  template Goal::Answer answer_ray<Goal>(const Body&, std::optional<TriangleId>, const RayLine&, \
                                         Limit&);
SOMS_RAYS_OF(ClosestHitGoal)
SOMS_RAYS_OF(AnyHitGoal)
SOMS_RAYS_OF(AllHitsGoal)
#undef SOMS_RAYS_OF

}  // namespace soms::detail
