#include "soms/generate/detail/furniture.h"

#include "soms/generate/detail/ground.h"
#include "soms/generate/detail/vehicles.h"

#include <algorithm>
#include <string>

namespace soms::detail {

namespace {

constexpr double kClear = 6;           ///< meters without furniture beside a crossing
constexpr double kBay = 8;             ///< least length of a bay: a van and room to spare
constexpr std::uint64_t kBayKind = 5;  ///< tags of `rng_for`
constexpr std::uint64_t kShapeKind = 6;
constexpr std::uint64_t kOrderFurniture = 7;

/// Bays of all streets: `along` bays on both sides between two crossings.
struct Bays {
  std::uint64_t lines = 0;
  std::uint64_t along = 0;
  double length = 0;

  [[nodiscard]] std::uint64_t count() const { return 2 * lines * (lines - 1) * 2 * along; }
};

Bays bays_of(const City& city) {
  Bays bays;
  const double free = city.street_spacing - city.street_width - 2 * kClear;
  bays.lines = city.street_lines.size();
  bays.along = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(free / kBay));
  bays.length = free / static_cast<double>(bays.along);
  return bays;
}

FurnitureKind draw_furniture(Rng& rng) {
  const double r = rng.unit();
  return r < 0.12   ? FurnitureKind::lamp
         : r < 0.28 ? FurnitureKind::tree
         : r < 0.34 ? FurnitureKind::bench
         : r < 0.50 ? FurnitureKind::sign
         : r < 0.62 ? FurnitureKind::bin
         : r < 0.86 ? FurnitureKind::car
                    : FurnitureKind::van;
}

/// Distance from the center line of the street.
double draw_offset(FurnitureKind kind, Rng& rng) {
  switch (kind) {
    case FurnitureKind::lamp:
    case FurnitureKind::sign:
      return rng.uniform(7.45, 7.75);
    case FurnitureKind::car:
    case FurnitureKind::van:
      return rng.uniform(5.85, 6.25);
    default:
      return rng.uniform(8.7, 9.4);
  }
}

Furniture draw_piece(const City& city, const Bays& bays, std::uint64_t bay) {
  Rng rng = rng_for(city, kBayKind, bay);
  Furniture piece;
  piece.index = bay;
  piece.kind = draw_furniture(rng);
  const std::uint64_t place = bay % bays.along;
  const std::uint64_t segment = bay / bays.along / 4;
  const bool left = bay / bays.along % 2 == 0;
  const bool northward = bay / bays.along / 2 % 2 == 0;
  const double line = city.street_lines[segment % bays.lines];
  const double slack = 0.5 * (bays.length - kBay) + 1;
  const double along = city.street_lines[segment / bays.lines] + 0.5 * city.street_width + kClear +
                       bays.length * (static_cast<double>(place) + 0.5) +
                       rng.uniform(-slack, slack);
  const double offset = draw_offset(piece.kind, rng) * (left ? -1 : 1);
  const double x = northward ? line + offset : along;
  const double y = northward ? along : line + offset;
  // x runs along the street so that y points away from it; a little askew.
  const double turns =
      (northward ? (left ? 0.25 : 0.75) : (left ? 0.5 : 0)) + rng.uniform(-0.006, 0.006);
  piece.frame = upright({x, y, city.ground(x, y)}, on_circle(turns));
  return piece;
}

void add_lamp(Mesh& mesh, const Frame& f, Rng& rng) {
  const double height = rng.uniform(6, 8.5);
  add_frustum(mesh, f, regular(6, 0.11), regular(6, 0.06), 0, height);
  add_box(mesh, f.moved(0, -0.7, height - 0.1), {0.04, 0.7, 0.04});
  add_box(mesh, f.moved(0, -1.5, height - 0.12), {0.14, 0.3, 0.07});
}

void add_tree(Mesh& mesh, const Frame& f, Rng& rng) {
  const double trunk = rng.uniform(2.2, 3.2);
  const double crown = rng.uniform(1.0, 1.8);
  add_frustum(mesh, f, regular(5, 0.2), regular(5, 0.12), 0, trunk + 0.5 * crown);
  std::vector<double> swell(21);
  for (double& s : swell) {
    s = rng.uniform(0.7, 1.15);
  }
  add_ellipsoid(mesh, f.moved(0, 0, trunk + crown), {0.55 * crown, 0.55 * crown, crown}, 7, 3,
                swell);
}

void add_bench(Mesh& mesh, const Frame& f) {
  add_box(mesh, f.moved(0, 0, 0.45), {0.8, 0.22, 0.03});
  add_box(mesh, f.moved(0, 0.24, 0.75), {0.8, 0.02, 0.22});
  add_box(mesh, f.moved(-0.65, 0, 0.21), {0.04, 0.2, 0.21});
  add_box(mesh, f.moved(0.65, 0, 0.21), {0.04, 0.2, 0.21});
}

void add_sign(Mesh& mesh, const Frame& f, Rng& rng) {
  const double height = rng.uniform(2.2, 3);
  add_prism(mesh, f, regular(3, 0.05), 0, height);
  add_prism(mesh, lengthwise(f.moved(0.06, 0, height)), regular(3, rng.uniform(0.25, 0.4)), 0,
            0.02);
}

void add_wheels(Mesh& mesh, const Frame& f, double axle, double track, double radius) {
  const Outline rim = regular(6, radius);
  for (const double x : {axle, -axle}) {
    for (const double y : {track, -track}) {
      add_prism(mesh, crosswise(f.moved(x, y, radius)), rim, -0.1, 0.1);
    }
  }
}

void add_parked_car(Mesh& mesh, const Frame& f, Rng& rng) {
  const double half = rng.uniform(1.9, 2.3);
  add_box(mesh, f.moved(0, 0, 0.57), {half, 0.85, 0.33});
  add_frustum(mesh, f.moved(-0.1 * half, 0, 0), rectangle(0.62 * half, 0.82),
              rectangle(0.4 * half, 0.65), 0.85, rng.uniform(1.35, 1.55));
  add_wheels(mesh, f, 0.6 * half, 0.78, 0.3);
}

void add_parked_van(Mesh& mesh, const Frame& f, Rng& rng) {
  const double half = rng.uniform(2.3, 2.6);
  const double height = rng.uniform(1.9, 2.4);
  // Side view of (z, x): a sloping front.
  const Outline side{
      {0.25, half}, {0.25, -half}, {height, -half}, {height, 0.55 * half}, {1.1, half}};
  add_prism(mesh, crosswise(f), side, -0.95, 0.95);
  add_wheels(mesh, f, 0.62 * half, 0.88, 0.33);
}

bool has_shape(FurnitureKind kind, CityStreets streets) {
  return streets == CityStreets::paved &&
         (kind == FurnitureKind::car || kind == FurnitureKind::van);
}

void add_piece(Mesh& mesh, const Furniture& piece, CityStreets streets, Rng& rng) {
  if (has_shape(piece.kind, streets)) {
    const Vehicle kind = piece.kind == FurnitureKind::car ? Vehicle::sedan : Vehicle::van;
    return add_vehicle(mesh, piece.frame, kind, Finish::parked, rng.uniform(0.92, 1.04));
  }
  switch (piece.kind) {
    case FurnitureKind::lamp:
      return add_lamp(mesh, piece.frame, rng);
    case FurnitureKind::tree:
      return add_tree(mesh, piece.frame, rng);
    case FurnitureKind::bench:
      return add_bench(mesh, piece.frame);
    case FurnitureKind::sign:
      return add_sign(mesh, piece.frame, rng);
    case FurnitureKind::bin:
      return add_prism(mesh, piece.frame, regular(8, 0.28), 0, rng.uniform(0.8, 1.1));
    case FurnitureKind::car:
      return add_parked_car(mesh, piece.frame, rng);
    case FurnitureKind::van:
      return add_parked_van(mesh, piece.frame, rng);
  }
}

const char* kind_name(FurnitureKind kind) {
  switch (kind) {
    case FurnitureKind::lamp:
      return "lamp";
    case FurnitureKind::tree:
      return "tree";
    case FurnitureKind::bench:
      return "bench";
    case FurnitureKind::sign:
      return "sign";
    case FurnitureKind::bin:
      return "bin";
    case FurnitureKind::car:
      return "parked car";
    default:
      return "parked van";
  }
}

}  // namespace

