/// \file
/// How much work a traversal does up to the first hit of a frame.
#pragma once

#include "soms/base/limits.h"

#include "thesis/races/moved_trip.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::reproduce {

/// What is waited for.
enum class Hit {
  leaf_pair,  ///< a pair of leaves whose boxes overlap is reported
  contact,    ///< triangles of a reported pair touch
};

/// Work up to the first hit of a frame, summed over the frames that have one.
struct UntilHit {
  std::uint64_t box_tests = 0;
  std::uint64_t entered = 0;
  std::vector<std::size_t> frames = {};  ///< those with a hit, in order
};

/// Traverses `frames` of a trip in order. With `stops` a query ends at its hit, and E-Node from the
/// last front goes on from what was left then; else each frame is traversed to its end. From a
/// fresh start both do the same work up to the hit.
/// \errors ErrorKind::cancelled.
[[nodiscard]] UntilHit until_hit(const MovedTrip& moved, const TripRacer& racer, Hit hit,
                                 bool stops, std::span<const std::size_t> frames,
                                 const Limits& limits);

}  // namespace soms::reproduce
