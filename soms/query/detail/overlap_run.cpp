#include "soms/query/detail/overlap_run.h"

#include "soms/base/arithmetic.h"
#include "soms/base/portable.h"
#include "soms/query/detail/batched_root_descent.h"
#include "soms/query/detail/check_options.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/overlap_query.h"
#include "soms/query/detail/overlap_traversal.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace soms::detail {

namespace {

/// Where both trees are larger than what a core has close at hand, queries wait for memory.
constexpr std::size_t kClose = std::size_t{2} << 20;

/// Queries in flight: while one waits for memory, others work. Where none has to wait, they would
/// only be in each other's way.
std::size_t queries_in_flight(const Shape& a, const Shape& b) {
  return std::min(a.layout().memory(), b.layout().memory()) > kClose ? TraversalRound::kTraversals
                                                                     : 1;
}

/// A query in flight.
struct InFlightQuery {
  std::optional<OverlapTraversal<WideSource>> traversal;
  std::optional<Collector> collector;
  std::optional<Limit> limit;
  TraversalMemory memory;
  std::vector<TrianglePair> pairs;
  std::size_t number = 0;
  std::size_t pose = 0;
  bool over = false;
};

static_assert(TraversalRound::kTraversals <= BatchedRootDescent::kTraversals);

/// What is queried of every pose.
struct PoseQueries {
  const Shape& mover;
  std::span<const Pose* const> poses;
  const Body& fixed;
  const OverlapOptions& options;
  const Limits& limits;
};

/// Takes the answers to a run's poses, in any order.
class Answers {
 public:
  /// Every pose is answered by "nothing" first.
  Answers(OverlapBatch& batch, RowWriter<TrianglePair>& pairs, std::size_t poses)
      : batch_(batch), pairs_(pairs) {
    batch.any.assign(poses, 0);
    batch.coverage.assign(poses, Coverage::complete);
    batch.costs.assign(poses, {});
    batch.cost = {};
    pairs.begin(poses, batch.offsets, batch.pairs);
  }

  void add(std::size_t pose, bool any, std::span<const TrianglePair> pairs, Coverage coverage,
           const Cost& cost) {
    batch_.any[pose] = any ? 1 : 0;
    batch_.coverage[pose] = coverage;
    batch_.costs[pose] = cost;
    batch_.cost += cost;
    pairs_.add(pose, pairs);
  }

  void add(std::size_t pose, const Overlap& answer) {
    add(pose, answer.any, answer.pairs, answer.coverage, answer.cost);
  }

  void finish() { pairs_.finish(); }

 private:
  OverlapBatch& batch_;
  RowWriter<TrianglePair>& pairs_;
};

/// One run. Root descents go first; queries that end there are never put in flight.
class Run {
 public:
  Run(const PoseQueries& run_input, Answers& answers, BatchedRootDescent& descents)
      : input_(run_input),
        frames_(run_input.mover, run_input.fixed),
        answers_(answers),
        descents_(descents) {
    descents_.clear();
  }

  void go(std::span<InFlightQuery> queries) {
    std::array<InFlightQuery*, TraversalRound::kTraversals> in_flight = {};
    std::size_t count = 0;
    while (count < queries.size() && begin_query(queries[count], count)) {
      in_flight[count] = &queries[count];
      ++count;
    }
    const Kernels& tests = kernels();
    TraversalRound round;
    while (count > 0) {
      round.clear();
      for (std::size_t i = 0; i < count;) {
        InFlightQuery& query = *in_flight[i];
        if (!query.over && query.traversal->gather(round)) {
          ++i;
          continue;
        }
        finish_query(query);
        if (!begin_query(query, query.number)) {
          in_flight[i] = in_flight[--count];
        }
      }
      test_round(tests, round);
      for (std::size_t i = 0; i < count; ++i) {
        InFlightQuery& query = *in_flight[i];
        query.over = !query.traversal->take_up(round, *query.collector, *query.limit);
      }
    }
  }

