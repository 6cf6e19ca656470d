#include "thesis/trees/toy_sets.h"

#include "soms/geometry/midpoint.h"
#include "soms/tree/rule/rules.h"

#include <array>

namespace soms::reproduce {

namespace {

void add(Mesh& mesh, const Triangle& triangle) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {triangle.a, triangle.b, triangle.c});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/// A triangle in the plane whose thesis midpoint is (x, y): A and B below, C above it.
Triangle around(double x, double y, double width, double height) {
  return {{x - width / 2, y - height / 2, 0},
          {x + width / 2, y - height / 2, 0},
          {x, y + height / 2, 0}};
}

Mesh alike() {
  Mesh mesh;
  constexpr std::array<std::array<double, 2>, 8> kPlaces{
      {{1, 2}, {2, 5}, {3, 1}, {4, 4}, {5, 2}, {7, 5}, {12, 2}, {18, 4}}};
  for (const auto& [x, y] : kPlaces) {
    add(mesh, around(x, y, 1.6, 1.6));
  }
  return mesh;
}

Mesh one_large() {
  Mesh mesh;
  // C is near, A and B are far: the midpoint lies left of the middle of the box.
  add(mesh, {{8, 1, 0}, {24, 0, 0}, {0, 6, 0}});
  for (const double x : {1.0, 3.0, 5.0}) {
    add(mesh, around(x, 3, 1.4, 2));
  }
  return mesh;
}

Mesh each_larger() {
  Mesh mesh;
  // The midpoint of the largest lies at two fifths of its width, before the middle of the box.
  for (const double size : {16.0, 8.0, 4.0, 2.0, 1.0}) {
    add(mesh, {{0.6 * size, 0, 0}, {size, 0, 0}, {0, 0.4 * size, 0}});
  }
  return mesh;
}

Mesh one_midpoint() {
  Mesh mesh;
  for (const double size : {6.0, 4.0, 2.0}) {
    add(mesh, around(10, 3, 3 * size, size));
  }
  return mesh;
}

Mesh same_on_long_axis() {
  Mesh mesh;
  for (const double y : {1.0, 3.0, 5.0}) {
    add(mesh, around(10, y, 20, 1.2));
  }
  return mesh;
}

/// A tent: four triangles on a square around (x, y).
void add_tent(Mesh& mesh, double x, double y, double height) {
  const Vec3 top{x, y, height};
  const std::array<Vec3, 4> feet{
      {{x - 1, y - 1, 0}, {x + 1, y - 1, 0}, {x + 1, y + 1, 0}, {x - 1, y + 1, 0}}};
  for (std::size_t k = 0; k < 4; ++k) {
    add(mesh, {feet[k], feet[(k + 1) % 4], top});
  }
}

}  // namespace

std::vector<ToySet> flat_toy_sets() {
  return {{"alike", "Triangles alike", alike()},
          {"one_large", "One triangle much larger", one_large(), true},
          {"each_larger", "Each twice as large", each_larger(), true},
          {"one_midpoint", "All midpoints equal", one_midpoint(), true},
          {"same_on_long_axis", "Midpoints equal on the long axis", same_on_long_axis()}};
}

ToySet grid_toy_set() {
  Mesh mesh;
  add(mesh, {{20, -2, 0}, {28, 2, 0}, {6, 2, 0}});  // its midpoint is (15, 1)
  for (const double y : {1.0, 4.0}) {
    for (const double x : {1.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0}) {
      if (x < 15 || y > 1) {
        add(mesh, around(x, y, 1.5, 1.5));
      }
    }
  }
  return {"grid", "Fifteen small triangles and a large one", std::move(mesh), true};
}

ToySet solid_toy_set() {
  Mesh mesh;
  // Its midpoint lies left of the middle of the box, as those of the houses do.
  add(mesh, {{24, 0, 0}, {20, 8, 0}, {0, 0, 0}});
  add_tent(mesh, 2, 5, 3);
  add_tent(mesh, 5, 3, 2);
  add_tent(mesh, 6, 6.5, 4);
  add_tent(mesh, 9.5, 4.5, 2.5);
  return {"houses", "Four houses on a large ground triangle", std::move(mesh), true};
}

ToySet space_toy_set() {
  Mesh mesh;
  add(mesh, {{2, 2, 2}, {4, 2, 2}, {3, 4, 3}});
  add(mesh, {{5, 1, 1}, {7, 2, 2}, {6, 3, 4}});
  add(mesh, {{1, 4, 4}, {3, 6, 3}, {0, 5, 2}});
  add(mesh, {{4, 5, 5}, {6, 6, 3}, {5, 3, 2}});
  return {"space", "Four triangles in space", std::move(mesh)};
}

ToySet eight_toy_set() {
  Mesh mesh;
  for (const double y : {1.0, 3.5}) {
    for (const double x : {1.0, 3.0, 5.0, 7.0}) {
      add(mesh, around(x, y, 1.5, 1.5));
    }
  }
  return {"eight", "Eight triangles alike", std::move(mesh)};
}

Mesh triangles_at(const std::vector<Vec3>& midpoints) {
  Mesh mesh;
  for (const Vec3& at : midpoints) {
    const Triangle flat = around(at.x, at.y, 0.5, 0.5);
    const Vec3 up{0, 0, at.z};
    add(mesh, {flat.a + up, flat.b + up, flat.c + up});
  }
  return mesh;
}

Mesh some_of(const Mesh& mesh, const std::vector<TriangleId>& which) {
  Mesh part;
  part.vertices = mesh.vertices;
  for (const TriangleId id : which) {
    part.triangles.push_back(mesh.triangles[id]);
  }
  return part;
}

ToySplit split_toy(const Mesh& mesh, Rule rule) {
  const BuildOptions options = thesis_options(rule);
  const RuleEntry& row = entry(rule);
  ToySplit split;
  std::vector<Primitive> primitives;
  for (TriangleId id = 0; id < mesh.triangles.size(); ++id) {
    const Triangle triangle = mesh.triangle(id);
    const Vec3 m = midpoint(triangle, options.midpoint, options.c_vertex);
    split.midpoints.push_back(m);
    split.inner.grow(m);
    split.outer.grow(bounds(triangle));
    primitives.push_back({.midpoint = {m.x, m.y, m.z}, .id = id});
  }
  const AxisFrom from = options.axis_from.value_or(row.axis_from);
  const Vec3 extent = (from == AxisFrom::inner ? split.inner : split.outer).extent();
  const std::size_t axis =
      extent.y > extent.x ? (extent.z > extent.y ? 2 : 1) : (extent.z > extent.x ? 2 : 0);
  const Split found = row.split({primitives, split.inner, split.outer, 1}, axis);
  split.axis = found.axis;
  split.plane = found.value;
  for (const Primitive& primitive : primitives) {
    split.left.push_back(found.is_left(primitive));
    split.left_count += split.left.back() ? 1U : 0U;
  }
  return split;
}

}  // namespace soms::reproduce
