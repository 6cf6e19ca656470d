#include "bench/peers/scenarios/solids.h"

#include "soms/base/error.h"

#include <utility>

namespace soms::bench {

namespace {

/// Power that keeps the sign.
double bend(double v, double power) {
  return std::copysign(std::pow(std::abs(v), power), v);
}

Vec3 knot_curve(double a) {
  const double r = 2 + std::cos(3 * a);
  return {r * std::cos(2 * a), r * std::sin(2 * a), -std::sin(3 * a)};
}

}  // namespace

std::array<float, 3> narrow(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

Vec3 wide(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

Mesh widened(const FloatMesh& mesh) {
  Mesh result;
  for (const auto& v : mesh.vertices) {
    result.vertices.push_back(wide(v));
  }
  result.triangles = mesh.triangles;
  return result;
}

Vec3 unit(const Vec3& v) {
  return (1 / std::sqrt(dot(v, v))) * v;
}

Vec3 random_direction(Rng& rng) {
  const double z = rng.uniform(-1, 1);
  const double a = rng.uniform(0, 2 * kPi);
  const double s = std::sqrt(1 - z * z);
  return {s * std::cos(a), s * std::sin(a), z};
}

Pose random_rotation(Rng& rng, const Vec3& t) {
  const double u = rng.unit();
  const double a = rng.uniform(0, 2 * kPi);
  const double b = rng.uniform(0, 2 * kPi);
  const double s = std::sqrt(1 - u);
  const double c = std::sqrt(u);
  return Pose::from_quaternion(c * std::cos(b), s * std::sin(a), s * std::cos(a), c * std::sin(b),
                               t);
}

void append(FloatMesh& mesh, const FloatMesh& other) {
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles) {
    mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
}

FloatMesh box(const Vec3& center, const Vec3& half, double yaw) {
  const Pose pose = Pose::about_z(yaw, center);
  FloatMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.vertices.push_back(
        narrow(pose.apply({(i & 1U) != 0 ? half.x : -half.x, (i & 2U) != 0 ? half.y : -half.y,
                           (i & 4U) != 0 ? half.z : -half.z})));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

FloatMesh ellipsoid(const Vec3& center, const Vec3& half, std::uint32_t around, std::uint32_t rings,
                    double power) {
  FloatMesh mesh;
  mesh.vertices.push_back(narrow(center - Vec3{0, 0, half.z}));
  for (std::uint32_t i = 1; i <= rings; ++i) {
    const double latitude = kPi * i / (rings + 1) - kPi / 2;
    for (std::uint32_t j = 0; j < around; ++j) {
      const double longitude = 2 * kPi * j / around;
      const double k = bend(std::cos(latitude), power);
      mesh.vertices.push_back(narrow(center + Vec3{half.x * k * bend(std::cos(longitude), power),
                                                   half.y * k * bend(std::sin(longitude), power),
                                                   half.z * bend(std::sin(latitude), power)}));
    }
  }
  mesh.vertices.push_back(narrow(center + Vec3{0, 0, half.z}));
  const auto top = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  const auto id = [&](std::uint32_t i, std::uint32_t j) { return 1 + i * around + j % around; };
  for (std::uint32_t j = 0; j < around; ++j) {
    mesh.triangles.push_back({0, id(0, j + 1), id(0, j)});
    for (std::uint32_t i = 0; i + 1 < rings; ++i) {
      mesh.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i + 1, j)});
    }
    mesh.triangles.push_back({top, id(rings - 1, j), id(rings - 1, j + 1)});
  }
  return mesh;
}

FloatMesh cylinder(const Vec3& center, const Vec3& axis, double radius, double half,
                   std::uint32_t around) {
  const Vec3 w = unit(axis);
  const Vec3 u = unit(cross(std::abs(w.z) > 0.9 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}, w));
  const Vec3 v = cross(w, u);
  FloatMesh mesh;
  mesh.vertices = {narrow(center - half * w), narrow(center + half * w)};
  for (std::uint32_t j = 0; j < around; ++j) {
    const double a = 2 * kPi * j / around;
    const Vec3 rim = center + radius * (std::cos(a) * u + std::sin(a) * v);
    mesh.vertices.push_back(narrow(rim - half * w));
    mesh.vertices.push_back(narrow(rim + half * w));
  }
  const auto id = [&](std::uint32_t j, std::uint32_t side) { return 2 + 2 * (j % around) + side; };
  for (std::uint32_t j = 0; j < around; ++j) {
    mesh.triangles.push_back({0, id(j + 1, 0), id(j, 0)});
    mesh.triangles.push_back({1, id(j, 1), id(j + 1, 1)});
    mesh.triangles.push_back({id(j, 0), id(j + 1, 0), id(j + 1, 1)});
    mesh.triangles.push_back({id(j, 0), id(j + 1, 1), id(j, 1)});
  }
  return mesh;
}

FloatMesh torus_knot(std::uint32_t along, std::uint32_t around) {
  std::vector<Vec3> points;
  double radius = 0;
  for (std::uint32_t i = 0; i < along; ++i) {
    const double a = 2 * kPi * i / along;
    const double step = 1e-4;
    const Vec3 c = knot_curve(a);
    const Vec3 t = unit(knot_curve(a + step) - knot_curve(a - step));
    const Vec3 u = unit(cross(t, c));
    const Vec3 v = cross(t, u);
    for (std::uint32_t j = 0; j < around; ++j) {
      const double b = 2 * kPi * j / around;
      points.push_back(c + 0.4 * (std::cos(b) * u + std::sin(b) * v));
      radius = std::max(radius, std::sqrt(dot(points.back(), points.back())));
    }
  }
  FloatMesh mesh;
  for (const Vec3& p : points) {
    mesh.vertices.push_back(narrow((1 / radius) * p));
  }
  const auto id = [&](std::uint32_t i, std::uint32_t j) {
    return (i % along) * around + j % around;
  };
  for (std::uint32_t i = 0; i < along; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

FloatMesh referee_knot(std::uint64_t triangles) {
  switch (triangles) {
    case 1'000:
      return torus_knot(50, 10);
    case 10'000:
      return torus_knot(250, 20);
    case 100'000:
      return torus_knot(625, 80);
    case 1'000'000:
      return torus_knot(2500, 200);
    default:
      throw Error(ErrorKind::usage, "knot of " + std::to_string(triangles) + " triangles",
                  "the referee's sizes are 1000, 10000, 100000 and 1000000");
  }
}

}  // namespace soms::bench
