#include "soms/query/overlap.h"

#include "soms/base/arithmetic.h"
#include "soms/base/hash.h"
#include "soms/query/detail/compact_traversal.h"
#include "soms/query/detail/overlap_query.h"
#include "soms/query/detail/wide_pair_traversal.h"
#include "soms/query/traversal/named_overlap.h"
#include "soms/query/traversal/traversals.h"

#include <atomic>
#include <limits>

namespace soms {

namespace {

using detail::Collector;
using detail::NodeRefPair;
using detail::PairTraversal;
using detail::ReferenceFrame;
using detail::RelativePose;
using detail::TraversalMemory;
using detail::TraversalSide;
using detail::Watch;

/// Pairs of nodes that a query is cut into for several threads.
constexpr std::size_t kFrontier = 256;

/// Two bodies as a traversal sees them.
struct Sides {
  Sides(const Body& a, const Body& b)
      : swapped(detail::first_is_reference(a.shape.layout(), b.shape.layout())),
        x{swapped ? &b.shape : &a.shape, swapped ? &b.pose : &a.pose},
        y{swapped ? &a.shape : &b.shape, swapped ? &a.pose : &b.pose},
        relative(x.shape->layout(), *x.pose, ReferenceFrame(y.shape->layout(), *y.pose)) {}

  [[nodiscard]] PairTraversal traversal(const OverlapOptions& options, TraversalMemory& memory) {
    return {relative, x, y, swapped, options.mode, memory};
  }

  bool swapped;
  TraversalSide x;
  TraversalSide y;
  RelativePose relative;
};

/// What one part of a shared query found.
struct Part {
  std::vector<TrianglePair> pairs;
  Cost cost;
  bool late = false;
};

/// Joins the parts in the frontier's order.
void join(const std::vector<Part>& parts, const OverlapOptions& options, Overlap& answer) {
  Collector collector(options.mode, options.limit, answer.pairs);
  bool late = false;
  bool enough = false;
  for (const Part& part : parts) {
    answer.cost += part.cost;
    late = late || part.late;
    for (std::size_t i = 0; i < part.pairs.size() && !enough; ++i) {
      enough = collector.add(part.pairs[i]);
    }
  }
  collector.finish();
  answer.any = collector.any();
  answer.coverage = coverage_of(options.mode, collector, late);
}

/// One query on several threads.
void run_parallel(Sides& sides, const OverlapOptions& options, const Parallel& parallel,
                  Overlap& answer) {
  TraversalMemory memory;
  PairTraversal head = sides.traversal(options, memory);
  const std::vector<NodeRefPair> frontier = head.frontier(kFrontier);
  answer.cost = head.cost();
  std::vector<Part> parts(frontier.size());
  std::atomic<bool> done = false;
  for_each_chunk(frontier.size(), 1, parallel, [&](std::size_t begin, std::size_t) {
    if (done) {
      return;
    }
    Part& part = parts[begin];
    TraversalMemory own;
    Watch watch(options, parallel, &done);
    PairTraversal traversal = sides.traversal(options, own);
    Collector collector(options.mode, options.limit, part.pairs);
    traversal.start(frontier[begin]);
    traversal.run(collector, watch);
    collector.finish();
    part.cost = traversal.cost();
    part.late = watch.late();
    if (options.mode == OverlapMode::any && collector.any()) {
      done = true;
    }
  });
  join(parts, options, answer);
}

/// One query on the caller's thread.
void run_single(Sides& sides, const OverlapOptions& options, const Parallel& parallel,
                Overlap& answer) {
  TraversalMemory memory;
  Watch watch(options, parallel);
  PairTraversal traversal = sides.traversal(options, memory);
  Collector collector(options.mode, options.limit, answer.pairs);
  traversal.start();
  traversal.run(collector, watch);
  collector.finish();
  answer.any = collector.any();
  answer.coverage = coverage_of(options.mode, collector, watch.late());
  answer.cost = traversal.cost();
}

/// One query of which one side at least is compact: always on the caller's thread.
void run_compact(Sides& sides, const OverlapOptions& options, const Parallel& parallel,
                 Overlap& answer) {
  Watch watch(options, parallel);
  sides.relative.prepare();
  detail::CompactTraversal traversal(sides.relative, sides.x, sides.y, sides.swapped);
  Collector collector(options.mode, options.limit, answer.pairs);
  traversal.run(collector, watch);
  collector.finish();
  answer.any = collector.any();
  answer.coverage = coverage_of(options.mode, collector, watch.late());
  answer.cost = traversal.cost();
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

void check(const OverlapOptions& options) {
  check(options.traversal);
  const bool limited = options.limit != OverlapOptions{}.limit && options.limit > 0;
  if (limited && options.mode != OverlapMode::all) {
    refuse_idle("overlap options",
                {"limit", "modes any and first return one pair at most", "mode", "all"});
  }
}

Overlap overlap(const Body& a, const Body& b, const OverlapOptions& options,
                const Parallel& parallel) {
  const PlainArithmetic plain;
  check(options);
  if (options.traversal.traversal != Traversal::fast) {
    return detail::named_overlap(a, b, options, parallel);
  }
  detail::check_pose(a.pose, a.shape);
  detail::check_pose(b.pose, b.shape);
  check_stop(parallel);
  Overlap answer;
  if (detail::is_empty(a.shape) || detail::is_empty(b.shape)) {
    return answer;
  }
  Sides sides(a, b);
  // The first pairs in the order of one thread are best found by one thread.
  const bool limited = options.limit != std::numeric_limits<std::uint64_t>::max();
  if (detail::any_compact(a.shape, b.shape)) {
    run_compact(sides, options, parallel, answer);
  } else if (parallel.threads != 1 && !limited) {
    run_parallel(sides, options, parallel, answer);
  } else {
    run_single(sides, options, parallel, answer);
  }
  return answer;
}

}  // namespace soms