std::uint64_t furniture_triangles(FurnitureKind kind, CityStreets streets) {
  if (has_shape(kind, streets)) {
    return vehicle_triangles(Finish::parked);
  }
  switch (kind) {
    case FurnitureKind::lamp:
      return prism_triangles(6) + 24;
    case FurnitureKind::tree:
      return prism_triangles(5) + 42;
    case FurnitureKind::bench:
      return 48;
    case FurnitureKind::sign:
      return 2 * prism_triangles(3);
    case FurnitureKind::bin:
      return prism_triangles(8);
    case FurnitureKind::car:
      return 24 + 4 * prism_triangles(6);
    default:
      return prism_triangles(5) + 4 * prism_triangles(6);
  }
}

std::vector<Furniture> plan_furniture(const City& city, std::uint64_t budget) {
  const Bays bays = bays_of(city);
  std::vector<std::uint64_t> order(bays.count());
  for (std::uint64_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  Rng rng = rng_for(city, kOrderFurniture, 0);
  std::vector<Furniture> pieces;
  std::uint64_t left = budget;
  // A shuffle that stops when the money is spent.
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::swap(order[i], order[i + rng.below(order.size() - i)]);
    const Furniture piece = draw_piece(city, bays, order[i]);
    const std::uint64_t cost = furniture_triangles(piece.kind, city.options.streets);
    if (cost > left) {
      break;
    }
    left -= cost;
    pieces.push_back(piece);
  }
  return pieces;
}

void add_furniture(City& city, const std::vector<Furniture>& pieces, const Limits& limits) {
  const std::uint32_t all = open_part(city.mesh, "furniture");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    check(limits);
    const std::uint32_t part =
        open_part(city.mesh, std::string(kind_name(pieces[i].kind)) + ' ' + std::to_string(i), all);
    Rng rng = rng_for(city, kShapeKind, pieces[i].index);
    add_piece(city.mesh, pieces[i], city.options.streets, rng);
    close_part(city.mesh, part);
  }
  close_part(city.mesh, all);
}

}  // namespace soms::detail
