/// \file
/// Another way to find the overlaps of a batch, for those who compare ways.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/overlap.h"

#include <span>

namespace soms {

/// What a scene asks in place of `overlap`, if it is given (StepOptions::method). Its answers mean
/// what those of `overlap` mean; costs may differ.
class OverlapMethod {
 public:
  OverlapMethod() = default;
  OverlapMethod(const OverlapMethod&) = delete;
  OverlapMethod& operator=(const OverlapMethod&) = delete;
  virtual ~OverlapMethod() = default;

  /// The overlaps of `mover` at each of `poses` with `fixed`, one after the other on the caller's
  /// thread: of `limits` only `stop` counts.
  /// \pre     All poses have passed their checks.
  /// \threads Any number of callers.
  [[nodiscard]] virtual OverlapBatch ask(const Shape& mover, std::span<const Pose* const> poses,
                                         const Body& fixed, const OverlapOptions& options,
                                         const Limits& limits) const = 0;
};

}  // namespace soms
