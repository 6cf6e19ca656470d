#include "soms/generate/city.h"

#include "soms/base/arithmetic.h"
#include "soms/base/assert.h"
#include "soms/base/error.h"
#include "soms/generate/detail/buildings.h"
#include "soms/generate/detail/counts.h"
#include "soms/generate/detail/furniture.h"
#include "soms/generate/detail/ground.h"
#include "soms/generate/detail/pavement.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace soms {

namespace {

constexpr std::uint64_t kLeastTriangles = 1000;
constexpr double kLeastSize = 200;
constexpr double kMostSize = 100'000;

void check_options(const CityOptions& options) {
  const std::string place = "city of " + std::to_string(options.triangles) + " triangles";
  if (options.triangles < kLeastTriangles) {
    throw Error(ErrorKind::usage, place, "the least is " + std::to_string(kLeastTriangles));
  }
  if (options.triangles > detail::kMostTriangles) {
    throw Error(ErrorKind::usage, place, "the most is " + std::to_string(detail::kMostTriangles));
  }
  // Written so that NaN fails too.
  if (!(options.size >= kLeastSize && options.size <= kMostSize)) {
    throw Error(ErrorKind::usage, "city of size " + std::to_string(options.size),
                "the size is a finite number of meters, 200 to 100,000");
  }
}

/// Triangles for street furniture out of those above the ground. On paved streets, whose vehicles
/// take more, it gets what buildings do not need.
std::uint64_t furniture_budget(const City& city, std::uint64_t upper) {
  constexpr std::uint64_t kBuilding = 100;
  return city.options.streets == CityStreets::bare
             ? 2 * upper / 5
             : upper - std::min(2 * upper / 5, kBuilding * detail::lot_count(city));
}

}  // namespace

double city_size(std::uint64_t triangles) {
  const double side = std::round(std::sqrt(3 * static_cast<double>(triangles)));
  return std::clamp(side, kLeastSize, kMostSize);
}

City generate_city(const CityOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  check_options(options);
  City city;
  city.options = options;
  detail::lay_out(city);
  const std::uint64_t blocks = city.street_lines.size() - 1;
  const std::uint64_t upper = options.triangles -
                              detail::ground_triangles(blocks, city.block_cells) -
                              detail::pavement_triangles(city);
  const auto furniture = detail::plan_furniture(city, furniture_budget(city, upper));
  std::uint64_t walls = upper;
  for (const detail::Furniture& piece : furniture) {
    walls -= detail::furniture_triangles(piece.kind, options.streets);
  }
  check(limits);
  const auto buildings = detail::plan_buildings(city, walls);
  city.mesh.unit = 1;
  city.mesh.up = UpAxis::z;
  city.mesh.source = "generated city";
  city.mesh.triangles.reserve(options.triangles);
  city.mesh.vertices.reserve(options.triangles * 3 / 4 + 64);
  detail::add_terrain(city);
  detail::add_roads(city);
  detail::add_pavement(city);
  detail::add_buildings(city, buildings, walls, limits);
  detail::add_furniture(city, furniture, limits);
  SOMS_ASSERT(city.mesh.triangles.size() == options.triangles);
  return city;
}

}  // namespace soms
