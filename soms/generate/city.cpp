#include "soms/generate/city.h"

#include "soms/base/arithmetic.h"
#include "soms/base/assert.h"
#include "soms/base/error.h"
#include "soms/generate/detail/buildings.h"
#include "soms/generate/detail/counts.h"
#include "soms/generate/detail/furniture.h"
#include "soms/generate/detail/ground.h"

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

}  // namespace

City generate_city(const CityOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  check_options(options);
  City city;
  city.options = options;
  detail::lay_out(city);
  const std::uint64_t blocks = city.street_lines.size() - 1;
  const std::uint64_t upper =
      options.triangles - detail::ground_triangles(blocks, city.block_cells);
  const auto furniture = detail::plan_furniture(city, 2 * upper / 5);
  std::uint64_t walls = upper;
  for (const detail::Furniture& piece : furniture) {
    walls -= detail::furniture_triangles(piece.kind);
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
  detail::add_buildings(city, buildings, walls, limits);
  detail::add_furniture(city, furniture, limits);
  SOMS_ASSERT(city.mesh.triangles.size() == options.triangles);
  return city;
}

}  // namespace soms
