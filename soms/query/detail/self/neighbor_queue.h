/// \file
/// Neighbors that wait to be judged together, so that no lane idles.
#pragma once

#include "soms/query/detail/collector.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/self/self_frame.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// The neighbors of one query.
class NeighborQueue {
 public:
  NeighborQueue(const SelfFrame& frame, const Kernels& kernels);

  /// Takes the pairs of a task that have corners in common out of `pairs`, with those that are met
  /// twice, and decides some; true when the traversal is to stop.
  [[nodiscard]] bool take(const BlockTask& task, std::uint64_t& pairs, Collector& collector,
                          Cost& cost);

  /// Decides what waits; true when the traversal is to stop.
  [[nodiscard]] bool decide(Collector& collector, Cost& cost);

 private:
  using Judge = std::uint32_t (*)(const NeighborLanes& lanes);

  /// Pairs of one kind.
  struct Waiting {
    NeighborLanes lanes;
    std::array<TrianglePair, NeighborLanes::kMost> ids;
    std::size_t count = 0;
  };

  [[nodiscard]] bool take(const TrianglePair& ids, std::uint32_t common, Collector& collector,
                          Cost& cost);

  void put(const TrianglePair& ids, const CommonPlace& place, Waiting& waiting) const;

  [[nodiscard]] bool decide(Judge judge, Waiting& waiting, Collector& collector, Cost& cost) const;

  /// Decides a pair by exact signs.
  [[nodiscard]] bool decide(const TrianglePair& ids, Collector& collector, Cost& cost) const;

  const SelfFrame* frame_;
  Judge at_corner_;
  Judge at_edge_;
  Waiting corners_;
  Waiting edges_;
};

}  // namespace soms::detail
