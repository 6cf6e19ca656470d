// A closed mesh of awkward numbers at an awkward pose, by any rule in either layout, and points on
// it, beside it and in line with its corners: against brute force, in batches, one by one and by
// two threads. A mesh that lacks triangles is refused or answered alike.
#include "soms/base/error.h"
#include "soms/geometry/closedness.h"
#include "soms/query/contains.h"
#include "soms/query/reference/contains.h"
#include "soms/tree/shape.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/closed_mesh.h"
#include "tests/fuzz/poses.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/scales.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

using fuzz::Bytes;
using fuzz::require;

/// A point of a triangle, perhaps moved a step or more on an axis, or in line with a vertex.
Vec3 point_of(Bytes& bytes, const Body& body, double unit) {
  const MeshView& mesh = body.shape.mesh();
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
    p[axis] += fuzz::far_by(unit, static_cast<int>(bytes.below(120)) - 60);
  } else if (change == 3) {
    p = (vertex(any(mesh.vertices.size())) + vertex(any(mesh.vertices.size()))) * 0.5;
  }
  return fuzz::within_limits(p);
}

void check_points(const ClosedBody& body, const std::vector<Vec3>& points) {
  const ContainsBatch batch = contains(body, points);
  require(batch.side == reference::contains_by_brute_force(body.body(), points), "a side");
  require(contains(body, points, {.threads = 2}) == batch, "two threads");
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(contains(body, points[i]) == batch.at(i), "a single point");
  }
}

void check_input(Bytes& bytes) {
  const double unit = fuzz::unit_of(bytes);
  const Mesh mesh = fuzz::closed_mesh(bytes, unit);
  Pose pose = fuzz::pose_of(bytes, unit);
  if (bytes.below(4) == 0) {
    pose.m[4 * bytes.below(3) + 3] += fuzz::far_by(unit, static_cast<int>(bytes.below(64)));
  }
  const Body body(Shape(mesh, fuzz::shape_options(bytes)), pose);
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
