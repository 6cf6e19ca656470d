/// \file
/// Batches one after the other on one thread, without setting up or checking anything twice: what
/// scenes and batches are made of.
#pragma once

#include "soms/base/parallel.h"
#include "soms/query/body.h"
#include "soms/query/overlap.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace soms {

/// Answers of a run, pose by pose.
struct RunAnswers {
  /// Answer for a pose; its pairs are [begin, end) of `pairs`.
  struct Answer {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    Cost cost;
    Coverage coverage = Coverage::complete;
    bool any = false;

    [[nodiscard]] bool operator==(const Answer&) const = default;
  };

  std::vector<Answer> poses;
  std::vector<TrianglePair> pairs;
  std::vector<TraversalCounts> traversals = {};  ///< pose by pose with a named traversal, else none

  [[nodiscard]] bool operator==(const RunAnswers&) const = default;

  [[nodiscard]] std::span<const TrianglePair> pairs_of(std::size_t pose) const {
    const Answer& answer = poses[pose];
    return std::span(pairs).subspan(answer.begin, answer.end - answer.begin);
  }
};

/// Memory for runs; one that was moved from has none. \threads One caller at a time.
class OverlapRun {
 public:
  OverlapRun();
  ~OverlapRun();
  OverlapRun(OverlapRun&&) noexcept;
  OverlapRun& operator=(OverlapRun&&) noexcept;

  /// `overlap` of `mover` at each of `poses` with `fixed`, in place of what `answers` held. Each
  /// query takes the steps that it would take alone, so answers and costs do not depend on its
  /// neighbors. Of `parallel` only `stop` counts.
  /// \pre    All poses, that of `fixed` too, have passed `check` and, with their shapes,
  /// `check_range`. \errors As `overlap` but for poses.
  void ask(const Shape& mover, std::span<const Pose* const> poses, const Body& fixed,
           const OverlapOptions& options, const Parallel& parallel, RunAnswers& answers);

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace soms
