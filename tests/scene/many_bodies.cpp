#include "tests/scene/many_bodies.h"

#include "tests/scene/random_bodies.h"

#include <cmath>

namespace soms::test {

namespace {

enum class Spread : std::uint8_t { scattered, crowded, copies, lattice, far, scales };

Mesh mesh_of(Spread spread, Rng& rng) {
  Mesh mesh = random_mesh(rng);
  if (spread == Spread::scales) {
    const double scale = std::ldexp(1.0, static_cast<int>(rng.below(40)) - 20);
    for (Vec3& v : mesh.vertices) {
      v = v * scale;
    }
  }
  return mesh;
}

Pose pose_of(Spread spread, Rng& rng) {
  switch (spread) {
    case Spread::copies:
      return {};
    case Spread::crowded:
      return random_pose(rng, 3);
    case Spread::lattice:
      return Pose::translation(8.0 * static_cast<double>(rng.below(4)),
                               8.0 * static_cast<double>(rng.below(4)), 0);
    case Spread::far: {
      Pose pose = random_pose(rng, 20);
      pose.m[3] += 0x1p40;
      return pose;
    }
    default:
      return random_pose(rng, 40);
  }
}

Vec3 anywhere(Rng& rng, double reach) {
  return {rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
}

}  // namespace

std::vector<Body> many_bodies(Rng& rng) {
  const auto spread = static_cast<Spread>(rng.below(6));
  const Mesh shared = mesh_of(spread, rng);
  const std::uint64_t count = rng.below(41);
  std::vector<Body> bodies;
  for (std::uint64_t k = 0; k < count; ++k) {
    const bool alike = spread == Spread::copies || spread == Spread::lattice;
    Mesh mesh = alike && rng.below(4) != 0 ? shared : mesh_of(spread, rng);
    if (rng.below(8) == 0) {
      mesh = {};
    }
    const Layout layout = rng.below(2) == 0 ? Layout::wide : Layout::compact;
    bodies.emplace_back(Shape(std::move(mesh), {.layout = layout}), pose_of(spread, rng));
  }
  return bodies;
}

Vec3 point_among(const std::vector<Body>& bodies, Rng& rng) {
  if (bodies.empty() || rng.below(4) == 0) {
    return anywhere(rng, rng.below(4) == 0 ? 1e9 : 30);
  }
  const Body& body = bodies[rng.below(bodies.size())];
  const MeshView& mesh = body.shape.mesh();
  if (mesh.triangles.empty() || rng.below(4) == 0) {
    Vec3 near = body.pose.shift() + anywhere(rng, 4);
    return rng.below(2) == 0 ? near
                             : Vec3{std::floor(near.x), std::floor(near.y), std::floor(near.z)};
  }
  const Triangle t = mesh.triangle(static_cast<TriangleId>(rng.below(mesh.triangles.size())));
  return body.pose.apply(rng.below(2) == 0 ? t.a : (t.a + t.b) * 0.5);
}

Ray ray_among(const std::vector<Body>& bodies, Rng& rng) {
  Ray ray{point_among(bodies, rng), {}};
  ray.direction = point_among(bodies, rng) - ray.origin;
  if (rng.below(4) == 0 || ray.direction == Vec3{}) {
    ray.direction = {};
    ray.direction[rng.below(3)] = rng.below(2) == 0 ? 1 : -0.25;
  }
  if (rng.below(3) == 0) {
    ray.direction = ray.direction * std::ldexp(1.0, static_cast<int>(rng.below(200)) - 100);
  }
  if (rng.below(3) == 0) {
    ray.length = rng.below(2) == 0 ? 1 : rng.uniform(0, 3);
  }
  return ray;
}

}  // namespace soms::test
