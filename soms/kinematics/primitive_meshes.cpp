#include "soms/kinematics/primitive_meshes.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace soms {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::uint32_t kLeastSides = 8;
constexpr std::uint32_t kMostSides = 4096;
constexpr std::uint32_t kMostMeridians = 1024;
/// Radii are greater by this, so that rounded vertices hold the shape, too: sines, cosines and
/// products are off by a few 1e-16.
constexpr double kRounding = 1e-14;

void check_size(const char* what, double value) {
  if (!(value >= 0) || !(value <= 0x1p299)) {
    throw Error(std::isfinite(value) ? ErrorKind::usage : ErrorKind::not_finite,
                std::string(what) + " is " + shortest(value), "give a number from 0 on");
  }
}

void check_error(double value) {
  if (!(value > 0) || !(value <= 0x1p299)) {
    throw Error(std::isfinite(value) ? ErrorKind::usage : ErrorKind::not_finite,
                "the error of a round shape is " + shortest(value), "give a positive number");
  }
}

/// Of a shape without extent along an axis, sums with -0 are 0: its vertices coincide in every bit.
void join_zeros(Mesh& mesh) {
  for (Vec3& vertex : mesh.vertices) {
    vertex = {vertex.x + 0.0, vertex.y + 0.0, vertex.z + 0.0};
  }
}

[[noreturn]] void fail_fine(double radius, double most_error) {
  throw Error(ErrorKind::out_of_range,
              "a radius of " + shortest(radius) + " within an error of " + shortest(most_error) +
                  " needs too many triangles",
              "allow a greater error, or give the shape as a mesh");
}

/// A point on a circle of radius 1, exact where it lies on an axis.
std::pair<double, double> on_circle(std::uint32_t i, std::uint32_t n) {
  if (4 * i % n == 0) {
    constexpr std::array<std::pair<double, double>, 4> kAxes{
        {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}};
    return kAxes[4 * i / n % 4];
  }
  const double angle = 2 * kPi * i / n;
  return {std::cos(angle), std::sin(angle)};
}

/// Triangles between two rings of n vertices, the first of which begin there.
void join_rings(Mesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({lower + i, lower + next, upper + next});
    mesh.triangles.push_back({lower + i, upper + next, upper + i});
  }
}

void add_ring(Mesh& mesh, double radius, double z, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto [c, s] = on_circle(i, n);
    mesh.vertices.push_back({radius * c, radius * s, z});
  }
}

/// A fan from a pole to the ring that begins at `ring`.
void add_cap(Mesh& mesh, std::uint32_t pole, std::uint32_t ring, std::uint32_t n, bool up) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back(up ? std::array{pole, ring + i, ring + next}
                                : std::array{pole, ring + next, ring + i});
  }
}

Mesh uv_sphere(double radius, std::uint32_t meridians) {
  const std::uint32_t bands = meridians / 2;
  Mesh mesh;
  mesh.vertices = {{0, 0, -radius}, {0, 0, radius}};
  for (std::uint32_t band = 1; band < bands; ++band) {
    const double angle = kPi * band / bands;
    add_ring(mesh, radius * std::sin(angle), -radius * std::cos(angle), meridians);
  }
  add_cap(mesh, 0, 2, meridians, false);
  for (std::uint32_t band = 1; band + 1 < bands; ++band) {
    join_rings(mesh, 2 + (band - 1) * meridians, 2 + band * meridians, meridians);
  }
  add_cap(mesh, 1, 2 + (bands - 2) * meridians, meridians, true);
  return mesh;
}

/// The least distance of the origin from the planes of a mesh that holds it.
double least_plane_distance(const Mesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    const Vec3 normal = cross(t.b - t.a, t.c - t.a);
    least = std::min(least, std::abs(dot(normal, t.a)) / std::sqrt(dot(normal, normal)));
  }
  return least;
}

/// Of a polyhedron whose vertices lie on the sphere of radius 1, the radius of the sphere that it
/// holds, rounded down.
double inradius(std::uint32_t meridians) {
  return least_plane_distance(uv_sphere(1, meridians)) * (1 - kRounding);
}

}  // namespace

PrimitiveMesh box_mesh(const Vec3& size) {
  const PlainArithmetic plain;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    check_size("a side of a box", size[axis]);
  }
  PrimitiveMesh result;
  Mesh& mesh = result.mesh;
  for (unsigned corner = 0; corner < 8; ++corner) {
    mesh.vertices.push_back({((corner & 1U) != 0 ? 0.5 : -0.5) * size.x,
                             ((corner & 2U) != 0 ? 0.5 : -0.5) * size.y,
                             ((corner & 4U) != 0 ? 0.5 : -0.5) * size.z});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  join_zeros(mesh);
  return result;
}

PrimitiveMesh cylinder_mesh(double radius, double length, double most_error) {
  const PlainArithmetic plain;
  check_size("the radius of a cylinder", radius);
  check_size("the length of a cylinder", length);
  check_error(most_error);
  const auto outer = [&](std::uint32_t n) { return radius / std::cos(kPi / n) * (1 + kRounding); };
  std::uint32_t sides = kLeastSides;
  while (outer(sides) - radius > most_error) {
    if (sides == kMostSides) {
      fail_fine(radius, most_error);
    }
    sides = std::min(kMostSides, sides + (sides < 64 ? 4 : sides / 16 / 4 * 4));
  }
  PrimitiveMesh result{.mesh = {}, .error = outer(sides) - radius};
  Mesh& mesh = result.mesh;
  mesh.vertices = {{0, 0, -0.5 * length}, {0, 0, 0.5 * length}};
  add_ring(mesh, outer(sides), -0.5 * length, sides);
  add_ring(mesh, outer(sides), 0.5 * length, sides);
  add_cap(mesh, 0, 2, sides, false);
  join_rings(mesh, 2, 2 + sides, sides);
  add_cap(mesh, 1, 2 + sides, sides, true);
  if (radius == 0 || length == 0) {
    join_zeros(mesh);
  }
  return result;
}

PrimitiveMesh sphere_mesh(double radius, double most_error) {
  const PlainArithmetic plain;
  check_size("the radius of a sphere", radius);
  check_error(most_error);
  std::uint32_t meridians = kLeastSides;
  double outer = radius / inradius(meridians);
  while (outer - radius > most_error) {
    if (meridians == kMostMeridians) {
      fail_fine(radius, most_error);
    }
    // The error falls with the square of their number.
    const double more = meridians * std::sqrt((outer - radius) / most_error);
    const auto wanted = static_cast<std::uint32_t>(std::min<double>(more, kMostMeridians));
    meridians = std::min(kMostMeridians, std::max(meridians + 4, (wanted + 3) / 4 * 4));
    outer = radius / inradius(meridians);
  }
  PrimitiveMesh result{.mesh = uv_sphere(outer, meridians), .error = outer - radius};
  if (radius == 0) {
    join_zeros(result.mesh);
  }
  return result;
}

}  // namespace soms
