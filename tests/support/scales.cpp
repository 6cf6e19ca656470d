#include "tests/support/scales.h"

#include "tests/support/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace soms::test {

namespace {

constexpr int kLeastBody = -1070;
constexpr int kMostBody = 300;
constexpr int kStepOfBodies = 10;
/// Bodies of 2^-20 to 2^20 are not scaled.
constexpr int kEveryBody = 24;
constexpr int kLeastTriangle = -60;
constexpr int kStepOfTriangles = 4;
/// Subnormal bodies; the most exponent of a layout; squares and products of three lengths underflow
/// in doubles; products of two, and of the squares' roots, in floats.
constexpr std::array<std::array<int, 2>, 5> kCritical{
    {{-1070, -1060}, {-1046, -1040}, {-1003, -998}, {-538, -534}, {-78, -66}}};
/// Doubles have no more digits.
constexpr int kDigits = 52;

bool is_critical(int exponent) {
  return std::any_of(kCritical.begin(), kCritical.end(), [exponent](const auto& range) {
    return range[0] <= exponent && exponent <= range[1];
  });
}

std::vector<int> exponents_of_bodies() {
  std::vector<int> exponents;
  for (int e = kLeastBody; e <= kMostBody; ++e) {
    if ((e - kLeastBody) % kStepOfBodies == 0 || std::abs(e) <= kEveryBody || is_critical(e)) {
      exponents.push_back(e);
    }
  }
  return exponents;
}

double two_to(int exponent) {
  return std::ldexp(1.0, exponent);
}

Vec3 in_cube(Rng& rng, double reach) {
  const double x = rng.uniform(-reach, reach);
  const double y = rng.uniform(-reach, reach);
  return {x, y, rng.uniform(-reach, reach)};
}

void add_triangle(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/// A place that has room for things of the least size: the origin, or as far from it as doubles
/// tell such things apart.
Vec3 place_of_heap(Rng& rng, const Scales& scales) {
  if (rng.below(3) == 0) {
    return {};
  }
  const int room = static_cast<int>(rng.below(kDigits));
  return in_cube(rng, 0.25 * two_to(std::min(scales.body, scales.triangle + room)));
}

/// Parallel triangles, one behind the other along an axis, in any order.
void add_sheets(Rng& rng, const Vec3& place, double size, Mesh& mesh) {
  const std::size_t axis = rng.below(3);
  const double gap = 0.125 * size * std::exp2(-rng.uniform(0, 6));
  const bool limits = rng.below(2) == 0;
  for (std::uint64_t k = 0, count = 2 + rng.below(8); k < count; ++k) {
    std::array<Vec3, 3> corner{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
    const double height = gap * static_cast<double>(rng.below(8));
    for (Vec3& v : corner) {
      const Vec3 flat{v.x * size, v.y * size, height + (limits ? 0 : rng.uniform(0, gap))};
      v = place;
      for (std::size_t i = 0; i < 3; ++i) {
        v[(axis + 1 + i) % 3] += flat[i];
      }
    }
    add_triangle(mesh, corner[0], corner[1], corner[2]);
  }
}

void add_soup(Rng& rng, const Vec3& place, double size, Mesh& mesh) {
  for (std::uint64_t k = 0, count = 1 + rng.below(10); k < count; ++k) {
    const Vec3 a = place + in_cube(rng, 0.5 * size);
    const Vec3 b = place + in_cube(rng, 0.5 * size);
    add_triangle(mesh, a, b, place + in_cube(rng, 0.5 * size));
  }
}

/// Corners of a lattice, so that edges, planes and triangles coincide.
void add_lattice(Rng& rng, const Vec3& place, double size, Mesh& mesh) {
  const auto corner = [&] {
    Vec3 v = place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      v[axis] += 0.25 * size * static_cast<double>(rng.below(4));
    }
    return v;
  };
  for (std::uint64_t k = 0, count = 1 + rng.below(10); k < count; ++k) {
    const Vec3 a = corner();
    const Vec3 b = corner();
    add_triangle(mesh, a, b, corner());
  }
}

/// Tetrahedra whose faces face outward.
void add_tetrahedra(Rng& rng, const Vec3& place, double size, std::uint64_t most, Mesh& mesh) {
  const bool on_lattice = rng.below(2) == 0;
  const auto coordinate = [&] {
    return on_lattice ? 0.25 * static_cast<double>(rng.below(4)) : rng.uniform(-0.5, 0.5);
  };
  for (std::uint64_t k = 0, count = 1 + rng.below(most); k < count; ++k) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 v = place;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        v[axis] += size * coordinate();
      }
      mesh.vertices.push_back(v);
    }
    mesh.triangles.insert(mesh.triangles.end(), {{first, first + 2, first + 1},
                                                 {first, first + 1, first + 3},
                                                 {first + 3, first + 1, first + 2},
                                                 {first, first + 3, first + 2}});
  }
}

/// The least size mostly, else one between it and the body's.
double size_of_heap(Rng& rng, const Scales& scales) {
  const auto range = static_cast<std::uint64_t>(scales.body - scales.triangle) + 1;
  const int above = rng.below(3) == 0 ? static_cast<int>(rng.below(range)) : 0;
  return two_to(scales.triangle + above);
}

void add_large(Rng& rng, const Scales& scales, Mesh& mesh) {
  add_soup(rng, {}, two_to(scales.body), mesh);
  mesh.triangles.resize(std::min<std::size_t>(mesh.triangles.size(), 1 + rng.below(3)));
}

