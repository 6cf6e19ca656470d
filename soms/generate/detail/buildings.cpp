#include "soms/generate/detail/buildings.h"

#include "soms/generate/detail/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace soms::detail {

namespace {

constexpr double kLotSide = 30;        ///< wished for
constexpr std::uint64_t kEach = 48;    ///< triangles a building is given before more is built
constexpr std::uint64_t kDetail = 12;  ///< triangles of a detail
constexpr double kSunk = 0.5;          ///< how far walls reach below the lowest ground
constexpr std::uint64_t kLotKind = 2;  ///< tags of `rng_for`
constexpr std::uint64_t kDetailKind = 3;
constexpr std::uint64_t kOrderKind = 4;

/// Square lots inside the blocks.
struct Lots {
  std::uint64_t blocks = 0;  ///< along a side of the city
  std::uint64_t across = 0;  ///< along a side of a block
  double side = 0;
};

Lots lots_of(const City& city) {
  Lots lots;
  lots.blocks = city.street_lines.size() - 1;
  const double block = city.street_spacing - city.street_width;
  lots.across = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(block / kLotSide));
  lots.side = block / static_cast<double>(lots.across);
  return lots;
}

/// The first `count` lots in a random order: those along the streets before those behind them.
std::vector<std::uint64_t> choose_lots(const City& city, const Lots& lots, std::uint64_t count) {
  std::vector<std::uint64_t> outer;
  std::vector<std::uint64_t> inner;
  const std::uint64_t each = lots.across * lots.across;
  for (std::uint64_t lot = 0; lot < lots.blocks * lots.blocks * each; ++lot) {
    const std::uint64_t u = lot % each % lots.across;
    const std::uint64_t v = lot % each / lots.across;
    const bool inside = u > 0 && v > 0 && u + 1 < lots.across && v + 1 < lots.across;
    (inside ? inner : outer).push_back(lot);
  }
  Rng rng = rng_for(city, kOrderKind, 0);
  for (auto* list : {&outer, &inner}) {
    for (std::size_t i = list->size(); i > 1; --i) {
      std::swap((*list)[i - 1], (*list)[rng.below(i)]);
    }
  }
  outer.insert(outer.end(), inner.begin(), inner.end());
  outer.resize(std::min<std::size_t>(outer.size(), count));
  std::sort(outer.begin(), outer.end());
  return outer;
}

BuildingKind draw_kind(Rng& rng) {
  const double r = rng.unit();
  return r < 0.28   ? BuildingKind::block
         : r < 0.56 ? BuildingKind::gabled
         : r < 0.68 ? BuildingKind::corner
         : r < 0.80 ? BuildingKind::courtyard
         : r < 0.92 ? BuildingKind::bastion
                    : BuildingKind::tower;
}

/// An irregular convex outline within `reach`.
Outline bastion_outline(double reach, Rng& rng) {
  const std::size_t corners = 5 + rng.below(5);
  Outline outline;
  for (std::size_t i = 0; i < corners; ++i) {
    const OnCircle p =
        on_circle((static_cast<double>(i) + rng.uniform(-0.3, 0.3)) / static_cast<double>(corners));
    outline.push_back({reach * p.cosine, reach * p.sine});
  }
  return outline;
}

/// Outline, height of the walls; `reach` is half the lot.
void draw_shape(Building& building, double reach, Rng& rng) {
  const double x = rng.uniform(0.6, 0.96) * reach;
  const double y = rng.uniform(0.6, 0.96) * reach;
  building.outline = rectangle(x, y);
  switch (building.kind) {
    case BuildingKind::block:
      building.wall = rng.uniform(6, 26);
      break;
    case BuildingKind::gabled:
      building.wall = rng.uniform(4.5, 9);
      break;
    case BuildingKind::tower: {
      // One draw a statement: compilers differ in which argument of a call they evaluate first.
      const double width = rng.uniform(0.55, 0.92) * reach;
      building.outline = regular(5 + rng.below(8), width);
      building.wall = rng.uniform(25, 70);
      break;
    }
    case BuildingKind::corner: {
      const double a = rng.uniform(-0.3, 0.2) * x;
      const double b = rng.uniform(-0.3, 0.2) * y;
      building.outline = {{a, b}, {a, y}, {-x, y}, {-x, -y}, {x, -y}, {x, b}};
      building.wall = rng.uniform(7, 20);
      break;
    }
    case BuildingKind::courtyard:
      building.wall = rng.uniform(9, 22);
      break;
    case BuildingKind::bastion:
      building.outline = bastion_outline(0.95 * reach, rng);
      building.wall = rng.uniform(5, 18);
      break;
  }
}

