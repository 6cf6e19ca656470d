#include "tests/properties/uneven_bodies.h"

#include "tests/support/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace soms::test {

namespace {

constexpr int kLeastBody = -1070;
constexpr int kMostBody = 300;
constexpr int kMostRatio = 60;
constexpr int kMostExponent = 296;  // moved coordinates stay below 2^300

/// Exponents where something changes: subnormal bodies, the least and the most exponent of a
/// layout, bodies whose squares and triple products underflow in float and double, and usual sizes.
bool is_critical(int exponent) {
  constexpr std::array<std::array<int, 2>, 7> kRanges{
      {{-1070, -1040}, {-1003, -997}, {-540, -534}, {-104, -96}, {-78, -70}, {-24, -8}, {18, 22}}};
  return std::any_of(kRanges.begin(), kRanges.end(), [exponent](const std::array<int, 2>& range) {
    return exponent >= range[0] && exponent <= range[1];
  });
}

bool is_usual(int exponent) {
  return exponent >= -24 && exponent <= 22;
}

double power(int exponent) {
  return std::ldexp(1.0, std::min(exponent, kMostExponent));
}

/// A step on a lattice, so that features tie and triangles touch, or anywhere.
Vec3 step_of(Rng& rng, bool on_lattice, double size) {
  Vec3 v;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    v[axis] = on_lattice ? (static_cast<double>(rng.below(5)) - 2) / 2 : rng.uniform(-1, 1);
  }
  return v * size;
}

/// Where the tiny triangles are: at the origin, where doubles are as fine as can be, on an axis or
/// in a plane of it, or anywhere in the body.
Vec3 place_in(double body, Rng& rng) {
  Vec3 place;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint64_t kind = rng.below(4);
    place[axis] = kind < 2    ? 0
                  : kind == 2 ? std::ldexp(body, -static_cast<int>(rng.below(40)))
                              : rng.uniform(-1, 1) * body;
  }
  return place;
}

/// How triangles of one size are drawn.
struct Draw {
  bool closed;
  bool on_lattice;
};

/// A triangle, or the four of a tetrahedron, about a place.
void add(const Vec3& place, double size, const Draw& draw, Rng& rng, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const Vec3 at = place + step_of(rng, draw.on_lattice, size);
  for (int corner = 0; corner < (draw.closed ? 4 : 3); ++corner) {
    mesh.vertices.push_back(at + step_of(rng, draw.on_lattice, size));
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  if (draw.closed) {
    mesh.triangles.insert(mesh.triangles.end(), {{first, first + 3, first + 1},
                                                 {first + 1, first + 3, first + 2},
                                                 {first, first + 2, first + 3}});
  }
}

Mesh uneven_mesh(const Sizes& sizes, const std::vector<Vec3>& places, bool closed, bool all_tiny,
                 Rng& rng) {
  const std::uint64_t most = closed ? 3 : 10;
  const double body = power(sizes.body);
  const double tiny = power(sizes.tiny);
  const Draw draw{closed, rng.below(2) == 0};
  Mesh mesh;
  for (std::uint64_t k = 0, count = all_tiny ? 0 : 1 + rng.below(most); k < count; ++k) {
    add({}, body / 2, {closed, rng.below(4) == 0}, rng, mesh);
  }
  for (const Vec3& place : places) {
    for (std::uint64_t k = 0, count = 1 + rng.below(most); k < count; ++k) {
      add(place, tiny, draw, rng, mesh);
    }
  }
  if (rng.below(2) == 0) {
    const auto range = static_cast<std::uint64_t>(sizes.body - sizes.tiny + 1);
    add(places[0], power(sizes.tiny + static_cast<int>(rng.below(range))), draw, rng, mesh);
  }
  return mesh;
}

Vec3 point_on(const Triangle& t, Rng& rng) {
  const double u = static_cast<double>(rng.below(5)) / 4;
  const double v = static_cast<double>(rng.below(5)) / 4 * (1 - u);
  return t.a + u * (t.b - t.a) + v * (t.c - t.a);
}

Vec3 point_near(const UnevenBodies& bodies, const Sizes& sizes, Rng& rng) {
  const Vec3& place = bodies.places[rng.below(bodies.places.size())];
  const int wider = static_cast<int>(rng.below(4)) - 1;
  return place + step_of(rng, rng.below(2) == 0, power(sizes.tiny + wider));
}

Vec3 point_of(const Mesh& mesh, Rng& rng) {
  return point_on(mesh.triangle(static_cast<TriangleId>(rng.below(mesh.triangles.size()))), rng);
}

}  // namespace

std::vector<Sizes> all_sizes(int step) {
  std::vector<Sizes> sizes;
  for (int body = kLeastBody; body <= kMostBody; ++body) {
    if (!is_critical(body) && body % step != 0) {
      continue;
    }
    for (int ratio = 0; ratio <= kMostRatio; ratio += is_usual(body) ? 3 : 10) {
      sizes.push_back({body, body - ratio});
    }
  }
  return sizes;
}

UnevenBodies uneven_bodies(const Sizes& sizes, Rng& rng) {
  UnevenBodies bodies;
  bodies.closed = rng.below(2) == 0;
  for (std::uint64_t k = 0, count = 1 + rng.below(2); k < count; ++k) {
    bodies.places.push_back(place_in(power(sizes.body), rng));
  }
  bodies.a = uneven_mesh(sizes, bodies.places, bodies.closed, false, rng);
  const std::uint64_t kind = rng.below(8);
  bodies.b = uneven_mesh(sizes, bodies.places, bodies.closed, kind < 3, rng);
  if (kind == 0) {
    const Vec3 point = point_near(bodies, sizes, rng);
    bodies.b = mapped(bodies.b, [&](const Vec3&) { return point; });
  }
  if (rng.below(2) == 0) {
    const Vec3 shift = step_of(rng, false, power(sizes.tiny + static_cast<int>(rng.below(8))));
    bodies.b = mapped(bodies.b, [&](const Vec3& v) { return v + shift; });
  }
  return bodies;
}

std::vector<Vec3> points_at(const UnevenBodies& bodies, const Sizes& sizes, Rng& rng) {
  std::vector<Vec3> points{point_near(bodies, sizes, rng), point_of(bodies.a, rng),
                           step_of(rng, false, power(sizes.body))};
  Vec3 beside = point_of(bodies.a, rng);
  double& x = beside[rng.below(3)];
  x = std::nextafter(x, rng.below(2) == 0 ? -0x1p299 : 0x1p299);
  points.push_back(beside);
  return points;
}

std::vector<Ray> rays_at(const UnevenBodies& bodies, const Sizes& sizes, Rng& rng) {
  const double tiny = power(sizes.tiny);
  const Vec3 from = point_near(bodies, sizes, rng);
  const Vec3 outside = step_of(rng, false, power(sizes.body)) * 2;
  const Vec3 target = point_of(bodies.a, rng);
  Vec3 along;
  along[rng.below(3)] = rng.below(2) == 0 ? tiny : -1;
  std::vector<Ray> rays{{from, step_of(rng, rng.below(2) == 0, tiny)},
                        {from, target - from},
                        {from, step_of(rng, false, 1)},
                        {outside, target - outside, rng.below(2) == 0 ? 1.0 : 2.0},
                        {from, along},
                        {target, along}};
  std::erase_if(rays, [](const Ray& ray) { return ray.direction == Vec3{}; });
  return rays;
}

}  // namespace soms::test
