/// \file
/// E-Node that stops at an earlier level and takes boxes that overlap for a contact: a reading that
/// gives up exactness, measured beside the exact answer.
#pragma once

#include "soms/base/limits.h"

#include "thesis/races/moved_trip.h"
#include "thesis/trips/frames.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace soms::reproduce {

/// No frame of a trip.
inline constexpr std::size_t kNoFrame = std::numeric_limits<std::size_t>::max();

/// Trees cut at a level, summed over the frames of a trip.
struct EarlierLevel {
  std::uint64_t box_tests = 0;
  std::uint64_t entered = 0;
  std::uint64_t first_tests = 0;       ///< box tests up to the first pair that is called touching
  std::uint64_t pairs = 0;             ///< pairs of nodes that are called touching
  std::uint64_t touching_pairs = 0;    ///< of them, those whose triangles touch
  std::uint64_t called_frames = 0;     ///< frames with a pair that is called touching
  std::size_t first_frame = kNoFrame;  ///< the first of them

  [[nodiscard]] bool operator==(const EarlierLevel&) const = default;
};

/// For each level from 1 on, to the deeper of both trees: what E-Node, testing children before it
/// enters them, both nodes, finds in trees cut at that level, where a pair of boxes that overlap is
/// called touching and no triangle is tested. One traversal of the whole trees finds all levels:
/// that of cut trees makes the tests of their nodes in the same order.
/// \pre `exact` are the frames of the trip with their contacts.
/// \shape one EarlierLevel a level, level 1 first.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<EarlierLevel> earlier_nodes(const MovedTrip& moved,
                                                      std::span<const Frame> exact,
                                                      const Limits& limits);

}  // namespace soms::reproduce
