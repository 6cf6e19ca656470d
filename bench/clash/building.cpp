#include "bench/clash/building.h"

#include "soms/base/random.h"
#include "soms/base/vector.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::bench {
namespace {

constexpr double kStorey = 3.5;
constexpr double kLength = 60;  ///< of a wing, and its width
constexpr double kWidth = 30;
constexpr std::size_t kWings = 4;

/// A polygon that is swept along a path, counter-clockwise seen against the path, and its cap.
struct Profile {
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<std::uint32_t, 3>> cap;
};

/// A profile whose cap is a fan, as any convex one's may be.
Profile convex(std::vector<std::array<double, 2>> points) {
  Profile profile{std::move(points), {}};
  for (std::uint32_t k = 1; k + 1 < profile.points.size(); ++k) {
    profile.cap.push_back({0, k, k + 1});
  }
  return profile;
}

Profile rectangle(double width, double height) {
  const double x = width / 2;
  const double y = height / 2;
  return convex({{-x, -y}, {x, -y}, {x, y}, {-x, y}});
}

Profile circle(double radius, std::uint32_t sides) {
  std::vector<std::array<double, 2>> points;
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return convex(std::move(points));
}

/// Flanges below and above a web.
Profile i_beam(double width, double height, double web, double flange) {
  const double x = width / 2;
  const double y = height / 2;
  const double w = web / 2;
  const double f = y - flange;
  return {{{-x, -y},
           {x, -y},
           {x, -f},
           {w, -f},
           {w, f},
           {x, f},
           {x, y},
           {-x, y},
           {-x, f},
           {-w, f},
           {-w, -f},
           {-x, -f}},
          {{0, 1, 2},
           {0, 2, 3},
           {0, 3, 10},
           {0, 10, 11},
           {10, 3, 4},
           {10, 4, 9},
           {8, 9, 7},
           {9, 4, 7},
           {4, 6, 7},
           {4, 5, 6}}};
}

/// Open above: a tray.
Profile channel(double width, double height, double sheet) {
  const double x = width / 2;
  const double inner = x - sheet;
  return {{{-x, 0},
           {x, 0},
           {x, height},
           {inner, height},
           {inner, sheet},
           {-inner, sheet},
           {-inner, height},
           {-x, height}},
          {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}, {0, 5, 7}, {5, 6, 7}}};
}

/// A wall in elevation with a door of 1 m x 2.1 m at `door`.
Profile wall(double length, double height, double door) {
  const double right = door + 1;
  return {{{0, 0},
           {door, 0},
           {door, 2.1},
           {right, 2.1},
           {right, 0},
           {length, 0},
           {length, height},
           {0, height}},
          {{0, 1, 2}, {0, 2, 7}, {2, 6, 7}, {2, 3, 6}, {3, 4, 5}, {3, 5, 6}}};
}

double as_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

/// Where a wing stands: turned about the vertical, then moved.
struct Wing {
  double cosine = 1;
  double sine = 0;
  Vec3 origin = {};

  [[nodiscard]] Vec3 placed(const Vec3& p) const {
    return {as_float(origin.x + cosine * p.x - sine * p.y),
            as_float(origin.y + sine * p.x + cosine * p.y), as_float(origin.z + p.z)};
  }
};

/// Adds parts to a mesh.
class Builder {
 public:
  Builder(Mesh& mesh, const Wing& wing) : mesh_(mesh), wing_(wing) {}

  /// A closed part: the profile along a path, mitered at its corners.
  void sweep(std::string name, const Profile& profile, std::span<const Vec3> path) {
    const auto first = static_cast<std::uint32_t>(mesh_.triangles.size());
    const auto base = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto n = static_cast<std::uint32_t>(profile.points.size());
    Vec3 along = direction(path[0], path[1]);
    const Vec3 up = std::abs(along.z) > 0.5 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 right = cross(up, along);
    std::vector<Vec3> ring;
    for (const auto& [x, y] : profile.points) {
      ring.push_back(path[0] + right * x + up * y);
    }
    add(ring);
    for (std::size_t k = 1; k < path.size(); ++k) {
      const Vec3 next = k + 1 < path.size() ? direction(path[k], path[k + 1]) : along;
      const Vec3 normal = along + next;
      for (Vec3& p : ring) {
        p += along * (dot(path[k] - p, normal) / dot(along, normal));
      }
      add(ring);
      const std::uint32_t from = base + static_cast<std::uint32_t>(k - 1) * n;
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        mesh_.triangles.push_back({from + i, from + j, from + n + j});
        mesh_.triangles.push_back({from + i, from + n + j, from + n + i});
      }
      along = next;
    }
    const std::uint32_t last = base + static_cast<std::uint32_t>(path.size() - 1) * n;
    for (const auto& [a, b, c] : profile.cap) {
      mesh_.triangles.push_back({base + a, base + c, base + b});
      mesh_.triangles.push_back({last + a, last + b, last + c});
    }
    const auto count = static_cast<std::uint32_t>(mesh_.triangles.size()) - first;
    mesh_.parts.push_back({std::move(name), Part::kNoParent, first, count});
  }

  void bar(std::string name, const Profile& profile, const Vec3& from, const Vec3& to) {
    sweep(std::move(name), profile, std::array{from, to});
  }

 private:
  static Vec3 direction(const Vec3& from, const Vec3& to) {
    const Vec3 d = to - from;
    return d * (1 / std::sqrt(dot(d, d)));
  }

  void add(std::span<const Vec3> ring) {
    for (const Vec3& p : ring) {
      mesh_.vertices.push_back(wing_.placed(p));
    }
  }

  Mesh& mesh_;
  Wing wing_;
};

