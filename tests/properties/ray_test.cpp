// Relations that hold between rays and bodies, whatever they are.
#include "soms/query/ray.h"

#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/query/reference/ray.h"

#include "tests/properties/meshes.h"
#include "tests/properties/property.h"
#include "tests/query/overlap_inputs.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace soms {
namespace {

using test::check_property;

constexpr double kFarthest = std::numeric_limits<double>::max();

/// Triangles on a lattice, degenerate ones too, or a round body; of any size and anywhere.
Mesh mesh_for_rays(Rng& rng) {
  Mesh mesh;
  if (rng.below(3) == 0) {
    mesh = generate_sphere(20 + 2 * rng.below(100));
  } else {
    const bool on_lattice = rng.below(2) == 0;
    const auto coordinate = [&] {
      return on_lattice ? static_cast<double>(rng.below(4)) : rng.uniform(0, 4);
    };
    for (std::uint64_t k = 0, count = 3 + rng.below(10); k < count; ++k) {
      mesh.vertices.push_back({coordinate(), coordinate(), coordinate()});
    }
    const auto corner = [&] { return static_cast<std::uint32_t>(rng.below(mesh.vertices.size())); };
    for (std::uint64_t k = 0, count = 1 + rng.below(40); k < count; ++k) {
      mesh.triangles.push_back({corner(), corner(), corner()});
    }
  }
  const double scale = rng.below(2) == 0 ? 1 : std::exp2(std::floor(rng.uniform(-80, 80)));
  const double far = rng.below(2) == 0 ? 0 : scale * std::exp2(rng.uniform(0, 20));
  return test::placed(
      mesh, scale, {far * rng.uniform(-1, 1), far * rng.uniform(-1, 1), far * rng.uniform(-1, 1)});
}

Pose pose_for_rays(Rng& rng, const Mesh& mesh) {
  Pose pose = rng.below(3) == 0 ? Pose{} : test::awkward_rotation(rng);
  const Vec3 extent = bounds(mesh).extent();
  const double size = std::max({extent.x, extent.y, extent.z});
  const double far = rng.below(2) == 0 ? 0 : size * std::exp2(rng.uniform(-4, 40));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    pose.m[4 * axis + 3] = far * rng.uniform(-1, 1);
  }
  return pose;
}

/// A point of the surface as near as doubles allow: of a corner, an edge or a face.
Vec3 surface_point(Rng& rng, const Body& body) {
  const MeshView& mesh = body.shape.mesh();
  const auto& t = mesh.triangles[rng.below(mesh.triangles.size())];
  const Vec3 a = body.pose.apply(mesh.vertices[t[0]]);
  const Vec3 b = body.pose.apply(mesh.vertices[t[1]]);
  const Vec3 c = body.pose.apply(mesh.vertices[t[2]]);
  const std::uint64_t kind = rng.below(3);
  const double u = rng.below(2) == 0 ? 0.5 : rng.uniform(0, 1);
  return kind == 0 ? a : kind == 1 ? a + (b - a) * u : (a + (b - a) * 0.5) + (c - a) * (u * 0.5);
}

/// A ray at the surface, along it, beside it by a step, from it, or along an axis; from near or
/// far.
Ray any_ray(Rng& rng, const Body& body) {
  const Vec3 to = surface_point(rng, body);
  Vec3 from = surface_point(rng, body);
  const Vec3 extent = body.shape.bounds().extent();
  const double size = std::max({extent.x, extent.y, extent.z, 0x1p-90});
  const std::uint64_t kind = rng.below(6);
  if (kind < 2) {
    const double far = size * std::exp2(rng.uniform(-3, kind == 0 ? 2 : 50));
    from = {to.x + far * rng.uniform(-1, 1), to.y + far * rng.uniform(-1, 1),
            to.z + far * rng.uniform(-1, 1)};
  } else if (kind == 2) {
    from = to;
    from[rng.below(3)] += size * rng.uniform(-4, 4);
  }
  Ray ray{from, to - from};
  const std::uint64_t change = rng.below(5);
  const std::size_t axis = rng.below(3);
  if (change == 0) {
    ray.origin[axis] = std::nextafter(ray.origin[axis], rng.below(2) == 0 ? kFarthest : -kFarthest);
  } else if (change == 1) {
    ray.direction[axis] = rng.below(2) == 0 ? 0.0 : -0.0;
  } else if (change == 2) {
    ray.direction = ray.direction * std::exp2(std::floor(rng.uniform(-700, 700)));
  }
  if (ray.direction == Vec3{}) {
    ray.direction[axis] = size;
  }
  const std::array<double, 5> lengths{0, 0.5, 1, std::nextafter(1, 0), kFarthest};
  const std::uint64_t length = rng.below(10);
  if (length < lengths.size()) {
    ray.length = lengths[length];
  }
  return ray;
}

