/// \file
/// Queries of many bodies by a loop over all of them: what `BodyIndex` must equal.
#pragma once

#include "soms/scene/body_index.h"

#include <span>

namespace soms::reference {

/// Same meaning as `BodyIndex::closest`, without options: the query of each body by brute force,
/// compared in whole numbers. `cost` is the sum of all.
/// \errors  As `closest_by_brute_force`.
/// \cost    That of n queries by brute force.
[[nodiscard]] BodyClosest closest_by_brute_force(std::span<const Body> bodies, const Vec3& point);

/// The same for `BodyIndex::closest_hit`.
/// \errors  As `closest_hit_by_brute_force`.
[[nodiscard]] BodyHit closest_hit_by_brute_force(std::span<const Body> bodies, const Ray& ray);

/// The same for `BodyIndex::all_hits`, of one ray.
/// \errors  As `all_hits_by_brute_force`.
[[nodiscard]] BodyAllHits all_hits_by_brute_force(std::span<const Body> bodies, const Ray& ray);

}  // namespace soms::reference