/// Lowest ground under the corners of an outline at a place.
double lowest_ground(const City& city, const Building& building) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Corner& c : building.outline) {
    const Vec3 p = building.frame.at(c.x, c.y, 0);
    lowest = std::min(lowest, city.ground(p.x, p.y));
  }
  return lowest;
}

Building draw_building(const City& city, const Lots& lots, std::uint64_t lot) {
  Rng rng = rng_for(city, kLotKind, lot);
  const std::uint64_t each = lots.across * lots.across;
  const std::uint64_t block = lot / each;
  const auto place = [&](std::uint64_t line, std::uint64_t cell) {
    return city.street_lines[line] + 0.5 * city.street_width +
           lots.side * (static_cast<double>(cell) + 0.5);
  };
  const double x = place(block % lots.blocks, lot % each % lots.across);
  const double y = place(block / lots.blocks, lot % each / lots.across);
  const double reach = 0.5 * std::min(lots.side, 2 * kLotSide);
  Building building;
  building.index = lot;
  building.kind = draw_kind(rng);
  draw_shape(building, reach, rng);
  const double free = 0.03 * reach;
  // One in five is turned, and smaller so that it stays within its lot.
  const bool turned = rng.unit() < 0.2;
  const OnCircle turn = on_circle(turned ? rng.unit() : 0);
  building.frame = upright({x + rng.uniform(-free, free), y + rng.uniform(-free, free), 0}, turn);
  if (turned) {
    for (Corner& c : building.outline) {
      c = {0.7 * c.x, 0.7 * c.y};
    }
  }
  building.frame.origin.z = lowest_ground(city, building) - kSunk;
  building.wall += kSunk;
  return building;
}

/// The plain block that is built where a richer shell can't be paid for.
void simplify(Building& building) {
  double reach = std::numeric_limits<double>::infinity();
  for (const Corner& c : building.outline) {
    reach = std::min(reach, std::sqrt(c.x * c.x + c.y * c.y));
  }
  building.kind = BuildingKind::block;
  building.outline = rectangle(0.7 * std::max(reach, 4.0), 0.6 * std::max(reach, 4.0));
}

const char* kind_name(BuildingKind kind) {
  switch (kind) {
    case BuildingKind::block:
      return "block";
    case BuildingKind::gabled:
      return "gabled house";
    case BuildingKind::tower:
      return "tower";
    case BuildingKind::corner:
      return "corner house";
    case BuildingKind::courtyard:
      return "courtyard";
    default:
      return "bastion";
  }
}

Outline scaled(const Outline& outline, double scale) {
  Outline smaller;
  for (const Corner& c : outline) {
    smaller.push_back({scale * c.x, scale * c.y});
  }
  return smaller;
}

void add_shell(Mesh& mesh, const Building& b) {
  switch (b.kind) {
    case BuildingKind::gabled: {
      // Outline of (y, z) extruded along x; the gable has two fifths of the house's width.
      const Corner& corner = b.outline[2];
      const Outline gable{{-corner.y, 0},
                          {corner.y, 0},
                          {corner.y, b.wall},
                          {0, b.wall + 0.8 * corner.y},
                          {-corner.y, b.wall}};
      add_prism(mesh, lengthwise(b.frame), gable, -corner.x, corner.x);
      break;
    }
    case BuildingKind::tower:
      add_prism(mesh, b.frame, b.outline, 0, 0.7 * b.wall);
      add_prism(mesh, b.frame, scaled(b.outline, 0.75), 0.7 * b.wall, b.wall);
      add_frustum(mesh, b.frame, scaled(b.outline, 0.5), scaled(b.outline, 0.1), b.wall,
                  1.2 * b.wall);
      break;
    case BuildingKind::courtyard:
      add_ring(mesh, b.frame, b.outline, scaled(b.outline, 0.45), 0, b.wall);
      break;
    default:
      add_prism(mesh, b.frame, b.outline, 0, b.wall);
      break;
  }
}

/// A frame on the wall: x along it, y outward, at a random place, `inset` meters inside.
Frame on_wall(const Building& b, double inset, double height, Rng& rng) {
  const std::size_t i = rng.below(b.outline.size());
  const Corner& from = b.outline[i];
  const Corner& to = b.outline[i + 1 == b.outline.size() ? 0 : i + 1];
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  const double share = rng.uniform(0.08, 0.92);
  const double out_x = dy / length;
  const double out_y = -dx / length;
  const Vec3 at =
      b.frame.at(from.x + share * dx - inset * out_x, from.y + share * dy - inset * out_y, height);
  const Vec3 out = out_x * b.frame.x + out_y * b.frame.y;
  return {at, cross(out, b.frame.z), out, b.frame.z};
}