std::string named(const char* kind, std::size_t wing, std::size_t level, int number) {
  return std::string(kind) + ' ' + std::to_string(wing) + '.' + std::to_string(level) + '.' +
         std::to_string(number);
}

/// 163 parts: 50 slabs, 66 columns, 17 beams, 30 walls.
void add_structure(Builder& builder, Rng& rng, std::size_t wing, std::size_t level) {
  const double z = kStorey * static_cast<double>(level);
  int number = 0;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 5; ++j) {
      const double y = 6 * j + 3;
      builder.bar(named("slab", wing, level, number++), rectangle(6, 0.25), {6.0 * i, y, z + 0.125},
                  {6.0 * i + 6, y, z + 0.125});
    }
  }
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 5; ++j) {
      builder.bar(named("column", wing, level, number++), circle(0.2, 24),
                  {6.0 * i, 6.0 * j, z + 0.25}, {6.0 * i, 6.0 * j, z + 3.1});
    }
  }
  const Profile beam = i_beam(0.3, 0.4, 0.02, 0.03);
  for (int j = 0; j <= 5; ++j) {
    builder.bar(named("beam", wing, level, number++), beam, {0, 6.0 * j, z + 3.3},
                {kLength, 6.0 * j, z + 3.3});
  }
  for (int i = 0; i <= 10; ++i) {
    builder.bar(named("beam", wing, level, number++), beam, {6.0 * i, 0, z + 3.3},
                {6.0 * i, kWidth, z + 3.3});
  }
  for (int i = 0; i < 30; ++i) {
    const double x = 3 + 6 * (i % 10);
    const double y = 10.0 * (i / 10);
    // The profile's x goes against y, as the path goes along x.
    builder.bar(named("wall", wing, level, number++), wall(9.8, 2.85, rng.uniform(1, 7)),
                {x - 0.1, y + 9.9, z + 0.25}, {x + 0.1, y + 9.9, z + 0.25});
  }
}

/// A path that goes on along x and y in turn, inside the wing.
std::vector<Vec3> wander(Rng& rng, double height, std::size_t legs) {
  std::vector<Vec3> path{{rng.uniform(1, kLength - 1), rng.uniform(1, kWidth - 1), height}};
  bool along_x = rng.below(2) == 0;
  for (std::size_t k = 0; k < legs; ++k) {
    Vec3 next = path.back();
    double& moved = along_x ? next.x : next.y;
    const double most = along_x ? kLength : kWidth;
    const double by = rng.uniform(2, most / 2);
    moved += moved + by < most - 1 ? by : -std::min(by, moved - 0.5);
    path.push_back(next);
    along_x = !along_x;
  }
  return path;
}

/// 165 parts: 80 pipes, 30 ducts, 20 trays, 35 drops.
void add_services(Builder& builder, Rng& rng, std::size_t wing, std::size_t level) {
  const double z = kStorey * static_cast<double>(level);
  int number = 0;
  for (int i = 0; i < 80; ++i) {
    const Profile pipe = circle(rng.uniform(0.02, 0.08), 12);
    builder.sweep(named("pipe", wing, level, number++), pipe,
                  wander(rng, z + rng.uniform(1.2, 3.3), 2 + rng.below(3)));
  }
  for (int i = 0; i < 30; ++i) {
    const Profile duct = rectangle(rng.uniform(0.2, 0.5), rng.uniform(0.15, 0.35));
    builder.sweep(named("duct", wing, level, number++), duct,
                  wander(rng, z + rng.uniform(2.3, 3.2), 1 + rng.below(3)));
  }
  for (int i = 0; i < 20; ++i) {
    builder.sweep(named("tray", wing, level, number++), channel(0.3, 0.06, 0.004),
                  wander(rng, z + rng.uniform(2.5, 3.3), 1 + rng.below(2)));
  }
  for (int i = 0; i < 35; ++i) {
    const Vec3 top{rng.uniform(1, kLength - 1), rng.uniform(1, kWidth - 1), z + 3.2};
    builder.bar(named("drop", wing, level, number++), circle(0.015, 8),
                {top.x, top.y, z + rng.uniform(0.1, 2.5)}, top);
  }
}

}  // namespace

Building make_building(std::uint64_t parts, std::uint64_t seed) {
  Rng rng(seed);
  Building building;
  for (std::size_t level = 0;
       building.structure.parts.size() < parts || building.services.parts.size() < parts; ++level) {
    for (std::size_t k = 0; k < kWings; ++k) {
      const double angle = 0.35 * static_cast<double>(k);
      const Wing wing{std::cos(angle), std::sin(angle), {80.0 * static_cast<double>(k), 0, 0}};
      Builder structure(building.structure, wing);
      Builder services(building.services, wing);
      add_structure(structure, rng, k, level);
      add_services(services, rng, k, level);
    }
  }
  building.structure.source = "structure";
  building.services.source = "services";
  return building;
}

}  // namespace soms::bench
