/// \file
/// Searches many bodies by their boxes: the nearest to a point, the first on a ray.
#pragma once

#include "soms/query/body.h"
#include "soms/query/closest.h"
#include "soms/query/ray.h"
#include "soms/scene/detail/box_index.h"
#include "soms/scene/of_bodies.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace soms::detail {

/// Bodies under the numbers 0, 1 and so on, with an index of their world boxes. The bodies must
/// stay where they are.
class BodySet {
 public:
  /// Replaces the content; `boxes` are those of the bodies. A body with an empty box is never met.
  void build(std::vector<const Body*> bodies, std::span<const Box> boxes);

  [[nodiscard]] const BoxIndex& boxes() const { return boxes_; }

  [[nodiscard]] const Body& body(std::uint32_t number) const { return *bodies_[number]; }

  [[nodiscard]] std::size_t size() const { return bodies_.size(); }

  /// The number of bodies whose boxes are not empty.
  [[nodiscard]] std::size_t filled() const { return filled_; }

  [[nodiscard]] std::size_t memory() const { return boxes_.memory() + bytes(bodies_); }

 private:
  BoxIndex boxes_;
  std::vector<const Body*> bodies_;
  std::size_t filled_ = 0;
};

/// Sets that are searched together. A body's number is its place, all sets in a row; among equally
/// near bodies that of the least number counts.
using BodySets = std::span<const BodySet* const>;

/// A body of such sets: takes no part, or only its triangle RayOptions::skip does not.
using LeftOut = std::optional<std::uint32_t>;

/// Throws ErrorKind::usage if a body is left out that is not there; unless a triangle to skip is of
/// such a body.
void check_left_out(BodySets sets, LeftOut left_out);
void check_left_out(BodySets sets, const RayOptions& options, LeftOut left_out);

/// The body of a number. \pre It is there.
[[nodiscard]] const Body& body_of(BodySets sets, std::uint32_t number);

/// The queries of BodyIndex, of the same contracts.
[[nodiscard]] BodyClosest closest(BodySets sets, const Vec3& point, const ClosestOptions& options,
                                  LeftOut left_out, const Limits& limits);
[[nodiscard]] BodyClosestBatch closest(BodySets sets, std::span<const Vec3> points,
                                       const ClosestOptions& options, LeftOut left_out,
                                       const Limits& limits);
[[nodiscard]] BodyHit closest_hit(BodySets sets, const Ray& ray, const RayOptions& options,
                                  LeftOut left_out, const Limits& limits);
[[nodiscard]] BodyHitBatch closest_hit(BodySets sets, std::span<const Ray> rays,
                                       const RayOptions& options, LeftOut left_out,
                                       const Limits& limits);
[[nodiscard]] AnyHit any_hit(BodySets sets, const Ray& ray, const RayOptions& options,
                             LeftOut left_out, const Limits& limits);
[[nodiscard]] AnyHitBatch any_hit(BodySets sets, std::span<const Ray> rays,
                                  const RayOptions& options, LeftOut left_out,
                                  const Limits& limits);
[[nodiscard]] BodyAllHits all_hits(BodySets sets, std::span<const Ray> rays,
                                   const RayOptions& options, LeftOut left_out,
                                   const Limits& limits);

}  // namespace soms::detail
