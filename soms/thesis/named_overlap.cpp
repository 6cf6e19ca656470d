#include "soms/thesis/named_overlap.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/thesis/e_node_front.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/traversals.h"

#include <optional>
#include <string>
#include <utility>

namespace soms::thesis {

namespace {

using detail::Collector;
using detail::Limit;

const TraversalOptions& checked(const TraversalOptions& options) {
  check(options);
  if (options.traversal == Traversal::fast) {
    throw Error(ErrorKind::usage, "traversal fast does not traverse canonical trees",
                "name another traversal");
  }
  return options;
}

const Tree& kept_tree(const Shape& shape, const TraversalOptions& options) {
  if (shape.tree() == nullptr) {
    throw Error(ErrorKind::usage,
                "traversal " + std::string(entry(options.traversal).name) +
                    ": a shape without its canonical tree",
                "make the shape with ShapeOptions{.keep_tree = true}, or use traversal fast");
  }
  return *shape.tree();
}

void check_both(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
  check(pose_a);
  check(pose_b);
  check_range(pose_a, a.bounds());
  check_range(pose_b, b.bounds());
}

struct MovedTriangle {
  TriangleId id;
  Triangle corners;
  Box box;
};

/// Decides the triangles of leaf pairs and gathers the answer of one query.
class Decider {
 public:
  Decider(const PosedBoxes& a, const PosedBoxes& b, const OverlapOptions& options,
          const Limits& limits, std::vector<MovedTriangle>& scratch)
      : a_(a),
        b_(b),
        mode_(options.mode),
        scratch_(scratch),
        limit_(limits),
        collector_(options.mode, options.limit, answer_.pairs) {}

  /// False once nothing more is wanted.
  [[nodiscard]] bool leaf_pair(NodePair pair) {
    const Tree& tree_a = *a_.view().tree;
    const Tree& tree_b = *b_.view().tree;
    scratch_.clear();
    for (const TriangleId j : tree_b.triangles_of(tree_b.nodes[pair.b])) {
      const Triangle t = b_.triangle(j);
      const Box box = bounds(t);
      if (overlaps(a_.boxes()[pair.a], box)) {
        scratch_.push_back({j, t, box});
      }
    }
    // Leaves may be as large as the mesh: what is looked at counts, though nothing be decided.
    if (!keep_going(tree_b.nodes[pair.b].count)) {
      return false;
    }
    for (const TriangleId i : tree_a.triangles_of(tree_a.nodes[pair.a])) {
      const Triangle s = a_.triangle(i);
      const Box box = bounds(s);
      for (const MovedTriangle& other : scratch_) {
        if (overlaps(box, other.box) && !decide(i, s, other)) {
          return false;
        }
      }
      if (!keep_going(1 + scratch_.size())) {
        return false;
      }
    }
    return true;
  }

  /// Counts work; false when the deadline has passed. \errors ErrorKind::cancelled.
  [[nodiscard]] bool keep_going(std::uint64_t work) { return !limit_.spend(work); }

  [[nodiscard]] Overlap finish(const TraversalCounts& counts) {
    collector_.finish();
    answer_.any = collector_.any();
    answer_.cost.node_tests = counts.box_tests;
    const bool found = mode_ != OverlapMode::all && answer_.any;
    if (collector_.full()) {
      answer_.coverage = Coverage::cut;
    } else if (limit_.late()) {
      answer_.coverage = mode_ == OverlapMode::any && found ? Coverage::first : Coverage::cut;
    } else {
      answer_.coverage = found ? Coverage::first : Coverage::complete;
    }
    return std::move(answer_);
  }

 private:
  [[nodiscard]] bool decide(TriangleId i, const Triangle& s, const MovedTriangle& other) {
    const TrianglePair pair{i, other.id};
    if (!collector_.wants(pair)) {
      return true;
    }
    ++answer_.cost.triangle_tests;
    if (triangles_overlap(s, other.corners, &answer_.cost.exact_tests) && collector_.add(pair)) {
      return false;
    }
    return keep_going(1);
  }

  const PosedBoxes& a_;
  const PosedBoxes& b_;
  OverlapMode mode_;
  std::vector<MovedTriangle>& scratch_;
  Overlap answer_;
  Limit limit_;
  Collector collector_;
};

}  // namespace

struct NamedOverlap::State {
  State(const Shape& shape_a, const Shape& shape_b, const TraversalOptions& traversal)
      : a(shape_a),
        b(shape_b),
        options(checked(traversal)),
        posed_a(a.mesh(), kept_tree(a, options)),
        posed_b(b.mesh(), kept_tree(b, options)) {
    if (options.traversal == Traversal::e_node_front) {
      front.emplace(*a.tree(), *b.tree(), options.descent, options.order);
    }
  }

  void run(const TraversalVisitor& visitor) {
    counts = front ? front->next(posed_a.boxes(), posed_b.boxes(), visitor)
                   : traverse(posed_a.view(), posed_b.view(), options, visitor, workspace);
  }

  Shape a;
  Shape b;
  TraversalOptions options;
  PosedBoxes posed_a;
  PosedBoxes posed_b;
  std::optional<EnodeFront> front;
  TraversalWorkspace workspace;
  std::vector<MovedTriangle> scratch;
  TraversalCounts counts;
};

NamedOverlap::NamedOverlap(const Shape& a, const Shape& b, const TraversalOptions& options)
    : state_(std::make_unique<State>(a, b, options)) {
}

NamedOverlap::~NamedOverlap() = default;
NamedOverlap::NamedOverlap(NamedOverlap&&) noexcept = default;
NamedOverlap& NamedOverlap::operator=(NamedOverlap&&) noexcept = default;

Overlap NamedOverlap::operator()(const Pose& pose_a, const Pose& pose_b,
                                 const OverlapOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  State& state = *state_;
  check_stop(limits);
  check_both(state.a, pose_a, state.b, pose_b);
  Decider decider(state.posed_a, state.posed_b, options, limits, state.scratch);
  TraversalVisitor visitor;
  visitor.leaf_pair = [&](NodePair p) { return decider.leaf_pair(p); };
  visitor.keep_going = [&] { return decider.keep_going(kBoxTestsBetweenAsks); };
  state.counts = {};
  if (decider.keep_going(0)) {  // moving a large body takes its time, too
    move(pose_a, pose_b);
    state.run(visitor);
  }
  return decider.finish(state.counts);
}

void NamedOverlap::move(const Pose& pose_a, const Pose& pose_b) {
  const PlainArithmetic plain;
  State& state = *state_;
  check_both(state.a, pose_a, state.b, pose_b);
  state.posed_a.move(pose_a, state.options.update);
  state.posed_b.move(pose_b, state.options.update);
}

const TraversalCounts& NamedOverlap::counts() const {
  return state_->counts;
}

}  // namespace soms::thesis
