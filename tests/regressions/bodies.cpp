#include "tests/regressions/bodies.h"

#include "tests/support/bodies.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace soms::test {

const Mesh& unit_box() {
  static const Mesh box = box_body({0, 0, 0}, {1, 1, 1});
  return box;
}

Mesh rod_body() {
  constexpr int kSides = 16;
  std::vector<Triangle> triangles;
  const auto rim = [](int i, double y) {
    const double angle = 2 * 3.141592653589793 * (i % kSides) / kSides;
    return Vec3{0.2 * std::cos(angle), y, 0.5 + 0.2 * std::sin(angle)};
  };
  for (int i = 0; i < kSides; ++i) {
    triangles.push_back({rim(i, 0.1), rim(i, 1.9), rim(i + 1, 1.9)});
    triangles.push_back({rim(i, 0.1), rim(i + 1, 1.9), rim(i + 1, 0.1)});
    triangles.push_back({{0, 0.1, 0.5}, rim(i, 0.1), rim(i + 1, 0.1)});
    triangles.push_back({{0, 1.9, 0.5}, rim(i + 1, 1.9), rim(i, 1.9)});
  }
  return soup_body(triangles);
}

Mesh channel_body() {
  return joined(joined(box_body({-0.6, 0, 0}, {-0.5, 2, 1}), box_body({0.5, 0, 0}, {0.6, 2, 1})),
                box_body({-0.6, 0, -0.1}, {0.6, 2, 0}));
}

Mesh cylinder_body(double radius, int sides) {
  std::vector<Triangle> triangles;
  const auto rim = [&](int i, double z) {
    const double angle = 2 * 3.141592653589793 * (i % sides) / sides;
    return Vec3{radius * std::cos(angle), radius * std::sin(angle), z};
  };
  for (int i = 0; i < sides; ++i) {
    triangles.push_back({rim(i, -1), rim(i + 1, -1), rim(i + 1, 1)});
    triangles.push_back({rim(i, -1), rim(i + 1, 1), rim(i, 1)});
    triangles.push_back({{0, 0, 1}, rim(i, 1), rim(i + 1, 1)});
    triangles.push_back({{0, 0, -1}, rim(i + 1, -1), rim(i, -1)});
  }
  return soup_body(triangles);
}

Vec3 even_direction(Rng& rng) {
  while (true) {
    const Vec3 v{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const double square = dot(v, v);
    if (square > 1e-3 && square < 1) {
      return v * (1 / std::sqrt(square));
    }
  }
}

Pose deep_pose(Rng& rng) {
  while (true) {
    const std::array q{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1),
                       rng.uniform(-1, 1)};
    const Vec3 shift{rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4)};
    const double n = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (n > 0.1 && n < 1 && dot(shift, shift) < 0.16) {
      return Pose::from_quaternion(q[0] / n, q[1] / n, q[2] / n, q[3] / n, shift);
    }
  }
}

KissingCube kissing_cube(Rng& rng) {
  KissingCube kiss{box_body({0, 0, 0}, {0.25, 0.25, 0.25}),
                   box_body({-0.125, -0.125, -0.125}, {0.125, 0.125, 0.125}), deep_pose(rng)};
  Pose& pose = kiss.pose;
  pose.m[3] = pose.m[7] = pose.m[11] = 0.125;
  // The corner furthest back meets the middle of the wall's face x = 0.25.
  Vec3 tip = pose.apply(kiss.cube.vertices[0]);
  for (const Vec3& v : kiss.cube.vertices) {
    const Vec3 moved = pose.apply(v);
    tip = moved.x < tip.x ? moved : tip;
  }
  pose.m[3] += 0.25 - tip.x;
  pose.m[7] += 0.125 - tip.y;
  pose.m[11] += 0.125 - tip.z;
  return kiss;
}

std::pair<Triangle, Triangle> triangles_of_r05() {
  return {{{32.22699737548828, 1.2630000114440918, -11.8149995803833},
           {31.316997528076172, 1.2630000114440918, -11.739999771118164},
           {32.22699737548828, 1.2630000114440918, -11.739999771118164}},
          {{31.316997528076172, 1.933000087738037, -7.585000038146973},
           {31.316997528076172, -0.8669999837875366, -7.295000076293945},
           {31.316997528076172, -0.8669999837875366, -7.585000038146973}}};
}

std::array<Triangle, 6> corner_orders(const Triangle& t) {
  return {{{t.a, t.b, t.c},
           {t.b, t.c, t.a},
           {t.c, t.a, t.b},
           {t.a, t.c, t.b},
           {t.c, t.b, t.a},
           {t.b, t.a, t.c}}};
}

}  // namespace soms::test
