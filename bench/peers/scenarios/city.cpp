// The referee's city of boxes on rolling terrain, and the bodies that are queried in it.
#include "soms/base/error.h"

#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <limits>

namespace soms::bench {

namespace {

constexpr double kHalf = 2000;         // from the middle of the city to its edge
constexpr double kBlock = 100;         // street center lines lie at multiples of this
constexpr double kStreetHalf = 8;      // half the width of a street
constexpr std::uint64_t kBlocks = 40;  // along a side
constexpr std::uint64_t kLots = 3;     // along a side of a block
constexpr double kLot = (kBlock - 2 * kStreetHalf) / kLots;

struct Building {
  Vec3 center;
  Vec3 half;
};

struct BoxCity {
  FloatMesh mesh;
  std::vector<Building> buildings;
  std::uint32_t cells = 0;  // of terrain, along a side

  [[nodiscard]] double corner_height(std::uint32_t i, std::uint32_t j) const {
    return mesh.vertices[std::size_t{j} * (cells + 1) + i][2];
  }

  /// Height of the terrain mesh, not of the smooth hills.
  [[nodiscard]] double ground(double x, double y) const {
    const double scale = cells / (2 * kHalf);
    const double u = std::clamp((x + kHalf) * scale, 0.0, cells - 1e-9);
    const double v = std::clamp((y + kHalf) * scale, 0.0, cells - 1e-9);
    const auto i = static_cast<std::uint32_t>(u);
    const auto j = static_cast<std::uint32_t>(v);
    const double fx = u - i;
    const double fy = v - j;
    const double a = corner_height(i, j);
    const double c = corner_height(i + 1, j + 1);
    const double other = fx >= fy ? corner_height(i + 1, j) : corner_height(i, j + 1);
    return fx >= fy ? a + fx * (other - a) + fy * (c - other)
                    : a + fy * (other - a) + fx * (c - other);
  }
};

double hills(double x, double y) {
  return 12 * std::sin(x / 310) * std::cos(y / 270) + 6 * std::sin((x + y) / 170 + 1) +
         3 * std::cos((x - 2 * y) / 130);
}

/// Two triangles a cell; the first `split` cells get four around a vertex on the diagonal.
FloatMesh terrain(std::uint32_t cells, std::uint64_t split) {
  FloatMesh mesh;
  const auto corner = [&](std::uint32_t i) { return -kHalf + 2 * kHalf * i / cells; };
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i) {
      mesh.vertices.push_back(narrow({corner(i), corner(j), hills(corner(i), corner(j))}));
    }
  }
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = j * (cells + 1) + i;
      const std::uint32_t b = a + 1;
      const std::uint32_t d = a + cells + 1;
      const std::uint32_t c = d + 1;
      if (std::uint64_t{j} * cells + i >= split) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
        continue;
      }
      const auto e = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(narrow(0.5 * (wide(mesh.vertices[a]) + wide(mesh.vertices[c]))));
      for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) {
        mesh.triangles.push_back({p, q, e});
      }
    }
  }
  return mesh;
}

std::vector<std::uint64_t> shuffled_lots(Rng& rng) {
  std::vector<std::uint64_t> lots(kBlocks * kBlocks * kLots * kLots);
  for (std::size_t i = 0; i < lots.size(); ++i) {
    lots[i] = i;
  }
  for (std::size_t i = lots.size() - 1; i > 0; --i) {
    std::swap(lots[i], lots[rng.below(i + 1)]);
  }
  return lots;
}

Building main_building(std::uint64_t lot, const BoxCity& city, Rng& rng) {
  const std::uint64_t block = lot / (kLots * kLots);
  const std::uint64_t place = lot % (kLots * kLots);
  const auto middle = [](std::uint64_t b, std::uint64_t p) {
    return -kHalf + kBlock * static_cast<double>(b) + kStreetHalf +
           kLot * (static_cast<double>(p) + 0.5);
  };
  const double x = middle(block % kBlocks, place % kLots);
  const double y = middle(block / kBlocks, place / kLots);
  const double width = rng.uniform(7, 13.5);
  const double depth = rng.uniform(7, 13.5);
  const double height = rng.uniform(4, 10) * (rng.unit() < 0.1 ? 4 : 1);
  return {{x, y, city.ground(x, y) + height - 3}, {width, depth, height}};
}