Ray any_segment(Rng& rng, const Body& body) {
  const Vec3 from = any_ray(rng, body).origin;
  return Ray::between(from, rng.below(8) == 0 ? from : surface_point(rng, body));
}

Body any_body(Rng& rng) {
  const Mesh mesh = mesh_for_rays(rng);
  const ShapeOptions options{.build = test::awkward_options(rng),
                             .layout = rng.below(3) == 0 ? Layout::compact : Layout::wide};
  return Body(Shape(mesh, options), pose_for_rays(rng, mesh));
}

/// All questions about one ray or segment, alone, against brute force.
bool is_as_brute_force(const Body& body, const Ray& line, std::optional<TriangleId> skip) {
  const RayOptions options{.skip = skip};
  ClosestHit closest = closest_hit(body, line, options);
  AllHits all = all_hits(body, std::span(&line, 1), options);
  ClosestHit twin = reference::closest_hit_by_brute_force(body, line, skip);
  AllHits all_twin = reference::all_hits_by_brute_force(body, line, skip);
  twin.cost = closest.cost;
  all_twin.cost = all.cost;
  all_twin.costs = all.costs;
  return closest == twin && all == all_twin &&
         any_hit(body, line, options).hit == twin.triangle.has_value();
}

TEST(RayProperty, AnswersAsBruteForce) {
  std::array<std::size_t, 2> hits = {};
  check_property("ray/twin", [&](std::uint64_t seed) {
    Rng rng(seed);
    const Body body = any_body(rng);
    const auto count = body.shape.mesh().triangles.size();
    for (int i = 0; i < 12; ++i) {
      std::optional<TriangleId> skip;
      if (rng.below(4) == 0) {
        skip = static_cast<TriangleId>(rng.below(count));
      }
      const Ray ray = any_ray(rng, body);
      RC_ASSERT(is_as_brute_force(body, ray, skip));
      RC_ASSERT(is_as_brute_force(body, any_segment(rng, body), skip));
      ++hits[closest_hit(body, ray).triangle ? 1 : 0];
    }
  });
  EXPECT_GT(hits[0], 300U);
  EXPECT_GT(hits[1], 1000U);
}

TEST(RayProperty, BatchesAnswerAsSingleRays) {
  check_property("ray/batch", [](std::uint64_t seed) {
    Rng rng(seed);
    const Body body = any_body(rng);
    std::vector<Ray> rays;
    std::vector<Ray> segments;
    for (std::uint64_t i = 0, count = rng.below(50); i < count; ++i) {
      rays.push_back(any_ray(rng, body));
      segments.push_back(any_segment(rng, body));
    }
    const ClosestHitBatch closest = closest_hit(body, rays);
    const AnyHitBatch any = any_hit(body, segments);
    RC_ASSERT(closest_hit(body, rays, {}, {.threads = 2}) == closest);
    RC_ASSERT(any_hit(body, segments, {}, {.threads = 2}) == any);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RC_ASSERT(closest_hit(body, rays[i]) == closest.at(i));
      RC_ASSERT(any_hit(body, segments[i]) == any.at(i));
    }
  });
}

// The reverse of a segment meets the same triangles.
TEST(RayProperty, OfAReversedSegmentMeetsTheSame) {
  check_property("ray/reverse", [](std::uint64_t seed) {
    Rng rng(seed);
    const Body body = any_body(rng);
    for (int i = 0; i < 8; ++i) {
      const Ray there = any_segment(rng, body);
      const Ray back = Ray::between(*there.end, there.origin);
      std::vector<TriangleId> first = all_hits(body, std::span(&there, 1)).triangle;
      std::vector<TriangleId> second = all_hits(body, std::span(&back, 1)).triangle;
      std::sort(first.begin(), first.end());
      std::sort(second.begin(), second.end());
      RC_ASSERT(first == second);
      RC_ASSERT(sees(body, there.origin, *there.end) == first.empty());
    }
  });
}

// A ray from outside enters a closed body as often as it leaves it, whatever it grazes.
TEST(RayProperty, EntersAClosedBodyAsOftenAsItLeaves) {
  check_property("ray/parity", [](std::uint64_t seed) {
    Rng rng(seed);
    const Body body(generate_sphere(20 + 2 * rng.below(100)), test::awkward_rotation(rng));
    for (int i = 0; i < 10; ++i) {
      Ray ray = any_ray(rng, body);
      ray.length = std::numeric_limits<double>::infinity();
      ray.origin =
          surface_point(rng, body) -
          ray.direction * (8 / std::max({std::abs(ray.direction.x), std::abs(ray.direction.y),
                                         std::abs(ray.direction.z)}));
      const AllHits all = all_hits(body, std::span(&ray, 1));
      RC_ASSERT(std::count(all.kind.begin(), all.kind.end(), CrossingKind::enter) ==
                std::count(all.kind.begin(), all.kind.end(), CrossingKind::leave));
    }
  });
}

}  // namespace
}  // namespace soms
