// Cities that stand somewhere, from files, and a mover on their streets.
#include "soms/io/read_mesh.h"
#include "soms/query/overlap.h"

#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <limits>

namespace soms::bench {

namespace {

Box city_bounds(const Mesh& mesh) {
  Box box;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    box.grow(bounds(mesh.triangle(i)));
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

double lowest_surface(const Mesh& mesh, double x, double y, double otherwise) {
  double lowest = std::numeric_limits<double>::infinity();
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    lowest = std::min(lowest, height_at(mesh.triangle(i), x, y));
  }
  return std::isfinite(lowest) ? lowest : otherwise;
}

/// How far the mover can go along `direction` until it touches, or nothing below 0 if it does not
/// within 40 m or touches from the start.
double distance_to_touch(Body& mover, const Body& city, const Pose& start, const Vec3& direction) {
  const auto touches = [&](double s) {
    mover.pose = Pose::translation(s * direction.x, s * direction.y, s * direction.z);
    for (std::size_t i = 0; i < 12; ++i) {
      mover.pose.m[i] = i % 4 == 3 ? start.m[i] + mover.pose.m[i] : start.m[i];
    }
    return overlap(mover, city, {.mode = OverlapMode::any}).any;
  };
  double free = 0;
  double touching = 0;
  while (!touches(touching)) {
    free = touching;
    touching += 0.5;
    if (touching > 40) {
      return -1;
    }
  }
  while (touching - free > 1e-4) {
    const double middle = 0.5 * (free + touching);
    (touches(middle) ? touching : free) = middle;
  }
  return touching > 0 ? free : -1;
}

Pose onward(const Pose& start, const Vec3& direction, double distance) {
  Pose pose = start;
  pose.m[3] += distance * direction.x;
  pose.m[7] += distance * direction.y;
  pose.m[11] += distance * direction.z;
  return pose;
}

std::vector<Pose> on_streets(const Mesh& city, const Box& ground, double wheels) {
  std::vector<Pose> poses;
  Rng rng(31);
  for (std::size_t i = 0; i < kPoses; ++i) {
    const double x = rng.uniform(ground.lower.x, ground.upper.x);
    const double y = rng.uniform(ground.lower.y, ground.upper.y);
    const double z = lowest_surface(city, x, y, ground.lower.z);
    poses.push_back(Pose::about_z(rng.uniform(0, 2 * kPi), {x, y, z - wheels + 0.1}));
  }
  return poses;
}

}  // namespace

FloatMesh float_mesh(const Mesh& mesh, const Vec3& middle, double scale) {
  FloatMesh result;
  for (const Vec3& v : mesh.vertices) {
    result.vertices.push_back(narrow(scale * (v - middle)));
  }
  result.triangles = mesh.triangles;
  return result;
}

Scene real_city_scene(const std::string& name, const std::filesystem::path& city,
                      const std::filesystem::path& mover) {
  const Mesh whole = read_mesh(city);
  const FloatMesh fixed = float_mesh(whole, city_bounds(whole).center());
  const FloatMesh moving = float_mesh(read_mesh(mover), {});
  const Body town(widened(fixed));
  Body car(widened(moving));
  const double wheels = city_bounds(car.shape.mesh()).lower.z;
  Scene scene{
      name,
      moving,
      fixed,
      {{"street", on_streets(town.shape.mesh(), city_bounds(town.shape.mesh()), wheels), kNear},
       {"grazing", {}},
       {"near", {}, kNear}}};
  Rng rng(32);
  for (std::size_t k = 0; k < 20 * kPoses && scene.sets[1].poses.size() < kPoses; ++k) {
    const Pose& start = scene.sets[0].poses[k % kPoses];
    const double a = rng.uniform(0, 2 * kPi);
    const Vec3 ahead{std::cos(a), std::sin(a), 0};
    const double distance = distance_to_touch(car, town, start, ahead);
    const double into = rng.uniform(0.001, 0.05);
    if (distance > 0.01) {
      scene.sets[1].poses.push_back(onward(start, ahead, distance + into));
      scene.sets[2].poses.push_back(onward(start, ahead, distance - 0.01));
    }
  }
  return scene;
}

}  // namespace soms::bench
