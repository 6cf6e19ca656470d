#include "tests/properties/meshes.h"

#include "soms/generate/shapes.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/bodies.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace soms::test {

namespace {

Mesh soup(Rng& rng, int count, double size) {
  std::vector<Triangle> triangles;
  const auto point = [&](double reach) {
    return Vec3{rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
  };
  for (int i = 0; i < count; ++i) {
    const Vec3 at = point(1);
    triangles.push_back({at, at + point(size), at + point(size)});
  }
  return soup_body(triangles);
}

}  // namespace

rc::Gen<Corners> lattice_corners() {
  return rc::gen::container<Corners>(rc::gen::inRange<std::uint16_t>(0, 729));
}

Mesh lattice_mesh(const Corners& corners, double unit) {
  std::vector<Triangle> triangles;
  const auto at = [&](std::size_t i) {
    const int n = corners[i];
    const int column = n / 9 % 9;
    const int layer = n / 81;
    return unit * Vec3{static_cast<double>(n % 9), static_cast<double>(column),
                       static_cast<double>(layer)};
  };
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    triangles.push_back({at(i), at(i + 1), at(i + 2)});
  }
  return soup_body(triangles);
}

Pose any_pose(Rng& rng, double reach) {
  double q[4];
  double n = 0;
  while (n < 0.1) {
    for (double& x : q) {
      x = rng.uniform(-1, 1);
    }
    n = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  }
  return Pose::from_quaternion(
      q[0] / n, q[1] / n, q[2] / n, q[3] / n,
      {rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)});
}

TwoMeshes meshes_of_kind(int kind, Rng& rng) {
  const int most = static_cast<int>(rng.below(40));
  const Mesh a = soup(rng, most + 1, 0.5);
  const Mesh b = soup(rng, static_cast<int>(rng.below(40)), 0.3);
  const Mesh cube = box_body({-1, -1, -1}, {1, 1, 1}, 3);
  const auto flatten = [](const Vec3& v) { return Vec3{v.x, v.y, 0.25}; };
  const auto shrink = [](const Vec3& v) { return v * 0x1p-70; };
  const auto send = [](const Vec3& v) { return v + Vec3{4e5, -5.5e6, 1e8}; };
  const auto line = [](const Vec3& v) { return Vec3{v.x, v.x, 0.5}; };
  switch (kind) {
    case 0:
      return {a, b};
    case 1:
      return {cube, mapped(cube, [](const Vec3& v) { return v + Vec3{2, 0.5, 0}; })};
    case 2:
      return {cube, mapped(cube, [](const Vec3& v) { return 0.75 * v; })};
    case 3:
      return {mapped(a, flatten), mapped(b, flatten)};
    case 4:
      return {mapped(a, shrink), mapped(b, shrink)};
    case 5:
      return {mapped(a, send), mapped(b, send)};
    case 6:
      return {mapped(a, line), mapped(b, line)};
    default:
      return {a, mapped(a, line)};
  }
}

Mesh closed_mesh(Rng& rng, std::uint64_t most) {
  const bool on_lattice = rng.below(2) == 0;
  const auto coordinate = [&] {
    return on_lattice ? static_cast<double>(rng.below(5)) : rng.uniform(0, 4);
  };
  Mesh mesh;
  for (std::uint64_t k = 0, count = 1 + rng.below(most); k < count; ++k) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int corner = 0; corner < 4; ++corner) {
      mesh.vertices.push_back({coordinate(), coordinate(), coordinate()});
    }
    mesh.triangles.insert(mesh.triangles.end(), {{first, first + 1, first + 2},
                                                 {first, first + 1, first + 3},
                                                 {first + 3, first + 1, first + 2},
                                                 {first, first + 3, first + 2}});
  }
  if (rng.below(3) == 0) {
    mesh.triangles.push_back({0, 1, 0});
    mesh.triangles.push_back(mesh.triangles[0]);
    mesh.triangles.push_back(mesh.triangles[0]);
  }
  return mesh;
}

Mesh any_closed_mesh(Rng& rng) {
  const Mesh mesh = rng.below(4) == 0 ? generate_sphere(80 + 2 * rng.below(200)) : closed_mesh(rng);
  const double scale = rng.below(2) == 0 ? 1 : std::exp2(std::floor(rng.uniform(-80, 80)));
  const double far = rng.below(2) == 0 ? 0 : scale * std::exp2(rng.uniform(0, 20));
  return placed(mesh, scale,
                {far * rng.uniform(-1, 1), far * rng.uniform(-1, 1), far * rng.uniform(-1, 1)});
}

}  // namespace soms::test