void add_heap(Rng& rng, const Vec3& place, double size, Mesh& mesh) {
  switch (rng.below(8)) {
    case 0:
    case 1:
      add_soup(rng, place, size, mesh);
      break;
    case 2:
    case 3:
      add_lattice(rng, place, size, mesh);
      break;
    case 4:
      add_triangle(mesh, place, place, place);
      break;
    default:
      add_sheets(rng, place, size, mesh);
  }
}

}  // namespace

std::size_t count_of_scales() {
  return exponents_of_bodies().size() * (-kLeastTriangle / kStepOfTriangles + 1);
}

Scales scales_of(std::size_t number) {
  const std::vector<int> bodies = exponents_of_bodies();
  const int body = bodies[number % bodies.size()];
  const auto step = static_cast<int>(number / bodies.size());
  return {body, body - kStepOfTriangles * (step % (-kLeastTriangle / kStepOfTriangles + 1))};
}

Scales any_scales(Rng& rng) {
  return scales_of(static_cast<std::size_t>(rng.below(count_of_scales())));
}

Mesh uneven_mesh(Rng& rng, const Scales& scales) {
  Mesh mesh;
  add_large(rng, scales, mesh);
  for (std::uint64_t k = 0, count = 1 + rng.below(3); k < count; ++k) {
    const Vec3 place = place_of_heap(rng, scales);
    add_heap(rng, place, 0.25 * size_of_heap(rng, scales), mesh);
  }
  return mesh;
}

Mesh uneven_solids(Rng& rng, const Scales& scales) {
  Mesh mesh;
  add_tetrahedra(rng, {}, two_to(scales.body), 2, mesh);
  for (std::uint64_t k = 0, count = 1 + rng.below(3); k < count; ++k) {
    const Vec3 place = place_of_heap(rng, scales);
    add_tetrahedra(rng, place, 0.5 * size_of_heap(rng, scales), 4, mesh);
  }
  return mesh;
}

Mesh uneven_beside(Rng& rng, const Scales& scales, const MeshView& other, bool solids) {
  Mesh mesh;
  const Vec3 place = point_of_small(rng, other, {});
  const bool is_point = rng.below(8) == 0;
  if (is_point) {
    const Vec3 point = place + any_way(rng, two_to(scales.triangle) * rng.uniform(0, 2));
    add_triangle(mesh, point, point, point);
    add_triangle(mesh, point, point, point);
  } else if (rng.below(2) == 0) {
    solids ? add_tetrahedra(rng, {}, two_to(scales.body), 1, mesh) : add_large(rng, scales, mesh);
  }
  for (std::uint64_t k = 0, count = is_point ? 0 : 1 + rng.below(2); k < count; ++k) {
    const double size = 0.25 * size_of_heap(rng, scales);
    const Vec3 at = rng.below(2) == 0 ? place : place + any_way(rng, size * rng.uniform(0, 8));
    solids ? add_tetrahedra(rng, at, size, 4, mesh) : add_heap(rng, at, size, mesh);
  }
  const double limit = two_to(scales.body - 1);
  return mapped(std::move(mesh), [limit](const Vec3& v) {
    return Vec3{std::clamp(v.x, -limit, limit), std::clamp(v.y, -limit, limit),
                std::clamp(v.z, -limit, limit)};
  });
}

Pose pose_at(Rng& rng, const Scales& scales) {
  Pose pose;
  if (rng.below(3) != 0 && scales.body < kMostBody - 1) {
    std::array<double, 4> q{};
    double square = 0;
    do {
      square = 0;
      for (double& part : q) {
        part = rng.uniform(-1, 1);
        square += part * part;
      }
    } while (square < 0.1 || square > 1);
    const double length = std::sqrt(square);
    pose = Pose::from_quaternion(q[0] / length, q[1] / length, q[2] / length, q[3] / length, {});
  }
  const std::uint64_t shift = rng.below(6);
  if (shift > 2 && scales.body < kMostBody - 1) {
    const int collapsing = scales.body + kDigits - 4 + static_cast<int>(rng.below(12));
    const Vec3 to = in_cube(rng, two_to(shift == 3   ? scales.triangle
                                        : shift == 4 ? scales.body - 1
                                                     : std::min(collapsing, kMostBody - 2)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pose.m[4 * axis + 3] = to[axis];
    }
  }
  return pose;
}

Vec3 point_of_small(Rng& rng, const MeshView& mesh, const Pose& pose) {
  const std::size_t count = mesh.triangles.size();
  const std::size_t begin = rng.below(4) == 0 ? 0 : std::min<std::size_t>(3, count - 1);
  const auto& t = mesh.triangles[begin + rng.below(count - begin)];
  const Vec3 a = pose.apply(mesh.vertices[t[0]]);
  const Vec3 b = pose.apply(mesh.vertices[t[1]]);
  const Vec3 c = pose.apply(mesh.vertices[t[2]]);
  const std::uint64_t kind = rng.below(6);
  const double u = rng.below(2) == 0 ? 0.5 : rng.uniform(0, 1);
  return kind == 0 ? a : kind == 1 ? a + (b - a) * u : (a + (b - a) * 0.25) + (c - a) * (u * 0.5);
}

Vec3 any_way(Rng& rng, double length) {
  if (rng.below(3) != 0) {
    return in_cube(rng, length);
  }
  Vec3 way;
  way[rng.below(3)] = rng.below(2) == 0 ? length : -length;
  return way;
}

}  // namespace soms::test