 private:
  /// Brings the next group of queries to where their traversals begin; false if there is none left.
  bool descend_roots() {
    check_stop(input_.limits);
    descents_.clear();
    begun_ = 0;
    for (; next_ < input_.poses.size() && !descents_.full(); ++next_) {
      descents_.add(*input_.poses[next_]);
    }
    descents_.look(frames_);
    return descents_.size() != 0;
  }

  /// Begins the next traversal; false if there is none left. Most queries of small bodies need
  /// none.
  bool begin_query(InFlightQuery& query, std::size_t number) {
    query.number = number;
    while (begun_ < descents_.size() || descend_roots()) {
      const std::size_t pose = next_ - descents_.size() + begun_;
      const std::size_t i = begun_++;
      const RootDescent& descent = descents_[i];
      if (!descent.seeds.empty()) {
        begin_query(query, i, pose);
        return true;
      }
      query.pairs.clear();
      const Collector nothing(input_.options.mode, input_.options.limit, query.pairs);
      const Limit limit(input_.limits);
      answers_.add(pose, false, {}, coverage_of(input_.options.mode, nothing, limit.late()),
                   descent.cost);
    }
    return false;
  }

  void begin_query(InFlightQuery& query, std::size_t i, std::size_t pose) {
    query.pose = pose;
    const RootDescent& descent = descents_[i];
    query.pairs.clear();
    query.collector.emplace(input_.options.mode, input_.options.limit, query.pairs);
    query.limit.emplace(input_.limits);
    query.traversal.emplace(descents_.frame(frames_, i, query.number), input_.options.mode,
                            query.memory);
    query.traversal->start(descent.seeds, descent.cost);
    query.over = false;
  }

  void finish_query(InFlightQuery& query) {
    query.collector->finish();
    answers_.add(query.pose, query.collector->any(), query.pairs,
                 coverage_of(input_.options.mode, *query.collector, query.limit->late()),
                 query.traversal->cost());
  }

  const PoseQueries& input_;
  PoseFrames frames_;
  Answers& answers_;
  BatchedRootDescent& descents_;
  std::size_t begun_ = 0;
  std::size_t next_ = 0;
};

/// Poses one by one: what compact layouts write out is of no use to other queries.
void query_compact(const PoseQueries& run_input, Answers& answers) {
  const Limits alone = run_input.limits.alone();
  for (std::size_t i = 0; i < run_input.poses.size(); ++i) {
    answers.add(i, overlap(Body{run_input.mover, *run_input.poses[i]}, run_input.fixed,
                           run_input.options, alone));
  }
}

}  // namespace

struct OverlapRun::Memory {
  BatchedRootDescent descents;
  RowWriter<TrianglePair> pairs;
  std::unique_ptr<InFlightQuery[]> queries;
  std::size_t count = 0;
};

OverlapRun::OverlapRun() : memory_(make_for_overwrite<Memory>()) {
}

OverlapRun::~OverlapRun() = default;
OverlapRun::OverlapRun(OverlapRun&&) noexcept = default;
OverlapRun& OverlapRun::operator=(OverlapRun&&) noexcept = default;

void OverlapRun::ask(const Shape& mover, std::span<const Pose* const> poses, const Body& fixed,
                     const OverlapOptions& options, const Limits& limits, OverlapBatch& batch) {
  const PlainArithmetic plain;
  check_options(options);
  const PoseQueries run_input{mover, poses, fixed, options, limits};
  Answers answers(batch, memory_->pairs, poses.size());
  if (any_compact(mover, fixed.shape)) {
    query_compact(run_input, answers);
  } else if (!is_empty(mover) && !is_empty(fixed.shape)) {
    const std::size_t most = queries_in_flight(mover, fixed.shape);
    if (memory_->count < most) {
      memory_->queries = make_array_for_overwrite<InFlightQuery>(most);
      memory_->count = most;
    }
    Run(run_input, answers, memory_->descents).go(std::span(memory_->queries.get(), most));
  }
  answers.finish();
}

}  // namespace soms::detail
