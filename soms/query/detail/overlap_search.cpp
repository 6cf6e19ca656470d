#include "soms/query/detail/overlap_search.h"

#include "soms/base/parallel.h"
#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/overlap_query.h"
#include "soms/query/detail/overlap_traversal.h"
#include "soms/query/detail/self/self_frame.h"

#include <atomic>
#include <cstddef>
#include <limits>
#include <vector>

namespace soms::detail {

namespace {

/// Pairs of nodes that a query is cut into for several threads.
constexpr std::size_t kFrontier = 256;

/// What one part of a shared query found.
struct PartOfSearch {
  std::vector<TrianglePair> pairs;
  Cost cost;
  bool late = false;
};

/// Joins the parts in the frontier's order.
void join(const std::vector<PartOfSearch>& parts, const OverlapOptions& options, Overlap& answer) {
  Collector collector(options.mode, options.limit, answer.pairs);
  bool late = false;
  bool enough = false;
  for (const PartOfSearch& part : parts) {
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
template <class Frame>
void run_parallel(Frame& frame, const OverlapOptions& options, const Limits& limits,
                  Overlap& answer) {
  TraversalMemory memory;
  OverlapTraversal<WideSource, Frame> head(frame, options.mode, memory);
  const std::vector<NodeRefPair> frontier = head.frontier(kFrontier);
  answer.cost = head.cost();
  std::vector<PartOfSearch> parts(frontier.size());
  std::atomic<bool> done = false;
  for_each_chunk(frontier.size(), 1, limits.without_deadline(),
                 [&](std::size_t begin, std::size_t) {
                   if (done) {
                     return;
                   }
                   PartOfSearch& part = parts[begin];
                   TraversalMemory own;
                   Limit limit(limits, &done);
                   OverlapTraversal<WideSource, Frame> traversal(frame, options.mode, own);
                   Collector collector(options.mode, options.limit, part.pairs);
                   traversal.start(frontier[begin]);
                   traversal.run(collector, limit);
                   collector.finish();
                   part.cost = traversal.cost();
                   part.late = limit.late();
                   if (options.mode == OverlapMode::any && collector.any()) {
                     done = true;
                   }
                 });
  join(parts, options, answer);
}

/// One query on the caller's thread.
template <class Source, class Frame>
void run_single(Frame& frame, const OverlapOptions& options, const Limits& limits,
                Overlap& answer) {
  Limit limit(limits);
  Collector collector(options.mode, options.limit, answer.pairs);
  RootTest roots;
  if constexpr (!Frame::kSelf) {
    test_roots<Source>(frame, roots);
    if (roots.clear) {
      answer.coverage = coverage_of(options.mode, collector, limit.late());
      answer.cost.node_tests = 1;
      return;
    }
  }
  TraversalMemory memory;
  OverlapTraversal<Source, Frame> traversal(frame, options.mode, memory);
  traversal.start(roots);
  traversal.run(collector, limit);
  collector.finish();
  answer.any = collector.any();
  answer.coverage = coverage_of(options.mode, collector, limit.late());
  answer.cost = traversal.cost();
}

}  // namespace

template <class Frame>
void search_overlap(Frame& frame, const OverlapOptions& options, const Limits& limits,
                    Overlap& answer) {
  // The first pairs in the order of one thread are best found by one thread, and so is the least
  // pair, which rules out most of what is left.
  const bool limited = options.limit != std::numeric_limits<std::uint64_t>::max();
  if (any_compact(*frame.x().shape, *frame.y().shape)) {
    run_single<CompactSource>(frame, options, limits, answer);
  } else if (limits.threads != 1 && !limited && options.mode != OverlapMode::first) {
    run_parallel(frame, options, limits, answer);
  } else {
    run_single<WideSource>(frame, options, limits, answer);
  }
}

template void search_overlap(PairFrame& frame, const OverlapOptions& options, const Limits& limits,
                             Overlap& answer);
template void search_overlap(SelfFrame& frame, const OverlapOptions& options, const Limits& limits,
                             Overlap& answer);

}  // namespace soms::detail
