// A closed mesh of awkward numbers at an awkward pose, by any rule in either layout, and points on
// it, beside it and in line with its corners: against brute force, in batches, one by one and by
// two threads. A mesh that lacks triangles is refused or answered alike.
#include "soms/base/error.h"
#include "soms/geometry/closedness.h"
#include "soms/query/contains.h"
#include "soms/query/reference/contains.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/shape.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/poses.h"
#include "tests/fuzz/require.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

using fuzz::Bytes;
using fuzz::require;

/// A number of a lattice, a power of two, or one a step of the last place beside a whole one.
double coordinate(Bytes& bytes, double unit) {
  const double on_lattice = static_cast<double>(bytes.below(5)) - 1;
  switch (bytes.below(5)) {
    case 0:
      return unit * std::ldexp(on_lattice, static_cast<int>(bytes.below(80)) - 60);
    case 1:
      return unit * (on_lattice + std::ldexp(static_cast<double>(bytes.below(7)) - 3, -52));
    case 2:
      return unit * 4 * bytes.fraction();
    default:
      return unit * on_lattice;
  }
}

Vec3 place(Bytes& bytes, double unit) {
  const double x = coordinate(bytes, unit);
  const double y = coordinate(bytes, unit);
  return {x, y, coordinate(bytes, unit)};
}

/// Faces of tetrahedra, some of them left out, doubled or without area.
Mesh mesh_of(Bytes& bytes, double unit) {
  Mesh mesh;
  for (std::uint32_t k = 0, count = 1 + bytes.below(10); k < count; ++k) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int corner = 0; corner < 4; ++corner) {
      mesh.vertices.push_back(place(bytes, unit));
    }
    mesh.triangles.insert(mesh.triangles.end(), {{first, first + 1, first + 2},
                                                 {first, first + 1, first + 3},
                                                 {first + 3, first + 1, first + 2},
                                                 {first, first + 3, first + 2}});
  }
  const std::uint32_t change = bytes.below(8);
  if (change == 0) {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(bytes.below(4)));
  } else if (change == 1) {
    mesh.triangles.push_back({0, 1, bytes.below(2)});
    mesh.triangles.push_back(mesh.triangles[0]);
    mesh.triangles.push_back(mesh.triangles[0]);
  }
  return mesh;
}

/// A point of a triangle, perhaps moved a step or more on an axis, or in line with a vertex.
Vec3 point_of(Bytes& bytes, const Body& body, double unit) {
  const Mesh& mesh = body.shape.mesh();
  const auto any = [&](std::size_t count) {
    return (std::size_t{bytes.byte()} << 8 | bytes.byte()) % count;
  };
  const auto vertex = [&](std::size_t v) { return body.pose.apply(mesh.vertices[v]); };
  const auto& t = mesh.triangles[any(mesh.triangles.size())];
  const Vec3 a = vertex(t[0]);
  Vec3 p = a + (vertex(t[1]) - a) * (0.25 * bytes.below(5)) +
           (vertex(t[2]) - a) * (0.25 * bytes.below(3));
  const std::size_t axis = bytes.below(3);
  const std::uint32_t change = bytes.below(6);
  if (change == 0) {
    p[axis] = std::nextafter(p[axis], bytes.below(2) == 0 ? -1e300 : 1e300);
  } else if (change == 1) {
    p[axis] = vertex(any(mesh.vertices.size()))[axis];
  } else if (change == 2) {
    p[axis] += std::ldexp(unit, static_cast<int>(bytes.below(120)) - 60);
  } else if (change == 3) {
    p = (vertex(any(mesh.vertices.size())) + vertex(any(mesh.vertices.size()))) * 0.5;
  }
  return p;
}

ShapeOptions options_of(Bytes& bytes) {
  const auto table = rules();
  ShapeOptions options;
  options.build.rule = table[bytes.below(static_cast<std::uint32_t>(table.size()))].rule;
  options.build.per_leaf = static_cast<int>(1 + bytes.below(16));
  options.layout = bytes.below(3) == 0 ? Layout::compact : Layout::wide;
  return options;
}

void check_points(const ClosedBody& body, const std::vector<Vec3>& points) {
  const ContainsBatch batch = contains(body, points);
  require(batch.side == reference::contains_by_brute_force(body.body(), points), "a side");
  require(contains(body, points, {}, {.threads = 2}) == batch, "two threads");
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(contains(body, points[i]) == batch.at(i), "a single point");
  }
}

void check_input(Bytes& bytes) {
  const double unit = std::ldexp(1.0, static_cast<int>(bytes.below(120)) - 60);
  const Mesh mesh = mesh_of(bytes, unit);
  Pose pose = fuzz::pose_of(bytes, unit);
  if (bytes.below(4) == 0) {
    pose.m[4 * bytes.below(3) + 3] += std::ldexp(unit, static_cast<int>(bytes.below(64)));
  }
  const Body body(Shape(mesh, options_of(bytes)), pose);
  const bool closed = closedness(mesh, {.pose = pose}).whole.closed;
  try {
    const ClosedBody checked(body);
    require(closed, "an open body");
    std::vector<Vec3> points;
    for (std::uint32_t k = 0, count = 1 + bytes.below(40); k < count; ++k) {
      points.push_back(point_of(bytes, body, unit));
    }
    check_points(checked, points);
  } catch (const Error& error) {
    require(error.kind() == ErrorKind::not_closed && !closed, "a closed body");
  }
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soms::fuzz::Bytes bytes({data, size});
  soms::check_input(bytes);
  return 0;
}
