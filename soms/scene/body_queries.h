/// \file
/// The queries of points and rays that many bodies have, whoever holds the bodies.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/query/closest.h"
#include "soms/query/ray.h"
#include "soms/scene/of_bodies.h"

#include <span>

namespace soms {

/// Queries of `Owner`, a class of many bodies. A body is called by a `Name`, and a `Filter` says
/// which take part. Queries see all bodies as one surface whose triangles are named by body and
/// triangle: their answers are the nearest ones of the queries of single bodies, by exact
/// comparison. Equally near ones are decided by the name of the body, then by the number of the
/// triangle. Answers but for `cost` do not depend on trees, layouts, threads or instruction sets.
///
/// \errors  As the queries of bodies that have the same names; a point or ray at fault is named by
///          its index. ErrorKind::usage for a body of the filter that is not there, and for
///          RayOptions::skip where the filter leaves out no body.
/// \cost    Typically logarithmic in the number of bodies, and one query for each body whose box is
///          no farther than what is nearest. `Cost::node_tests` counts boxes of bodies, too.
/// \source  Roussopoulos, Kelley and Vincent 1995 (nearest neighbors by a tree of boxes).
template <class Owner, class Name, class Filter>
class BodyQueries {
 public:
  /// The nearest point of all bodies. Where coverage is `cut`, `triangle` is the nearest so far, if
  /// any, and the bracket's lower end is what was proved of all bodies.
  [[nodiscard]] OfBodies<Closest, Name> closest(const Vec3& point,
                                                const ClosestOptions& options = {},
                                                const Filter& filter = {},
                                                const Limits& limits = {}) const;
  /// \shape `points`: n.
  [[nodiscard]] OfBodies<ClosestBatch, Name> closest(std::span<const Vec3> points,
                                                     const ClosestOptions& options = {},
                                                     const Filter& filter = {},
                                                     const Limits& limits = {}) const;

  /// The first point of all bodies on a ray. Where coverage is `cut`, `triangle` is the
  /// first so far, if any, and the bracket's lower end is what was proved of all bodies.
  [[nodiscard]] OfBodies<ClosestHit, Name> closest_hit(const Ray& ray,
                                                       const RayOptions& options = {},
                                                       const Filter& filter = {},
                                                       const Limits& limits = {}) const;
  /// \shape `rays`: n.
  [[nodiscard]] OfBodies<ClosestHitBatch, Name> closest_hit(std::span<const Ray> rays,
                                                            const RayOptions& options = {},
                                                            const Filter& filter = {},
                                                            const Limits& limits = {}) const;

  /// Whether a ray hits any body.
  [[nodiscard]] AnyHit any_hit(const Ray& ray, const RayOptions& options = {},
                               const Filter& filter = {}, const Limits& limits = {}) const;
  /// \shape `rays`: n.
  [[nodiscard]] AnyHitBatch any_hit(std::span<const Ray> rays, const RayOptions& options = {},
                                    const Filter& filter = {}, const Limits& limits = {}) const;

  /// Every triangle of all bodies that rays meet: for each body the crossings that
  /// `all_hits` has. Rows are sorted by exact t, crossings at the same t by body, then by their
  /// least triangles.
  /// \shape `rays`: n.
  /// \cost    One query for each body whose box a ray meets. O(k log k) comparisons for k
  ///          crossings, exact ones where two bodies are met at nearly the same t; their memory.
  [[nodiscard]] OfBodies<AllHits, Name> all_hits(std::span<const Ray> rays,
                                                 const RayOptions& options = {},
                                                 const Filter& filter = {},
                                                 const Limits& limits = {}) const;

 private:
  friend Owner;
  BodyQueries() = default;
};

}  // namespace soms
