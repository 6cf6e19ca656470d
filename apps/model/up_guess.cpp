#include "apps/model/up_guess.h"

#include "soms/base/box.h"

#include <array>
#include <cstddef>

namespace soms::command {

namespace {

/// Shares of the ground plan that the two ends of an axis span.
struct Ends {
  double lower = 0;
  double upper = 0;

  /// How much wider the base is than the top.
  [[nodiscard]] double taper() const { return lower - upper; }
};

using Coordinates = std::array<double, 3>;

Coordinates coordinates(const Vec3& v) {
  return {v.x, v.y, v.z};
}

/// Area of a box square to an axis; 0 if it is empty.
double plan_area(const Box& box, std::size_t axis) {
  if (box.empty()) {
    return 0;
  }
  const Coordinates extent = coordinates(box.extent());
  return extent[(axis + 1) % 3] * extent[(axis + 2) % 3];
}

Ends ends_along(const MeshView& mesh, const Box& whole, std::size_t axis) {
  constexpr double kEnd = 0.05;  // of the extent
  const double plan = plan_area(whole, axis);
  if (!(plan > 0)) {
    return {};
  }
  const double lower = coordinates(whole.lower)[axis];
  const double upper = coordinates(whole.upper)[axis];
  const double depth = kEnd * (upper - lower);
  Box base;
  Box top;
  for (const auto& triangle : mesh.triangles) {
    for (const auto corner : triangle) {
      const Vec3& at = mesh.vertices[corner];
      const double height = coordinates(at)[axis];
      if (height <= lower + depth) {
        base.grow(at);
      }
      if (height >= upper - depth) {
        top.grow(at);
      }
    }
  }
  return {plan_area(base, axis) / plan, plan_area(top, axis) / plan};
}

}  // namespace

bool looks_y_up(const MeshView& mesh) {
  constexpr double kClearly = 0.1;
  const Box whole = bounds(mesh);
  if (mesh.triangles.empty()) {
    return false;
  }
  const Ends y = ends_along(mesh, whole, 1);
  const Ends z = ends_along(mesh, whole, 2);
  return y.taper() > z.taper() + kClearly && y.lower > z.lower;
}

}  // namespace soms::command
