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

}  // namespace soms::detail
