// A soup of awkward triangles of any size, and of very different ones, at an awkward pose, by any
// rule in either layout, and rays and segments between points on it, beside it and in line with its
// corners: against brute force, in batches, one by one and by two threads.
#include "soms/query/ray.h"
#include "soms/query/reference/ray.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/shape.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/poses.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/scales.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace soms {
namespace {

using fuzz::Bytes;
using fuzz::require;

/// Few numbers, so that corners, edges and planes coincide; some a step or a power beside them.
double awkward_number(Bytes& bytes, double unit) {
  const double whole = unit * (static_cast<double>(bytes.below(4)) - 1);
  const std::uint32_t change = bytes.below(6);
  return change == 0   ? std::nextafter(whole, 1e300)
         : change == 1 ? whole + std::ldexp(unit, -static_cast<int>(bytes.below(60)))
         : change == 2 ? -whole
                       : whole;
}

Vec3 awkward_place(Bytes& bytes, double unit) {
  const double x = awkward_number(bytes, unit);
  const double y = awkward_number(bytes, unit);
  return {x, y, awkward_number(bytes, unit)};
}

Mesh soup(Bytes& bytes, double unit) {
  Mesh mesh;
  double heap = unit;
  for (std::uint32_t k = 0, count = 3 + bytes.below(9); k < count; ++k) {
    heap = bytes.below(4) == 0 ? fuzz::unit_of_heap(bytes, unit) : heap;
    mesh.vertices.push_back(awkward_place(bytes, heap));
  }
  const auto size = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t k = 0, count = 1 + bytes.below(24); k < count; ++k) {
    const std::uint32_t a = bytes.below(size);
    const std::uint32_t b = bytes.below(size);
    if (bytes.below(4) == 0) {  // of one heap, most likely
      mesh.triangles.push_back({a, (a + 1) % size, (a + 2) % size});
    } else {
      mesh.triangles.push_back({a, b, bytes.below(size)});
    }
  }
  return mesh;
}

/// A moved vertex, the middle of two, or a place beside the body, perhaps far.
Vec3 end_of_ray(Bytes& bytes, const Body& body, double unit) {
  const MeshView& mesh = body.shape.mesh();
  const auto vertex = [&] {
    return body.pose.apply(
        mesh.vertices[bytes.below(static_cast<std::uint32_t>(mesh.vertices.size()))]);
  };
  Vec3 p = vertex();
  switch (bytes.below(4)) {
    case 0:
      p = (p + vertex()) * 0.5;
      break;
    case 1:
      p += awkward_place(bytes, unit) * std::ldexp(1.0, static_cast<int>(bytes.below(45)));
      break;
    case 2:
      p += awkward_place(bytes, fuzz::unit_of_heap(bytes, unit));
      break;
    default:
      break;
  }
  return fuzz::within_limits(p);
}

void check_lines(const Body& body, const std::vector<Ray>& lines, const RayOptions& options) {
  const ClosestHitBatch closest = closest_hit(body, lines, options);
  const AnyHitBatch any = any_hit(body, lines, options);
  const AllHits all = all_hits(body, lines, options);
  require(closest_hit(body, lines, options, {.threads = 2}) == closest, "two threads");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ClosestHit twin = reference::closest_hit_by_brute_force(body, lines[i], options.skip);
    twin.cost = closest.costs[i];
    require(closest.at(i) == twin, "the first hit");
    require(closest_hit(body, lines[i], options) == twin, "a single ray");
    require((any.hit[i] != 0) == twin.triangle.has_value(), "any hit");
    AllHits row = reference::all_hits_by_brute_force(body, lines[i], options.skip);
    const AllHits found = all_hits(body, std::span(&lines[i], 1), options);
    row.cost = found.cost;
    row.costs = found.costs;
    require(found == row, "all hits");
    require(all.offsets[i + 1] - all.offsets[i] == row.lower.size(), "a row of a batch");
  }
}

void check_rays(Bytes& bytes) {
  const double unit = fuzz::unit_of(bytes);
  const auto table = rules();
  ShapeOptions shape;
  shape.build.rule = table[bytes.below(static_cast<std::uint32_t>(table.size()))].rule;
  shape.build.per_leaf = static_cast<int>(1 + bytes.below(16));
  shape.layout = bytes.below(3) == 0 ? Layout::compact : Layout::wide;
  const Mesh mesh = soup(bytes, unit);
  const Body body(Shape(mesh, shape), fuzz::pose_of(bytes, unit));
  RayOptions options;
  if (bytes.below(3) == 0) {
    options.skip = bytes.below(static_cast<std::uint32_t>(mesh.triangles.size()));
  }
  std::vector<Ray> rays;
  std::vector<Ray> segments;
  for (std::uint32_t k = 0, count = 1 + bytes.below(20); k < count; ++k) {
    const Vec3 from = end_of_ray(bytes, body, unit);
    const Vec3 to = end_of_ray(bytes, body, unit);
    segments.push_back(Ray::between(from, to));
    Ray ray{from, (to - from) * std::ldexp(1.0, static_cast<int>(bytes.below(200)) - 100)};
    ray.direction = ray.direction == Vec3{} ? Vec3{0, -0.0, 1} : ray.direction;
    if (bytes.below(3) == 0) {
      ray.length = static_cast<double>(bytes.below(5)) * 0.5;
    }
    rays.push_back(ray);
  }
  check_lines(body, rays, options);
  check_lines(body, segments, options);
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soms::fuzz::Bytes bytes({data, size});
  soms::check_rays(bytes);
  return 0;
}
