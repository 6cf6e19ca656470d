#include "soms/query/traversal/named_overlap.h"

#include "soms/base/error.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/traversal/e_node_front.h"
#include "soms/query/traversal/posed_boxes.h"
#include "soms/query/traversal/traversals.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace soms::detail {

namespace {

/// Pairs of triangles decided between two looks at the clock.
constexpr std::uint64_t kInterval = 256;

const TraversalOptions& checked(const TraversalOptions& options) {
  check(options);
  if (options.traversal == Traversal::fast) {
    throw Error(ErrorKind::usage, "traversal fast does not walk canonical trees",
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

struct MovedTriangle {
  TriangleId id;
  Triangle corners;
  Box box;
};

/// Decides the triangles of leaf pairs and gathers the answer of one query.
class Gatherer {
 public:
  Gatherer(const PosedBoxes& a, const PosedBoxes& b, const OverlapOptions& options,
           const Parallel& parallel, std::vector<MovedTriangle>& scratch)
      : a_(a), b_(b), options_(options), parallel_(parallel), scratch_(scratch) {}

  /// False once nothing more is wanted.
  [[nodiscard]] bool leaf_pair(const Node& leaf_a, const Node& leaf_b, NodePair pair) {
    scratch_.clear();
    for (const TriangleId j : b_.view().tree->triangles_of(leaf_b)) {
      const Triangle t = b_.triangle(j);
      const Box box = bounds(t);
      if (overlaps(a_.boxes()[pair.a], box)) {
        scratch_.push_back({j, t, box});
      }
    }
    for (const TriangleId i : a_.view().tree->triangles_of(leaf_a)) {
      const Triangle s = a_.triangle(i);
      const Box box = bounds(s);
      for (const MovedTriangle& other : scratch_) {
        if (overlaps(box, other.box) && !decide(i, s, other)) {
          return false;
        }
      }
    }
    return true;
  }

  /// False when the deadline has passed. \errors ErrorKind::cancelled.
  [[nodiscard]] bool keep_going() {
    check_stop(parallel_);
    if (options_.deadline && std::chrono::steady_clock::now() >= *options_.deadline) {
      answer_.coverage = Coverage::cut;
      return false;
    }
    return true;
  }

  [[nodiscard]] Overlap finish(std::uint64_t box_tests) {
    answer_.cost.node_tests = box_tests;
    std::sort(answer_.pairs.begin(), answer_.pairs.end());
    if (answer_.any && options_.mode == OverlapMode::first &&
        answer_.coverage == Coverage::complete) {
      answer_.coverage = Coverage::first;
    }
    return std::move(answer_);
  }

 private:
  [[nodiscard]] bool decide(TriangleId i, const Triangle& s, const MovedTriangle& other) {
    const TrianglePair pair{i, other.id};
    const bool least_only = options_.mode == OverlapMode::first;
    if (least_only && !answer_.pairs.empty() && pair > answer_.pairs.front()) {
      return true;
    }
    if (++answer_.cost.triangle_tests % kInterval == 0 && !keep_going()) {
      return false;
    }
    if (!triangles_overlap(s, other.corners, &answer_.cost.exact_tests)) {
      return true;
    }
    answer_.any = true;
    if (least_only) {
      answer_.pairs.assign(1, pair);
      return true;
    }
    if (answer_.pairs.size() >= options_.limit) {
      answer_.coverage = Coverage::cut;
      return false;
    }
    answer_.pairs.push_back(pair);
    if (options_.mode == OverlapMode::any) {
      answer_.coverage = Coverage::first;
      return false;
    }
    return true;
  }

  const PosedBoxes& a_;
  const PosedBoxes& b_;
  const OverlapOptions& options_;
  const Parallel& parallel_;
  std::vector<MovedTriangle>& scratch_;
  Overlap answer_;
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

  TraversalCounts walk(const TraversalVisitor& visitor) {
    if (front) {
      return front->next(posed_a.boxes(), posed_b.boxes(), visitor);
    }
    return traverse(posed_a.view(), posed_b.view(), options, visitor, workspace);
  }

  Shape a;
  Shape b;
  TraversalOptions options;
  PosedBoxes posed_a;
  PosedBoxes posed_b;
  std::optional<EnodeFront> front;
  TraversalWorkspace workspace;
  std::vector<MovedTriangle> scratch;
};

NamedOverlap::NamedOverlap(const Shape& a, const Shape& b, const TraversalOptions& options)
    : state_(std::make_unique<State>(a, b, options)) {
}

NamedOverlap::~NamedOverlap() = default;
NamedOverlap::NamedOverlap(NamedOverlap&&) noexcept = default;
NamedOverlap& NamedOverlap::operator=(NamedOverlap&&) noexcept = default;

Overlap NamedOverlap::operator()(const Pose& pose_a, const Pose& pose_b,
                                 const OverlapOptions& options, const Parallel& parallel) {
  State& state = *state_;
  check(pose_a);
  check(pose_b);
  check_range(pose_a, state.a.bounds());
  check_range(pose_b, state.b.bounds());
  state.posed_a.move(pose_a, state.options.update);
  state.posed_b.move(pose_b, state.options.update);
  Gatherer gatherer(state.posed_a, state.posed_b, options, parallel, state.scratch);
  std::uint64_t box_tests = 0;
  if (gatherer.keep_going()) {
    TraversalVisitor visitor;
    visitor.leaf_pair = [&](NodePair p) {
      return gatherer.leaf_pair(state.a.tree()->nodes[p.a], state.b.tree()->nodes[p.b], p);
    };
    visitor.keep_going = [&] { return gatherer.keep_going(); };
    box_tests = state.walk(visitor).box_tests;
  }
  return gatherer.finish(box_tests);
}

Overlap named_overlap(const Body& a, const Body& b, const OverlapOptions& options,
                      const Parallel& parallel) {
  NamedOverlap query(a.shape, b.shape, options.traversal);
  return query(a.pose, b.pose, options, parallel);
}

}  // namespace soms::detail
