/// \file
/// Batches one after the other on one thread, without setting up or checking anything twice: what
/// scenes and batches are made of.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/body.h"
#include "soms/query/overlap.h"

#include <memory>
#include <span>

namespace soms::detail {

/// Memory for runs; one that was moved from has none. \threads One caller at a time.
class OverlapRun {
 public:
  OverlapRun();
  ~OverlapRun();
  OverlapRun(OverlapRun&&) noexcept;
  OverlapRun& operator=(OverlapRun&&) noexcept;

  /// `overlap` of `mover` at each of `poses` with `fixed`, in place of what `batch` held; the
  /// memory of that is used again. Each query takes the steps that it would take alone, so answers
  /// and costs do not depend on its neighbors. Of `limits` the stop and the deadline count.
  /// \pre    All poses, that of `fixed` too, have passed `check` and, with their shapes,
  ///         `check_range`.
  /// \errors As `overlap` but for poses.
  void ask(const Shape& mover, std::span<const Pose* const> poses, const Body& fixed,
           const OverlapOptions& options, const Limits& limits, OverlapBatch& batch);

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace soms::detail
