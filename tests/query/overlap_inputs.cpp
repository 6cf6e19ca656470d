#include "tests/query/overlap_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace soms::test {

namespace {

Vec3 point(Rng& rng) {
  return {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
}

void add(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

Vec3 on_ball(int i, int j, int n) {
  const double pi = 3.14159265358979;
  const double theta = pi * i / n;
  const double phi = 2 * pi * (j % n) / n;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Mesh ball(int triangles) {
  Mesh mesh;
  const int n = std::max(3, static_cast<int>(std::sqrt(triangles / 2.0)));
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      add(mesh, on_ball(i, j, n), on_ball(i + 1, j, n), on_ball(i + 1, j + 1, n));
      add(mesh, on_ball(i, j, n), on_ball(i + 1, j + 1, n), on_ball(i, j + 1, n));
    }
  }
  return mesh;
}

/// Triangles around random points, each `size` across; `flatten` drops the last coordinates.
Mesh soup(Rng& rng, int triangles, double size, int flatten) {
  Mesh mesh;
  const auto flat = [&](Vec3 v) {
    for (int i = 0; i < flatten; ++i) {
      v[static_cast<std::size_t>(2 - i)] = 0.25;
    }
    return v;
  };
  for (int i = 0; i < triangles; ++i) {
    const Vec3 p = point(rng);
    add(mesh, flat(p), flat(p + size * point(rng)), flat(p + size * point(rng)));
  }
  return mesh;
}

Mesh lattice(Rng& rng, int triangles) {
  Mesh mesh;
  const auto corner = [&] {
    return Vec3{static_cast<double>(rng.below(5)), static_cast<double>(rng.below(5)),
                static_cast<double>(rng.below(5))};
  };
  for (int i = 0; i < triangles; ++i) {
    const Vec3 a = corner();
    const Vec3 b = corner();
    add(mesh, a, b, corner());
  }
  return mesh;
}

}  // namespace

Mesh awkward_mesh(Rng& rng, int most) {
  const int n = 1 + static_cast<int>(rng.below(static_cast<std::uint64_t>(most)));
  switch (rng.below(9)) {
    case 0:
      return ball(n);
    case 1:
      return soup(rng, n, 1, 1);
    case 2:
      return soup(rng, n, 0.5, 2);
    case 3:
      return soup(rng, std::min(n, 20), 1, 3);
    case 4: {
      Mesh mesh = soup(rng, 1, 1, 0);
      mesh.triangles.resize(static_cast<std::size_t>(std::min(n, 60)), mesh.triangles.front());
      return mesh;
    }
    case 5: {
      Mesh mesh = soup(rng, n, 1, 0);
      for (Vec3& v : mesh.vertices) {
        v.y *= 1e-9;
      }
      return mesh;
    }
    case 6:
      return lattice(rng, n);
    case 7: {
      Mesh mesh = soup(rng, n, 0.1, 0);
      for (Vec3& v : mesh.vertices) {
        v = v * std::exp2(-rng.uniform(0, 40));
      }
      return mesh;
    }
    default:
      return soup(rng, n, rng.uniform(0.05, 1), 0);
  }
}

Mesh placed(Mesh mesh, double scale, const Vec3& shift) {
  for (Vec3& v : mesh.vertices) {
    v = v * scale + shift;
  }
  return mesh;
}

Mesh coned(Mesh mesh, const Vec3& apex) {
  const auto top = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(apex);
  const std::size_t count = mesh.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    mesh.triangles.insert(mesh.triangles.end(), {{b, a, top}, {c, b, top}, {a, c, top}});
  }
  return mesh;
}

Pose awkward_rotation(Rng& rng) {
  Pose pose;
  const auto kind = rng.below(4);
  if (kind == 0) {
    return pose;
  }
  if (kind == 1) {
    pose.m = {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0};
    return pose;
  }
  std::array<double, 4> q = {};
  double norm = 0;
  do {
    norm = 0;
    for (double& x : q) {
      x = rng.uniform(-1, 1);
      norm += x * x;
    }
  } while (norm > 1 || norm < 0.01);
  for (double& x : q) {
    x /= std::sqrt(norm);
  }
  pose = Pose::from_quaternion(q[0], q[1], q[2], q[3]);
  if (kind == 3) {
    // Columns stretched or sheared: RtR - I stays within the 1e-6 that poses may be off.
    const double off = rng.uniform(-0.44e-6, 0.44e-6);
    const double shear = rng.uniform(-0.4e-6, 0.4e-6);
    for (std::size_t row = 0; row < 3; ++row) {
      const double first = pose.m[4 * row];
      for (std::size_t column = 0; column < 3; ++column) {
        pose.m[4 * row + column] *= 1 + off;
      }
      pose.m[4 * row + 1] += shear * first;
    }
  }
  return pose;
}

Pose moving(const Pose& rotation, const Vec3& p, const Vec3& q) {
  const Vec3 moved = rotation.apply(p);
  Pose pose = rotation;
  pose.m[3] = q.x - moved.x;
  pose.m[7] = q.y - moved.y;
  pose.m[11] = q.z - moved.z;
  return pose;
}

BuildOptions awkward_options(Rng& rng) {
  static constexpr std::array<int, 4> kLeaves{1, 4, 8, 1000};
  static constexpr std::array<Rule, 9> kRules{
      Rule::object_median, Rule::object_mean, Rule::spatial_median, Rule::soms, Rule::sah,
      Rule::soms_sah,      Rule::fast,        Rule::quality,        Rule::quick};
  BuildOptions options;
  if (rng.below(8) == 0) {
    options = thesis_options(kRules[rng.below(kRules.size())]);
  }
  options.rule = kRules[rng.below(kRules.size())];
  options.per_leaf = kLeaves[rng.below(kLeaves.size())];
  options.empty_side = static_cast<EmptySide>(rng.below(3));
  return without_idle(options);
}

Two likely_to_meet(Rng& rng, int most, double scale_a, double scale_b, double far) {
  const Vec3 place = {far, -0.5 * far, 0.25 * far};
  const Vec3 zero = {};
  const Mesh a = placed(awkward_mesh(rng, most), scale_a, rng.below(2) ? place : zero);
  const Mesh b = placed(awkward_mesh(rng, most), scale_b, rng.below(2) ? place : zero);
  Pose pose_b = awkward_rotation(rng);
  pose_b.m[3] = rng.below(2) ? 0 : far * rng.unit();
  Vec3 meet = pose_b.apply(b.vertices[rng.below(b.vertices.size())]);
  if (rng.below(2)) {
    meet += Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)} *
            (0.5 * std::min(scale_a, scale_b));
  }
  const Pose pose_a = moving(awkward_rotation(rng), a.vertices[rng.below(a.vertices.size())], meet);
  return {Body(Shape(a, {awkward_options(rng)}), pose_a),
          Body(Shape(b, {awkward_options(rng)}), pose_b)};
}

Vec3 point_in(Rng& rng, const Box& box) {
  return {rng.uniform(box.lower.x, box.upper.x), rng.uniform(box.lower.y, box.upper.y),
          rng.uniform(box.lower.z, box.upper.z)};
}

}  // namespace soms::test