/// A balcony, ledge or window frame on a wall, or a unit on the roof.
FloatMesh detail_box(const Building& b, Rng& rng) {
  const std::uint64_t side = rng.below(5);
  if (side == 4) {
    const Vec3 half{rng.uniform(0.5, 2), rng.uniform(0.5, 2), rng.uniform(0.3, 1.5)};
    const double x = rng.uniform(-0.8, 0.8) * b.half.x;
    const double y = rng.uniform(-0.8, 0.8) * b.half.y;
    return box(b.center + Vec3{x, y, b.half.z + half.z}, half);
  }
  const double out = rng.uniform(0.05, 0.5);
  const double across = rng.uniform(0.4, 1.5);
  const double high = rng.uniform(0.1, 1);
  const double along = rng.uniform(-0.9, 0.9);
  const double up = rng.uniform(-0.6, 0.95) * b.half.z;
  const double sign = side % 2 == 1 ? 1 : -1;
  return side < 2
             ? box(b.center + Vec3{sign * b.half.x, along * b.half.y, up}, {out, across, high})
             : box(b.center + Vec3{along * b.half.x, sign * b.half.y, up}, {across, out, high});
}

/// A lamp post, a bin or a parked van at the kerb.
FloatMesh kerb_box(const BoxCity& city, Rng& rng) {
  const double line = kBlock * static_cast<double>(rng.below(kBlocks - 1) + 1) - kHalf;
  const double across = line + (rng.unit() < 0.5 ? -1 : 1) * rng.uniform(6.5, 7.5);
  const double along = rng.uniform(-kHalf + 20, kHalf - 20);
  const bool northward = rng.unit() < 0.5;
  const double x = northward ? across : along;
  const double y = northward ? along : across;
  const double kind = rng.unit();
  const Vec3 half = kind < 0.6   ? Vec3{0.08, 0.08, 3}
                    : kind < 0.8 ? Vec3{0.4, 0.4, 0.6}
                                 : Vec3{0.9, 0.9, 1.1};
  return box({x, y, city.ground(x, y) + half.z - 0.2}, half, rng.uniform(0, kPi));
}

std::uint32_t cells_for(std::uint64_t triangles) {
  switch (triangles) {
    case 5'672:
      return 32;
    case 100'000:
      return 128;
    case 1'000'000:
      return 400;
    case 5'000'000:
      return 1000;
    default:
      throw Error(ErrorKind::usage, "city of " + std::to_string(triangles) + " triangles",
                  "the referee's sizes are 5672, 100000, 1000000 and 5000000");
  }
}

BoxCity make_city(std::uint64_t triangles) {
  BoxCity city;
  city.cells = cells_for(triangles);
  const std::uint64_t rest = triangles - std::uint64_t{2} * city.cells * city.cells;
  city.mesh = terrain(city.cells, rest % 12 / 2);
  Rng rng(triangles);
  const auto lots = shuffled_lots(rng);
  for (std::uint64_t i = 0; i < rest / 12; ++i) {
    if (i < lots.size()) {
      city.buildings.push_back(main_building(lots[i], city, rng));
      append(city.mesh, box(city.buildings.back().center, city.buildings.back().half));
    } else if (i % 5 == 0) {
      append(city.mesh, kerb_box(city, rng));
    } else {
      append(city.mesh, detail_box(city.buildings[rng.below(city.buildings.size())], rng));
    }
  }
  return city;
}

/// Where a mover is on the map, and where it heads.
struct Spot {
  double x = 0;
  double y = 0;
  double yaw = 0;
};

/// Beside a wall; `radius` is half the mover's width across it.
Spot beside_wall(const BoxCity& city, double radius, Rng& rng) {
  const Building& b = city.buildings[rng.below(city.buildings.size())];
  const double off = radius + rng.uniform(-0.1, 0.3);
  const double along = rng.uniform(-1, 1);
  const double sign = rng.unit() < 0.5 ? -1 : 1;
  if (rng.unit() < 0.5) {
    return {b.center.x + sign * (b.half.x + off), b.center.y + along * b.half.y, kPi / 2};
  }
  return {b.center.x + along * b.half.x, b.center.y + sign * (b.half.y + off), 0};
}

