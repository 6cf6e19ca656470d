/// \file
/// Decides pairs of blocks that a walk found: which of their triangles overlap.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/tree/shape.h"

#include <cstdint>
#include <span>

namespace soms::detail {

/// A shape at a pose, as one side of a walk.
struct WalkSide {
  const Shape* shape;
  const Pose* pose;
};

/// The leaves of one query. Sides x and y are the caller's a and b, or b and a when `swapped`.
class LeafPairs {
 public:
  LeafPairs(const WalkSide& x, const WalkSide& y, bool swapped) : x_(x), y_(y), swapped_(swapped) {}

  /// Decides pairs of blocks whose slabs have been tested; true when the walk is to stop.
  [[nodiscard]] bool decide(std::span<const BlockTask> tasks, Collector& collector, Cost& cost);

 private:
  /// Decides triangles of two blocks: those of y in byte i of `rows` with triangle i of x.
  [[nodiscard]] bool decide(const BlockTask& task, std::uint64_t rows, Collector& collector,
                            Cost& cost);

  /// Decides one triangle of x against those of y in `lanes`.
  [[nodiscard]] bool decide(TriangleId i, const TriangleBlock& y, std::uint32_t lanes,
                            Collector& collector, Cost& cost);

  WalkSide x_;
  WalkSide y_;
  bool swapped_;
};

}  // namespace soms::detail