void add_detail(Mesh& mesh, const Building& b, Rng& rng) {
  const double lower = b.kind == BuildingKind::tower ? 0.7 * b.wall : b.wall;
  const double kind = rng.unit();
  if (kind < 0.15) {  // balcony
    const Frame at = on_wall(b, 0, kSunk + rng.uniform(0.35, 0.9) * (lower - kSunk), rng);
    add_box(mesh, at, {rng.uniform(0.6, 2), rng.uniform(0.5, 1.2), rng.uniform(0.08, 0.5)});
  } else if (kind < 0.75) {  // window frame, sill, downpipe, sign board
    const Frame at = on_wall(b, 0, kSunk + rng.uniform(0.15, 0.92) * (lower - kSunk), rng);
    const bool tall = rng.unit() < 0.5;
    const double length = rng.uniform(0.3, 1.1);
    const double thin = rng.uniform(0.02, 0.12);
    add_box(mesh, at, {tall ? thin : length, rng.uniform(0.03, 0.2), tall ? length : thin});
  } else {  // chimney, vent, lift house, antenna on the roof
    const double half = rng.unit() < 0.3 ? rng.uniform(0.03, 0.1) : rng.uniform(0.2, 0.9);
    const double tall = rng.uniform(0.3, 1.6);
    const Frame at = on_wall(b, rng.uniform(0.9, 1.6), lower + tall - 0.05, rng);
    add_box(mesh, at, {half, half * rng.uniform(0.6, 1), tall});
  }
}

/// A triangle that hangs from a pole above the middle of the roof.
void add_pennant(Mesh& mesh, const Building& b, std::uint64_t number) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const double z = 1.3 * b.wall + 5 + 0.5 * static_cast<double>(number);
  mesh.vertices.push_back(b.frame.at(0, 0, z));
  mesh.vertices.push_back(b.frame.at(0.9, 0.1, z + 0.2));
  mesh.vertices.push_back(b.frame.at(0, 0, z + 0.4));
  mesh.triangles.push_back({first, first + 1, first + 2});
}

}  // namespace

std::uint64_t lot_count(const City& city) {
  const Lots lots = lots_of(city);
  return lots.blocks * lots.blocks * lots.across * lots.across;
}

std::uint64_t shell_triangles(const Building& building) {
  const std::uint64_t corners = building.outline.size();
  switch (building.kind) {
    case BuildingKind::gabled:
      return prism_triangles(5);
    case BuildingKind::tower:
      return 3 * prism_triangles(corners);
    case BuildingKind::courtyard:
      return 8 * corners;
    default:
      return prism_triangles(corners);
  }
}

std::vector<Building> plan_buildings(const City& city, std::uint64_t budget) {
  const Lots lots = lots_of(city);
  const auto chosen = choose_lots(city, lots, std::max<std::uint64_t>(1, budget / kEach));
  std::vector<Building> buildings;
  std::uint64_t left = budget;
  double weight = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    Building building = draw_building(city, lots, chosen[i]);
    const std::uint64_t reserved = kDetail * (chosen.size() - i - 1);
    if (shell_triangles(building) + reserved > left) {
      simplify(building);
    }
    left -= shell_triangles(building);
    weight += building.wall;
    buildings.push_back(std::move(building));
  }
  // Details by height of the walls; what rounding leaves over moves on to the next building.
  const std::uint64_t details = left / kDetail;
  const double share = static_cast<double>(details) / weight;
  std::uint64_t given = 0;
  double passed = 0;
  for (Building& building : buildings) {
    passed += building.wall;
    const auto until =
        std::min(details, static_cast<std::uint64_t>(std::floor(passed * share + 0.5)));
    building.details = until - given;
    given = until;
  }
  buildings.back().details += details - given;
  return buildings;
}

void add_buildings(City& city, const std::vector<Building>& buildings, std::uint64_t budget,
                   const Limits& limits) {
  Mesh& mesh = city.mesh;
  const std::uint32_t all = open_part(mesh, "buildings");
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    check(limits);
    const Building& b = buildings[i];
    const std::uint32_t part =
        open_part(mesh, std::string(kind_name(b.kind)) + ' ' + std::to_string(i), all);
    add_shell(mesh, b);
    Rng rng = rng_for(city, kDetailKind, b.index);
    for (std::uint64_t k = 0; k < b.details; ++k) {
      add_detail(mesh, b, rng);
    }
    for (std::uint64_t k = 0;
         i + 1 == buildings.size() && mesh.triangles.size() < mesh.parts[all].first + budget; ++k) {
      add_pennant(mesh, b, k);
    }
    close_part(mesh, part);
  }
  close_part(mesh, all);
}

}  // namespace soms::detail