Spot on_street(Rng& rng) {
  const double line = kBlock * static_cast<double>(rng.below(kBlocks - 1) + 1) - kHalf;
  const double along = rng.uniform(-kHalf + 50, kHalf - 50);
  const double across = line + rng.uniform(-5.5, 5.5);
  const double wobble = rng.uniform(-0.15, 0.15);
  return rng.unit() < 0.5 ? Spot{across, along, kPi / 2 + wobble} : Spot{along, across, wobble};
}

/// Straight on, and a quarter turn of 6 m radius every 90 m, left and right in turn.
std::vector<Spot> drive(double step) {
  std::vector<Spot> path;
  Spot at{-302, 3, 0};
  double bend = 0;
  double run = 0;
  bool left = true;
  for (std::size_t i = 0; i < kPoses; ++i) {
    const double sway = 0.4 * std::sin(static_cast<double>(i) * 0.013);
    path.push_back({at.x - sway * std::sin(at.yaw), at.y + sway * std::cos(at.yaw), at.yaw});
    at.x += step * std::cos(at.yaw);
    at.y += step * std::sin(at.yaw);
    run += step;
    if (bend <= 0 && run > 90) {
      bend = kPi / 2;
      run = 0;
      left = !left;
    }
    if (bend > 0) {
      const double turn = std::min(bend, step / 6);
      at.yaw += left ? turn : -turn;
      bend -= turn;
    }
  }
  return path;
}

/// The car stands level, 0.1 m above the highest ground under it.
Pose car_at(const BoxCity& city, const Spot& spot) {
  const Pose flat = Pose::about_z(spot.yaw, {spot.x, spot.y, 0});
  double top = -std::numeric_limits<double>::infinity();
  for (int i = -4; i <= 4; ++i) {
    for (int j = -2; j <= 2; ++j) {
      const Vec3 p = flat.apply({i * 2.3 / 4, j * 0.975 / 2, 0});
      top = std::max(top, city.ground(p.x, p.y));
    }
  }
  return Pose::about_z(spot.yaw, {spot.x, spot.y, top + 0.1});
}

}  // namespace

FloatMesh referee_city(std::uint64_t triangles) {
  return make_city(triangles).mesh;
}

Scene city_car_scene(std::uint64_t triangles, std::uint64_t seed) {
  const BoxCity city = make_city(triangles);
  Scene scene{
      "city-car", referee_car(), city.mesh, {{"car", {}, kEveryPoseJob}, {"car-path", {}, kNear}}};
  Rng rng = rng_of(21, seed);
  for (std::size_t i = 0; i < kPoses; ++i) {
    const bool wall = rng.unit() < 0.15;
    const Spot spot = wall ? beside_wall(city, 0.975, rng) : on_street(rng);
    scene.sets[0].poses.push_back(car_at(city, spot));
  }
  for (const Spot& spot : drive(0.2)) {
    scene.sets[1].poses.push_back(car_at(city, spot));
  }
  return scene;
}

Scene city_drone_scene(std::uint64_t triangles, std::uint64_t seed) {
  const BoxCity city = make_city(triangles);
  Scene scene{
      "city-drone", referee_drone(), city.mesh, {{"drone", {}, kNear}, {"drone-path", {}, kNear}}};
  Rng rng = rng_of(22, seed);
  for (std::size_t i = 0; i < kPoses; ++i) {
    const bool wall = rng.unit() < 0.15;
    const Spot spot = wall ? beside_wall(city, 0.5, rng) : on_street(rng);
    const double z = city.ground(spot.x, spot.y) + rng.uniform(2, 40);
    scene.sets[0].poses.push_back(random_rotation(rng, {spot.x, spot.y, z}));
  }
  double frame = 0;
  for (const Spot& spot : drive(0.2)) {
    const double z = city.ground(spot.x, spot.y) + 6 + 3 * std::sin(frame * 0.02);
    scene.sets[1].poses.push_back(Pose::about_z(spot.yaw, {spot.x, spot.y + 4, z}));
    frame += 1;
  }
  return scene;
}

}  // namespace soms::bench
