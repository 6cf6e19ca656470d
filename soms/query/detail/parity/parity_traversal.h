/// \file
/// Points against one body: rays through its tree, several at a time, and the crossings counted.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/query/contains.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/parity/parity_frame.h"

#include <memory>
#include <span>
#include <vector>

namespace soms::detail {

/// What one thread keeps from one block of points to the next.
class ParityMemory {
 public:
  virtual ~ParityMemory() = default;
  ParityMemory() = default;
  ParityMemory(const ParityMemory&) = delete;
  ParityMemory& operator=(const ParityMemory&) = delete;

  /// Decides the sides of points, and adds up what each costs; what is left when time is up stays
  /// undecided.
  /// \errors ErrorKind::cancelled.
  virtual void decide(std::span<const Vec3> points, std::span<Side> sides, std::span<Cost> costs,
                      Limit& limit) = 0;
};

/// Made for a body and its frame, which must stay. \pre The body is not empty.
[[nodiscard]] std::unique_ptr<ParityMemory> parity_memory(const Body& body,
                                                          const ParityFrame& frame);

/// What the ray of a point meets: all of it, in no order that means anything.
struct PointCrossings {
  std::vector<TriangleId> crossed;
  std::vector<TriangleId> on;  ///< triangles that the point is a point of; none of `crossed`
  bool complete = false;       ///< false where time was up before
};

/// As ParityMemory, for queries that need to know which triangles are crossed.
class CrossingMemory {
 public:
  virtual ~CrossingMemory() = default;
  CrossingMemory() = default;
  CrossingMemory(const CrossingMemory&) = delete;
  CrossingMemory& operator=(const CrossingMemory&) = delete;

  /// Lists what the rays of points meet, into rows that are there, and adds up what each costs.
  /// \errors ErrorKind::cancelled.
  virtual void list(std::span<const Vec3> points, std::span<PointCrossings> rows,
                    std::span<Cost> costs, Limit& limit) = 0;
};

/// As `parity_memory`.
[[nodiscard]] std::unique_ptr<CrossingMemory> crossing_memory(const Body& body,
                                                              const ParityFrame& frame);

}  // namespace soms::detail
