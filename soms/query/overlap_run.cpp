#include "soms/query/overlap_run.h"

#include "soms/base/arithmetic.h"
#include "soms/query/detail/batched_root_descent.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/overlap_query.h"
#include "soms/query/detail/wide_pair_traversal.h"
#include "soms/query/traversal/named_overlap.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace soms {

namespace {

using detail::BatchedRootDescent;
using detail::Collector;
using detail::first_is_reference;
using detail::Kernels;
using detail::PairTraversal;
using detail::ReferenceFrame;
using detail::RelativePose;
using detail::RootDescent;
using detail::TraversalMemory;
using detail::TraversalRound;
using detail::TraversalSide;
using detail::Watch;

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
  std::optional<PairTraversal> traversal;
  std::optional<Collector> collector;
  std::optional<Watch> watch;
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
  const Parallel& parallel;
};

/// One run. Root descents go first; queries that end there are never put in flight.
class Run {
 public:
  Run(const PoseQueries& run_input, RunAnswers& answers, BatchedRootDescent& descents)
      : input_(run_input),
        mover_is_reference_(
            first_is_reference(run_input.mover.layout(), run_input.fixed.shape.layout())),
        fixed_frame_(run_input.fixed.shape.layout(), run_input.fixed.pose),
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
    const Kernels& tests = detail::kernels();
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
      PairTraversal::test(tests, round);
      for (std::size_t i = 0; i < count; ++i) {
        InFlightQuery& query = *in_flight[i];
        query.over = !query.traversal->take_up(round, *query.collector, *query.watch);
      }
    }
  }

 private:
  /// Brings the next group of queries to where their traversals begin; false if there is none left.
  bool descend_roots() {
    check_stop(input_.parallel);
    descents_.clear();
    begun_ = 0;
    const WideTree& mover = input_.mover.layout();
    const WideTree& fixed = input_.fixed.shape.layout();
    for (; next_ < input_.poses.size() && !descents_.full(); ++next_) {
      const Pose& pose = *input_.poses[next_];
      if (mover_is_reference_) {
        descents_.add(fixed, input_.fixed.pose, ReferenceFrame(mover, pose));
      } else {
        descents_.add(mover, pose, fixed_frame_);
      }
    }
    descents_.look(mover_is_reference_ ? mover : fixed);
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
      const Watch watch(input_.options, input_.parallel);
      const std::uint64_t end = answers_.pairs.size();
      answers_.poses[pose] = {end, end, descent.cost,
                              coverage_of(input_.options.mode, nothing, watch.late()), false};
    }
    return false;
  }

  void begin_query(InFlightQuery& query, std::size_t i, std::size_t pose) {
    query.pose = pose;
    const RootDescent& descent = descents_[i];
    RelativePose& relative = descents_.take(i, query.number);
    const Body& fixed = input_.fixed;
    const TraversalSide mover_side{&input_.mover, input_.poses[pose]};
    const TraversalSide fixed_side{&fixed.shape, &fixed.pose};
    query.pairs.clear();
    query.collector.emplace(input_.options.mode, input_.options.limit, query.pairs);
    query.watch.emplace(input_.options, input_.parallel);
    query.traversal.emplace(relative, mover_is_reference_ ? fixed_side : mover_side,
                            mover_is_reference_ ? mover_side : fixed_side, mover_is_reference_,
                            input_.options.mode, query.memory);
    query.traversal->start(descent.seeds, descent.cost);
    query.over = false;
  }

  void finish_query(InFlightQuery& query) {
    query.collector->finish();
    std::vector<TrianglePair>& pairs = answers_.pairs;
    const std::uint64_t first = pairs.size();
    pairs.insert(pairs.end(), query.pairs.begin(), query.pairs.end());
    answers_.poses[query.pose] = {
        first, pairs.size(), query.traversal->cost(),
        coverage_of(input_.options.mode, *query.collector, query.watch->late()),
        query.collector->any()};
  }

  const PoseQueries& input_;
  bool mover_is_reference_;
  ReferenceFrame fixed_frame_;
  RunAnswers& answers_;
  BatchedRootDescent& descents_;
  std::size_t begun_ = 0;
  std::size_t next_ = 0;
};

/// Puts the answer to a single query in its place; poses come in order.
void add(const Overlap& answer, std::size_t pose, RunAnswers& answers) {
  const std::uint64_t first = answers.pairs.size();
  answers.pairs.insert(answers.pairs.end(), answer.pairs.begin(), answer.pairs.end());
  answers.poses[pose] = {first, answers.pairs.size(), answer.cost, answer.coverage, answer.any};
}

/// Poses one by one: what compact layouts write out is of no use to other queries.
void query_compact(const PoseQueries& run_input, RunAnswers& answers) {
  const Parallel alone{1, run_input.parallel.stop, {}};
  for (std::size_t i = 0; i < run_input.poses.size(); ++i) {
    add(overlap(Body{run_input.mover, *run_input.poses[i]}, run_input.fixed, run_input.options,
                alone),
        i, answers);
  }
}

void query_named(const PoseQueries& run_input, RunAnswers& answers) {
  detail::NamedOverlap ask(run_input.mover, run_input.fixed.shape, run_input.options.traversal);
  for (std::size_t i = 0; i < run_input.poses.size(); ++i) {
    add(ask(*run_input.poses[i], run_input.fixed.pose, run_input.options, run_input.parallel), i,
        answers);
    answers.traversals.push_back(ask.counts());
  }
}

}  // namespace

struct OverlapRun::Memory {
  BatchedRootDescent descents;
  std::unique_ptr<InFlightQuery[]> queries;
  std::size_t count = 0;
};

OverlapRun::OverlapRun() : memory_(std::make_unique_for_overwrite<Memory>()) {
}

OverlapRun::~OverlapRun() = default;
OverlapRun::OverlapRun(OverlapRun&&) noexcept = default;
OverlapRun& OverlapRun::operator=(OverlapRun&&) noexcept = default;

void OverlapRun::ask(const Shape& mover, std::span<const Pose* const> poses, const Body& fixed,
                     const OverlapOptions& options, const Parallel& parallel, RunAnswers& answers) {
  const PlainArithmetic plain;
  check(options);
  const PoseQueries run_input{mover, poses, fixed, options, parallel};
  answers.pairs.clear();
  answers.traversals.clear();
  answers.poses.assign(poses.size(), {});
  if (options.traversal.traversal != Traversal::fast) {
    query_named(run_input, answers);
  } else if (detail::any_compact(mover, fixed.shape)) {
    query_compact(run_input, answers);
  } else if (!detail::is_empty(mover) && !detail::is_empty(fixed.shape)) {
    const std::size_t most = queries_in_flight(mover, fixed.shape);
    if (memory_->count < most) {
      memory_->queries = std::make_unique_for_overwrite<InFlightQuery[]>(most);
      memory_->count = most;
    }
    Run(run_input, answers, memory_->descents).go(std::span(memory_->queries.get(), most));
  }
}

}  // namespace soms
