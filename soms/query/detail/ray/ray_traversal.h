/// \file
/// Rays against one body, through its tree.
#pragma once

#include "soms/geometry/detail/exact/exact_ray.h"
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

/// One ray, with no memory but the stack's where that suffices. \pre The body is not empty.
template <class Goal>
[[nodiscard]] typename Goal::Answer answer_ray(const Body& body, std::optional<TriangleId> skip,
                                               const RayLine& line, Limit& limit);

#define SOMS_RAYS_OF(Goal)                                                                  \
  extern template std::unique_ptr<RayMemory<Goal>> ray_memory(const Body&, const RayFrame&, \
                                                              std::optional<TriangleId>);   \
  extern template Goal::Answer answer_ray<Goal>(const Body&, std::optional<TriangleId>,     \
                                                const RayLine&, Limit&);
SOMS_RAYS_OF(ClosestHitGoal)
SOMS_RAYS_OF(AnyHitGoal)
SOMS_RAYS_OF(AllHitsGoal)
#undef SOMS_RAYS_OF

}  // namespace soms::detail
