#include "apps/view/scene/scene_colors.h"

#include "apps/view/drawing/ground_colors.h"
#include "apps/view/drawing/palette.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace soms::view {

namespace {

/// Cells of the coarse grid along the longer side.
constexpr double kCells = 48;

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t v) {
  while (parent[v] != v) {
    parent[v] = parent[parent[v]];
    v = parent[v];
  }
  return v;
}

std::uint64_t hash_of(const Vec3& v) {
  std::uint64_t hash = 0;
  for (const double x : {v.x + 0.0, v.y + 0.0, v.z + 0.0}) {  // -0 and 0 are one
    hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  }
  return hash;
}

/// The first vertex at the place of each: many files repeat vertices for each face.
std::vector<std::uint32_t> first_at_place(const std::vector<Vec3>& vertices) {
  const std::size_t slots = std::bit_ceil(2 * vertices.size() + 1);
  std::vector<std::uint32_t> table(slots, Part::kNoParent);
  std::vector<std::uint32_t> first(vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    first[v] = v;
    if (!(vertices[v] == vertices[v])) {
      continue;  // not a number, which a vertex of no triangle may be
    }
    std::size_t slot = hash_of(vertices[v]) & (slots - 1);
    while (table[slot] != Part::kNoParent && !(vertices[table[slot]] == vertices[v])) {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] == Part::kNoParent) {
      table[slot] = v;
    }
    first[v] = table[slot];
  }
  return first;
}

std::vector<std::uint32_t> cells_of_triangles(const Mesh& mesh) {
  const Box box = soms::bounds(mesh);
  const Vec3 extent = box.extent();
  const double side = std::max(std::max(extent.x, extent.y), extent.z) / kCells;
  const auto cell = [&](double at, double lower) {
    return side > 0 ? static_cast<std::uint32_t>((at - lower) / side) : 0U;
  };
  std::vector<std::uint32_t> cells(mesh.triangles.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Vec3& a = mesh.vertices[mesh.triangles[i][0]];
    cells[i] = cell(a.x, box.lower.x) + 64 * cell(a.y, box.lower.y);
  }
  return cells;
}

std::vector<Color> colors_of(const std::vector<std::uint32_t>& numbers) {
  std::vector<Color> colors(numbers.size());
  std::transform(numbers.begin(), numbers.end(), colors.begin(), part_color);
  return colors;
}

}  // namespace

std::vector<std::uint32_t> parts_of_triangles(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.parts.size());
  std::iota(order.begin(), order.end(), 0U);
  // Large parts first: the innermost is written last. Of equal ones the later wins.
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.parts[a].count > mesh.parts[b].count;
  });
  std::vector<std::uint32_t> parts(mesh.triangles.size(), Part::kNoParent);
  for (const std::uint32_t p : order) {
    std::fill_n(parts.begin() + static_cast<std::ptrdiff_t>(mesh.parts[p].first),
                mesh.parts[p].count, p);
  }
  return parts;
}

std::vector<std::uint32_t> pieces_of_triangles(const Mesh& mesh) {
  std::vector<std::uint32_t> parent = first_at_place(mesh.vertices);
  for (const auto& t : mesh.triangles) {
    const std::uint32_t a = root_of(parent, t[0]);
    parent[root_of(parent, t[1])] = a;
    parent[root_of(parent, t[2])] = a;
  }
  std::vector<std::uint32_t> number(mesh.vertices.size(), Part::kNoParent);
  std::vector<std::uint32_t> pieces(mesh.triangles.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::uint32_t& of_root = number[root_of(parent, mesh.triangles[i][0])];
    if (of_root == Part::kNoParent) {
      of_root = count++;
    }
    pieces[i] = of_root;
  }
  return pieces;
}

std::vector<Color> colors_by_building(const Mesh& mesh) {
  if (mesh.triangles.empty()) {
    return {};
  }
  if (mesh.parts.size() > 1) {
    std::vector<Color> colors = colors_of(parts_of_triangles(mesh));
    color_named_ground(mesh, colors);
    return colors;
  }
  const std::vector<std::uint32_t> pieces = pieces_of_triangles(mesh);
  const std::uint64_t count = *std::max_element(pieces.begin(), pieces.end()) + std::uint64_t{1};
  // A piece of a building has tens of triangles; a file without shared vertices has one a piece.
  const bool scattered = count > 1 && mesh.triangles.size() / count < 4;
  std::vector<Color> colors = colors_of(scattered ? cells_of_triangles(mesh) : pieces);
  color_ground(mesh, pieces, colors);
  return colors;
}

}  // namespace soms::view
