/// \file
/// Rays against bodies, compared with brute force.
#pragma once

#include "soms/query/ray.h"

#include <string>
#include <vector>

namespace soms::test {

/// What `all_hits` says of one ray: places in their order.
struct Place {
  Bracket t;
  CrossingKind kind = CrossingKind::graze;
  std::vector<TriangleId> triangles;

  [[nodiscard]] bool operator==(const Place&) const = default;
};

/// All places where a ray meets a body.
[[nodiscard]] std::vector<Place> places_on(const Body& body, const Ray& ray);

/// What brute force says of rays.
struct RayTruth {
  std::vector<ClosestHit> first;
  std::vector<std::vector<Place>> all;
};

[[nodiscard]] RayTruth truth_of(const Body& body, const std::vector<Ray>& rays);

/// Empty if the first, any and all hits of the rays, alone and in batches, are those of `truth`;
/// else the first fault.
[[nodiscard]] std::string fault_of_rays(const Body& body, const std::vector<Ray>& rays,
                                        const RayTruth& truth);

/// Expects what brute force says of each ray, under the 24 rotations of the cube, on the vertices
/// and as poses, at scales of 2^-40 to 2^40, and by every rule and layout. The coordinates must
/// stay exact.
void expect_rays_as_brute_force(const Mesh& mesh, const std::vector<Ray>& rays);

}  // namespace soms::test
