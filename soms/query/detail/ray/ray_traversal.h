/// \file
/// Rays against one body: through its tree, several at a time.
#pragma once

#include "soms/geometry/detail/exact_ray.h"
#include "soms/query/body.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/ray/ray_frame.h"
#include "soms/query/detail/ray/ray_goal.h"

#include <memory>
#include <optional>
#include <span>

namespace soms::detail {

/// What one thread keeps from one block of rays to the next.
template <class Goal>
class RayMemory {
 public:
  virtual ~RayMemory() = default;
  RayMemory() = default;
  RayMemory(const RayMemory&) = delete;
  RayMemory& operator=(const RayMemory&) = delete;

  /// Answers rays; what is left when time is up is cut.
  /// \errors ErrorKind::cancelled.
  virtual void answer(std::span<const RayLine> lines, std::span<typename Goal::Answer> answers,
                      Limit& limit) = 0;
};

/// Made for a body and its frame, which must stay. \pre The body is not empty.
template <class Goal>
[[nodiscard]] std::unique_ptr<RayMemory<Goal>> ray_memory(const Body& body, const RayFrame& frame,
                                                          std::optional<TriangleId> skip);

extern template std::unique_ptr<RayMemory<ClosestHitGoal>> ray_memory(const Body&, const RayFrame&,
                                                                      std::optional<TriangleId>);
extern template std::unique_ptr<RayMemory<AnyHitGoal>> ray_memory(const Body&, const RayFrame&,
                                                                  std::optional<TriangleId>);
extern template std::unique_ptr<RayMemory<AllHitsGoal>> ray_memory(const Body&, const RayFrame&,
                                                                   std::optional<TriangleId>);

}  // namespace soms::detail
