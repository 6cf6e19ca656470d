#include "soms/generate/shapes.h"

#include "soms/base/arithmetic.h"
#include "soms/generate/detail/circle.h"
#include "soms/generate/detail/counts.h"
#include "soms/generate/detail/solids.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace soms {

namespace {

constexpr double kTubeRadius = 0.4;

/// A grid of quads: `rows` by `columns`, and how many quads get a vertex in their middle.
struct Grid {
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;
  std::uint64_t split = 0;
};

/// Grid of about `aspect` times as many rows as columns whose quads, one triangle pair each, and
/// split quads, one pair more, make `pairs`. Prefers a grid that needs no split.
Grid grid_of(std::uint64_t pairs, double aspect, std::uint64_t least_columns,
             std::uint64_t least_rows) {
  const double ideal = std::sqrt(static_cast<double>(pairs) / aspect);
  const auto wanted = std::max(least_columns, static_cast<std::uint64_t>(std::floor(ideal + 0.5)));
  for (std::uint64_t off = 0; off <= wanted / 3; ++off) {
    for (const std::uint64_t columns : {wanted + off, wanted - off}) {
      if (columns >= least_columns && pairs % columns == 0 && pairs / columns >= least_rows) {
        return {pairs / columns, columns, 0};
      }
    }
  }
  const std::uint64_t columns = std::min(wanted, pairs / least_rows);
  return {pairs / columns, columns, pairs % columns};
}

/// Puts a vertex on the diagonal of `count` quads that start at triangle `first`, two triangles
/// each, and returns the number of the first new vertex.
std::size_t split_quads(Mesh& mesh, std::size_t first, std::uint64_t count) {
  const std::size_t added = mesh.vertices.size();
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    auto& one = mesh.triangles[first + 2 * i];
    auto& two = mesh.triangles[first + 2 * i + 1];
    const std::uint32_t a = one[0];
    const std::uint32_t b = one[1];
    const std::uint32_t c = one[2];
    const std::uint32_t d = two[2];
    mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[c]));
    one = {a, b, middle};
    two = {a, middle, d};
    mesh.triangles.push_back({b, c, middle});
    mesh.triangles.push_back({c, d, middle});
  }
  return added;
}

Vec3 unit(const Vec3& v) {
  return (1 / std::sqrt(dot(v, v))) * v;
}

/// Point and direction of the knot's center line at a share of its length parameter.
struct OnKnot {
  Vec3 point;
  Vec3 tangent;
};

OnKnot on_knot(std::size_t i, std::size_t n) {
  const detail::OnCircle two = detail::on_circle(2 * i, n);
  const detail::OnCircle three = detail::on_circle(3 * i, n);
  const double r = 2 + three.cosine;
  const double slope = -3 * three.sine;
  return {{r * two.cosine, r * two.sine, -three.sine},
          unit({slope * two.cosine - 2 * r * two.sine, slope * two.sine + 2 * r * two.cosine,
                -3 * three.cosine})};
}

void add_knot_vertices(Mesh& mesh, const Grid& grid) {
  double reach = 0;
  for (std::size_t i = 0; i < grid.rows; ++i) {
    const OnKnot at = on_knot(i, grid.rows);
    const Vec3 u = unit(cross(at.tangent, at.point));
    const Vec3 v = cross(at.tangent, u);
    for (std::size_t j = 0; j < grid.columns; ++j) {
      const detail::OnCircle p = detail::on_circle(j, grid.columns);
      const Vec3 vertex = at.point + kTubeRadius * (p.cosine * u + p.sine * v);
      reach = std::max(reach, dot(vertex, vertex));
      mesh.vertices.push_back(vertex);
    }
  }
  const double scale = 1 / std::sqrt(reach);
  for (Vec3& vertex : mesh.vertices) {
    vertex = scale * vertex;
  }
}

}  // namespace

Mesh generate_knot(std::uint64_t triangles) {
  const PlainArithmetic plain;
  detail::check_closed_count("knot", triangles, 18);
  const Grid grid = grid_of(triangles / 2, 8, 3, 3);
  Mesh mesh;
  mesh.up = UpAxis::z;
  mesh.source = "generated knot";
  add_knot_vertices(mesh, grid);
  mesh.triangles.reserve(triangles);
  const auto id = [&](std::uint64_t i, std::uint64_t j) {
    return static_cast<std::uint32_t>((i % grid.rows) * grid.columns + j % grid.columns);
  };
  for (std::uint64_t i = 0; i < grid.rows; ++i) {
    for (std::uint64_t j = 0; j < grid.columns; ++j) {
      mesh.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i + 1, j)});
    }
  }
  split_quads(mesh, 0, grid.split);
  const std::uint32_t part = detail::open_part(mesh, "knot");
  mesh.parts[part].first = 0;
  detail::close_part(mesh, part);
  return mesh;
}

Mesh generate_sphere(std::uint64_t triangles) {
  const PlainArithmetic plain;
  detail::check_closed_count("sphere", triangles, 8);
  const std::uint64_t pairs = triangles / 2;
  // A single ring has no quads to split; with so few triangles it needs none.
  const Grid grid = pairs < 6 ? Grid{1, pairs, 0} : grid_of(pairs, 0.5, 3, 2);
  Mesh mesh;
  mesh.up = UpAxis::z;
  mesh.source = "generated sphere";
  mesh.triangles.reserve(triangles);
  const std::uint32_t part = detail::open_part(mesh, "sphere");
  detail::add_ellipsoid(mesh, {}, {1, 1, 1}, static_cast<std::uint32_t>(grid.columns),
                        static_cast<std::uint32_t>(grid.rows));
  const std::size_t added = split_quads(mesh, 2 * grid.columns, grid.split);
  for (std::size_t v = added; v < mesh.vertices.size(); ++v) {
    mesh.vertices[v] = unit(mesh.vertices[v]);
  }
  detail::close_part(mesh, part);
  return mesh;
}

}  // namespace soms
