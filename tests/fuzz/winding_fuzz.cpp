// Any triangles of awkward numbers at an awkward pose, most of a closed mesh that lacks some, and
// points on them, beside them by any step and in line with their corners: brackets against brute
// force, by any width, in batches, one by one and by two threads.
#include "soms/query/contains.h"
#include "soms/query/reference/winding.h"
#include "soms/query/winding.h"
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

/// A point of a triangle's plane, or one off it by any power of two.
Vec3 winding_point(Bytes& bytes, const Body& body, double unit) {
  const MeshView& mesh = body.shape.mesh();
  const auto& t = mesh.triangles[bytes.byte() % mesh.triangles.size()];
  const auto vertex = [&](std::size_t k) { return body.pose.apply(mesh.vertices[t[k]]); };
  Vec3 p = vertex(0) + (vertex(1) - vertex(0)) * (0.25 * bytes.below(7) - 0.25) +
           (vertex(2) - vertex(0)) * (0.25 * bytes.below(5) - 0.25);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t change = bytes.below(4);
    if (change == 0) {
      p[axis] += fuzz::far_by(unit, static_cast<int>(bytes.below(120)) - 90);
    } else if (change == 1) {
      p[axis] = body.pose.apply(mesh.vertices[bytes.byte() % mesh.vertices.size()])[axis];
    }
  }
  return fuzz::within_limits(p);
}

void check_winding(Bytes& bytes) {
  const double unit = fuzz::unit_of(bytes);
  Mesh mesh = fuzz::closed_mesh(bytes, unit);
  for (std::uint32_t k = bytes.below(12); k > 0 && mesh.triangles.size() > 1; --k) {
    mesh.triangles.erase(mesh.triangles.begin() +
                         static_cast<std::ptrdiff_t>(bytes.byte() % mesh.triangles.size()));
  }
  Pose pose = fuzz::pose_of(bytes, unit);
  if (bytes.below(4) == 0) {  // perhaps so far that the body moves to a few places
    pose.m[4 * bytes.below(3) + 3] += fuzz::far_by(unit, static_cast<int>(bytes.below(64)));
  }
  const Body body(Shape(mesh, fuzz::shape_options(bytes)), pose);
  const WindingIndex index(body);
  const WindingOptions options{.width = std::ldexp(1.0, -static_cast<int>(bytes.below(60)))};
  std::vector<Vec3> points;
  for (std::uint32_t k = 0, count = 1 + bytes.below(20); k < count; ++k) {
    points.push_back(winding_point(bytes, body, unit));
  }
  const WindingBatch batch = winding(index, points, options);
  require(winding(index, points, options, {.threads = 2}) == batch, "two threads");
  const std::vector<Bracket> twin = reference::winding_by_brute_force(body, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Bracket number = batch.at(i).number;
    require(number.lower <= number.upper, "a bracket");
    require(number.lower <= twin[i].upper && twin[i].lower <= number.upper, "a winding number");
    require(winding(index, points[i], options) == batch.at(i), "a single point");
  }
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soms::fuzz::Bytes bytes({data, size});
  soms::check_winding(bytes);
  return 0;
}
