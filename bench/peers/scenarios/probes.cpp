// Points and rays at one body.
#include "soms/io/read_mesh.h"

#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <utility>

namespace soms::bench {

namespace {

constexpr std::size_t kProbes = 20'000;

Vec3 rounded(const Vec3& v) {
  return wide(narrow(v));
}

Box bounds_of_mesh(const FloatMesh& mesh) {
  Box box;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    box.grow(bounds(mesh.triangle(i)));
  }
  return box;
}

std::vector<Vec3> random_points(const Box& box, Rng rng) {
  const Vec3 rim = 0.1 * box.extent();
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < kProbes; ++i) {
    const double x = rng.uniform(box.lower.x - rim.x, box.upper.x + rim.x);
    const double y = rng.uniform(box.lower.y - rim.y, box.upper.y + rim.y);
    points.push_back(rounded({x, y, rng.uniform(box.lower.z - rim.z, box.upper.z + rim.z)}));
  }
  return points;
}

std::vector<Vec3> near_points(const FloatMesh& mesh, double size, Rng rng) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < kProbes; ++i) {
    const Triangle t = mesh.triangle(rng.below(mesh.triangles.size()));
    double u = rng.unit();
    double v = rng.unit();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Vec3 foot = t.a + u * (t.b - t.a) + v * (t.c - t.a);
    points.push_back(rounded(foot + rng.uniform(0, 1e-3) * size * random_direction(rng)));
  }
  return points;
}

/// A curve that goes all over the box without an end.
std::vector<Vec3> path_points(const Box& box) {
  const Vec3 half = 0.5 * box.extent();
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < kProbes; ++i) {
    const double s = 0.002 * static_cast<double>(i);
    points.push_back(
        rounded(box.center() + Vec3{half.x * std::sin(s), half.y * std::sin(1.3 * s + 1),
                                    half.z * std::sin(1.7 * s + 2)}));
  }
  return points;
}

std::vector<ProbeRay> random_rays(const std::vector<Vec3>& origins, Rng rng) {
  std::vector<ProbeRay> rays;
  for (const Vec3& origin : origins) {
    rays.push_back({origin, rounded(random_direction(rng))});
  }
  return rays;
}

/// From a corner of the space around the box, line by line.
std::vector<ProbeRay> camera_rays(const Box& box) {
  constexpr std::size_t kWidth = 160;
  constexpr std::size_t kHeight = kProbes / kWidth;
  const Vec3 extent = box.extent();
  const double size = std::sqrt(dot(extent, extent));
  const Vec3 eye = rounded(box.center() + Vec3{0.5 * extent.x, 0.6 * extent.y, 0.3 * size});
  const Vec3 ahead = unit(box.center() - eye);
  const Vec3 right = unit(cross(ahead, {0, 0, 1}));
  const Vec3 down = cross(ahead, right);
  std::vector<ProbeRay> rays;
  for (std::size_t i = 0; i < kHeight; ++i) {
    for (std::size_t j = 0; j < kWidth; ++j) {
      const double x = (static_cast<double>(j) + 0.5) / kWidth - 0.5;
      const double y = ((static_cast<double>(i) + 0.5) / kHeight - 0.5) * kHeight / kWidth;
      rays.push_back({eye, rounded(ahead + x * right + y * down)});
    }
  }
  return rays;
}

Scene probes(std::string name, FloatMesh mesh, bool closed, std::uint64_t seed) {
  const Box box = bounds_of_mesh(mesh);
  const Vec3 extent = box.extent();
  std::vector<Job> of_points{Job::closest};
  if (closed) {
    of_points.push_back(Job::contains);
  }
  const std::vector<Job> of_rays{Job::closest_hit, Job::any_hit};
  Scene scene{std::move(name), {}, std::move(mesh), {}};
  const std::vector<Vec3> anywhere = random_points(box, rng_of(61, seed));
  scene.probe_sets = {{"random", anywhere, {}, of_points},
                      {"near",
                       near_points(scene.fixed, std::sqrt(dot(extent, extent)), rng_of(62, seed)),
                       {},
                       of_points},
                      {"path", path_points(box), {}, of_points},
                      {"rays", {}, random_rays(anywhere, rng_of(63, seed)), of_rays},
                      {"camera", {}, camera_rays(box), of_rays}};
  return scene;
}

}  // namespace

Scene knot_probes(std::uint64_t triangles, std::uint64_t seed) {
  return probes("probe-knot", referee_knot(triangles), true, seed);
}

Scene city_probes(std::uint64_t triangles, std::uint64_t seed) {
  return probes("probe-city", referee_city(triangles), false, seed);
}

Scene model_probes(const std::filesystem::path& file, std::uint64_t seed) {
  return probes("probe-" + file.stem().string(), unit_model(file), true, seed);
}

FloatMesh unit_model(const std::filesystem::path& file) {
  const Mesh mesh = read_mesh(file);
  Box box;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    box.grow(bounds(mesh.triangle(i)));
  }
  double radius = 0;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    for (const Vec3& v : {t.a, t.b, t.c}) {
      const Vec3 d = v - box.center();
      radius = std::max(radius, std::sqrt(dot(d, d)));
    }
  }
  return float_mesh(mesh, box.center(), 1 / radius);
}

}  // namespace soms::bench
