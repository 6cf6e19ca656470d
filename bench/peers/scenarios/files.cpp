#include "soms/io/read_mesh.h"

#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <limits>

namespace soms::bench {

namespace {

FloatMesh read(const std::string& path) {
  const Mesh mesh = read_mesh(path);
  FloatMesh narrow_mesh;
  for (const Vec3& v : mesh.vertices) {
    narrow_mesh.vertices.push_back(narrow(v));
  }
  narrow_mesh.triangles = mesh.triangles;
  return narrow_mesh;
}

Box bounds_of(const FloatMesh& mesh) {
  Box box;
  for (const auto& v : mesh.vertices) {
    box.grow(wide(v));
  }
  return box;
}

/// Height of a triangle over (x, y), or infinity where it does not cover that point.
double height_at(const Triangle& t, double x, double y) {
  const Vec3 u = t.b - t.a;
  const Vec3 v = t.c - t.a;
  const double area = u.x * v.y - u.y * v.x;
  const double s = ((x - t.a.x) * v.y - (y - t.a.y) * v.x) / area;
  const double r = (u.x * (y - t.a.y) - u.y * (x - t.a.x)) / area;
  const bool covers = area != 0 && s >= 0 && r >= 0 && s + r <= 1;
  return covers ? t.a.z + s * u.z + r * v.z : std::numeric_limits<double>::infinity();
}

double lowest_surface(const FloatMesh& mesh, double x, double y, double otherwise) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    const Triangle corners{wide(mesh.vertices[t[0]]), wide(mesh.vertices[t[1]]),
                           wide(mesh.vertices[t[2]])};
    lowest = std::min(lowest, height_at(corners, x, y));
  }
  return std::isfinite(lowest) ? lowest : otherwise;
}

}  // namespace

Scene file_scene(const std::string& city, const std::string& mover) {
  Scene scene{"files", read(mover), read(city), {{"street-level", {}}}};
  const Box ground = bounds_of(scene.fixed);
  const Box body = bounds_of(scene.mover);
  Rng rng(31);
  for (std::size_t i = 0; i < kPoses; ++i) {
    const double x = rng.uniform(ground.lower.x, ground.upper.x);
    const double y = rng.uniform(ground.lower.y, ground.upper.y);
    const double z = lowest_surface(scene.fixed, x, y, ground.lower.z);
    scene.sets[0].poses.push_back(
        Pose::about_z(rng.uniform(0, 2 * kPi), {x, y, z - body.lower.z + 0.1}));
  }
  return scene;
}

}  // namespace soms::bench
