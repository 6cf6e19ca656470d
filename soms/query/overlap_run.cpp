#include "soms/query/overlap_run.h"

#include "soms/base/arithmetic.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/overlap_query.h"
#include "soms/query/detail/pair_walk.h"
#include "soms/query/detail/scouts.h"
#include "soms/query/traversal/named_overlap.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace soms {

namespace {

using detail::Collector;
using detail::first_is_viewer;
using detail::Kernels;
using detail::PairWalk;
using detail::RelativePose;
using detail::Scout;
using detail::Scouts;
using detail::Viewer;
using detail::WalkMemory;
using detail::WalkRound;
using detail::WalkSide;
using detail::Watch;

/// Where both trees are larger than what a core has close at hand, queries wait for memory.
constexpr std::size_t kClose = std::size_t{2} << 20;

/// Queries in flight: while one waits for memory, others work. Where none has to wait, they would
/// only be in each other's way.
std::size_t flights_of(const Shape& a, const Shape& b) {
  return std::min(a.layout().memory(), b.layout().memory()) > kClose ? WalkRound::kWalks : 1;
}

/// A query in flight.
struct Flight {
  std::optional<PairWalk> walk;
  std::optional<Collector> collector;
  std::optional<Watch> watch;
  WalkMemory memory;
  std::vector<TrianglePair> pairs;
  std::size_t number = 0;
  std::size_t pose = 0;
  bool over = false;
};

static_assert(WalkRound::kWalks <= Scouts::kWalks);

/// What is asked of every pose.
struct Question {
  const Shape& mover;
  std::span<const Pose* const> poses;
  const Body& fixed;
  const OverlapOptions& options;
  const Parallel& parallel;
};

/// One run. Scouts go ahead; queries that are over then never take off.
class Run {
 public:
  Run(const Question& question, RunAnswers& answers, Scouts& scouts)
      : question_(question),
        mover_views_(first_is_viewer(question.mover.layout(), question.fixed.shape.layout())),
        fixed_viewer_(question.fixed.shape.layout(), question.fixed.pose),
        answers_(answers),
        scouts_(scouts) {
    scouts_.clear();
  }

  void go(std::span<Flight> flights) {
    std::array<Flight*, WalkRound::kWalks> open = {};
    std::size_t count = 0;
    while (count < flights.size() && take_off(flights[count], count)) {
      open[count] = &flights[count];
      ++count;
    }
    const Kernels& tests = detail::kernels();
    WalkRound round;
    while (count > 0) {
      round.clear();
      for (std::size_t i = 0; i < count;) {
        Flight& flight = *open[i];
        if (!flight.over && flight.walk->gather(round)) {
          ++i;
          continue;
        }
        land(flight);
        if (!take_off(flight, flight.number)) {
          open[i] = open[--count];
        }
      }
      PairWalk::test(tests, round);
      for (std::size_t i = 0; i < count; ++i) {
        Flight& flight = *open[i];
        flight.over = !flight.walk->take_up(round, *flight.collector, *flight.watch);
      }
    }
  }

 private:
  /// Brings the next group of queries to where their walks begin; false if there is none left.
  bool send_scouts() {
    check_stop(question_.parallel);
    scouts_.clear();
    scouted_ = 0;
    const WideTree& mover = question_.mover.layout();
    const WideTree& fixed = question_.fixed.shape.layout();
    for (; next_ < question_.poses.size() && !scouts_.full(); ++next_) {
      const Pose& pose = *question_.poses[next_];
      if (mover_views_) {
        scouts_.add(fixed, question_.fixed.pose, Viewer(mover, pose));
      } else {
        scouts_.add(mover, pose, fixed_viewer_);
      }
    }
    scouts_.look(mover_views_ ? mover : fixed);
    return scouts_.size() != 0;
  }

  /// Begins the next walk; false if there is none left. Most queries of small bodies need none.
  bool take_off(Flight& flight, std::size_t number) {
    flight.number = number;
    while (scouted_ < scouts_.size() || send_scouts()) {
      const std::size_t pose = next_ - scouts_.size() + scouted_;
      const std::size_t i = scouted_++;
      const Scout& scout = scouts_[i];
      if (!scout.seeds.empty()) {
        take_off(flight, i, pose);
        return true;
      }
      flight.pairs.clear();
      const Collector nothing(question_.options.mode, question_.options.limit, flight.pairs);
      const Watch watch(question_.options, question_.parallel);
      const std::uint64_t end = answers_.pairs.size();
      answers_.poses[pose] = {end, end, scout.cost,
                              coverage_of(question_.options.mode, nothing, watch.late()), false};
    }
    return false;
  }

  void take_off(Flight& flight, std::size_t i, std::size_t pose) {
    flight.pose = pose;
    const Scout& scout = scouts_[i];
    RelativePose& relative = scouts_.take(i, flight.number);
    const Body& fixed = question_.fixed;
    const WalkSide mover_side{&question_.mover, question_.poses[pose]};
    const WalkSide fixed_side{&fixed.shape, &fixed.pose};
    flight.pairs.clear();
    flight.collector.emplace(question_.options.mode, question_.options.limit, flight.pairs);
    flight.watch.emplace(question_.options, question_.parallel);
    flight.walk.emplace(relative, mover_views_ ? fixed_side : mover_side,
                        mover_views_ ? mover_side : fixed_side, mover_views_,
                        question_.options.mode, flight.memory);
    flight.walk->start(scout.seeds, scout.cost);
    flight.over = false;
  }

  void land(Flight& flight) {
    flight.collector->finish();
    std::vector<TrianglePair>& pairs = answers_.pairs;
    const std::uint64_t first = pairs.size();
    pairs.insert(pairs.end(), flight.pairs.begin(), flight.pairs.end());
    answers_.poses[flight.pose] = {
        first, pairs.size(), flight.walk->cost(),
        coverage_of(question_.options.mode, *flight.collector, flight.watch->late()),
        flight.collector->any()};
  }

  const Question& question_;
  bool mover_views_;
  Viewer fixed_viewer_;
  RunAnswers& answers_;
  Scouts& scouts_;
  std::size_t scouted_ = 0;
  std::size_t next_ = 0;
};

/// Puts the answer to a single query in its place; poses come in order.
void add(const Overlap& answer, std::size_t pose, RunAnswers& answers) {
  const std::uint64_t first = answers.pairs.size();
  answers.pairs.insert(answers.pairs.end(), answer.pairs.begin(), answer.pairs.end());
  answers.poses[pose] = {first, answers.pairs.size(), answer.cost, answer.coverage, answer.any};
}

/// Poses one by one: what compact layouts write out is of no use to other queries.
void ask_compact(const Question& question, RunAnswers& answers) {
  const Parallel alone{1, question.parallel.stop, {}};
  for (std::size_t i = 0; i < question.poses.size(); ++i) {
    add(overlap(Body{question.mover, *question.poses[i]}, question.fixed, question.options, alone),
        i, answers);
  }
}

void ask_named(const Question& question, RunAnswers& answers) {
  detail::NamedOverlap ask(question.mover, question.fixed.shape, question.options.traversal);
  for (std::size_t i = 0; i < question.poses.size(); ++i) {
    add(ask(*question.poses[i], question.fixed.pose, question.options, question.parallel), i,
        answers);
  }
}

}  // namespace

struct OverlapRun::Memory {
  Scouts scouts;
  std::unique_ptr<Flight[]> flights;
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
  const Question question{mover, poses, fixed, options, parallel};
  answers.pairs.clear();
  answers.poses.assign(poses.size(), {});
  if (options.traversal.traversal != Traversal::fast) {
    ask_named(question, answers);
  } else if (detail::any_compact(mover, fixed.shape)) {
    ask_compact(question, answers);
  } else if (!detail::is_empty(mover) && !detail::is_empty(fixed.shape)) {
    const std::size_t most = flights_of(mover, fixed.shape);
    if (memory_->count < most) {
      memory_->flights = std::make_unique_for_overwrite<Flight[]>(most);
      memory_->count = most;
    }
    Run(question, answers, memory_->scouts).go(std::span(memory_->flights.get(), most));
  }
}

}  // namespace soms
