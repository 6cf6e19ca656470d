// Which triangles go to which tile, and the mesh of a tile.
#include "soms/base/error.h"
#include "soms/geometry/parts_of.h"
#include "soms/tiles/cut_tiles.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace soms {

namespace {

/// What stays together: a part, or a triangle.
struct Item {
  Vec3 center;
  std::size_t begin = 0;  ///< of its triangles in `Items::triangles`
  std::size_t end = 0;
  bool of_split_part = false;

  [[nodiscard]] std::size_t size() const { return end - begin; }
};

struct Items {
  std::vector<TriangleId> triangles;  ///< part by part, ascending within each
  std::vector<Item> items;
};

std::vector<TriangleId> by_parts(const std::vector<std::uint32_t>& part) {
  std::vector<TriangleId> order(part.size());
  std::iota(order.begin(), order.end(), TriangleId{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](TriangleId a, TriangleId b) { return part[a] < part[b]; });
  return order;
}

Items items_of(const MeshView& mesh, std::size_t most) {
  const PartsOf parts(mesh);
  std::vector<std::uint32_t> part(mesh.triangles.size());
  for (std::size_t i = 0; i < part.size(); ++i) {
    part[i] = first_run(mesh, parts(static_cast<TriangleId>(i)));
  }
  Items result{by_parts(part), {}};
  const std::vector<TriangleId>& triangles = result.triangles;
  const auto add = [&](std::size_t begin, std::size_t end, bool split) {
    Box box;
    for (std::size_t k = begin; k < end; ++k) {
      box.grow(bounds(mesh.triangle(triangles[k])));
    }
    // Halves first: the sum of two coordinates may be beyond what a double holds.
    result.items.push_back({0.5 * box.lower + 0.5 * box.upper, begin, end, split});
  };
  for (std::size_t begin = 0; begin < triangles.size();) {
    std::size_t end = begin;
    while (end < triangles.size() && part[triangles[end]] == part[triangles[begin]]) {
      ++end;
    }
    const bool named = part[triangles[begin]] != Part::kNoParent;
    if (named && end - begin <= most) {
      add(begin, end, false);
    } else {
      for (std::size_t k = begin; k < end; ++k) {
        add(k, k + 1, named);
      }
    }
    begin = end;
  }
  return result;
}

std::size_t longest_side(std::span<const Item> items) {
  Box box;
  for (const Item& item : items) {
    box.grow(item.center);
  }
  const Vec3 extent = box.extent();
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    axis = extent[k] > extent[axis] ? k : axis;
  }
  return axis;
}

/// Sorts items along their longest side, and gives how many of them, at least one and not all, have
/// half of the triangles.
std::size_t halve(std::span<Item> items, std::size_t triangles) {
  const std::size_t axis = longest_side(items);
  std::sort(items.begin(), items.end(), [axis](const Item& a, const Item& b) {
    return a.center[axis] != b.center[axis] ? a.center[axis] < b.center[axis] : a.begin < b.begin;
  });
  std::size_t count = 0;
  std::size_t before = 0;
  while (count + 1 < items.size() && 2 * (before + items[count].size()) <= triangles) {
    before += items[count].size();
    ++count;
  }
  return std::max<std::size_t>(count, 1);
}

std::size_t triangles_of(std::span<const Item> items) {
  std::size_t sum = 0;
  for (const Item& item : items) {
    sum += item.size();
  }
  return sum;
}

TileCut cut_of(const Items& all, std::span<const Item> items) {
  TileCut cut;
  for (const Item& item : items) {
    cut.splits_part = cut.splits_part || item.of_split_part;
    const auto begin = all.triangles.begin();
    cut.triangles.insert(cut.triangles.end(), begin + static_cast<std::ptrdiff_t>(item.begin),
                         begin + static_cast<std::ptrdiff_t>(item.end));
  }
  std::sort(cut.triangles.begin(), cut.triangles.end());
  return cut;
}

}  // namespace

std::vector<TileCut> cut_mesh(const MeshView& mesh, std::size_t most, const Limits& limits) {
  Items all = items_of(mesh, most);
  std::vector<TileCut> tiles;
  std::vector<std::span<Item>> waiting;
  if (!all.items.empty()) {
    waiting.emplace_back(all.items);
  }
  while (!waiting.empty()) {
    check(limits);
    const std::span<Item> items = waiting.back();
    waiting.pop_back();
    const std::size_t triangles = triangles_of(items);
    if (triangles <= most) {
      tiles.push_back(cut_of(all, items));
      continue;
    }
    const std::size_t half = halve(items, triangles);
    waiting.push_back(items.subspan(half));
    waiting.push_back(items.first(half));
  }
  return tiles;
}

namespace {

/// Parts that have any of the triangles, with their runs among these.
void extract_parts(const MeshView& mesh, std::span<const TriangleId> triangles, Mesh& tile) {
  const auto place_of = [&](std::uint64_t triangle) {
    const auto at = std::lower_bound(triangles.begin(), triangles.end(), triangle);
    return static_cast<std::uint32_t>(at - triangles.begin());
  };
  std::vector<std::uint32_t> place(mesh.parts.size(), Part::kNoParent);
  std::vector<std::uint32_t> first_of(mesh.parts.size(), Part::kNoParent);  // of an object
  for (std::uint32_t k = 0; k < mesh.parts.size(); ++k) {
    const Part& part = mesh.parts[k];
    const std::uint32_t begin = place_of(part.first);
    const std::uint32_t end = place_of(std::uint64_t{part.first} + part.count);
    if (begin == end) {
      continue;
    }
    place[k] = static_cast<std::uint32_t>(tile.parts.size());
    tile.parts.push_back(part);
    Part& own = tile.parts.back();
    own.first = begin;
    own.count = end - begin;
    // An object's first run may be in another tile: then its first one here is.
    std::uint32_t& first = first_of[first_run(mesh, k)];
    own.continues = first;
    if (first == Part::kNoParent) {
      first = place[k];
      const Part& named = mesh.parts[first_run(mesh, k)];
      own.name = named.name;
      own.id = named.id;
      own.type = named.type;
      own.attributes = named.attributes;
    }
  }
  for (Part& part : tile.parts) {
    // What encloses a part by name need not enclose its triangles, and may be in a circle.
    for (std::size_t k = 0; k < mesh.parts.size() && part.parent != Part::kNoParent &&
                            place[part.parent] == Part::kNoParent;
         ++k) {
      part.parent = mesh.parts[part.parent].parent;
    }
    part.parent = part.parent == Part::kNoParent ? Part::kNoParent : place[part.parent];
  }
}

}  // namespace

Mesh extract(const MeshView& mesh, std::span<const TriangleId> triangles) {
  Mesh tile;
  tile.unit = mesh.unit;
  tile.up = mesh.up;
  tile.georeference = mesh.georeference;
  tile.source = mesh.source;
  tile.notes = mesh.notes;
  std::vector<std::uint32_t> used;
  for (const TriangleId i : triangles) {
    used.insert(used.end(), mesh.triangles[i].begin(), mesh.triangles[i].end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const std::uint32_t v : used) {
    tile.vertices.push_back(mesh.vertices[v]);
  }
  for (const TriangleId i : triangles) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = std::lower_bound(used.begin(), used.end(), mesh.triangles[i][k]);
      corners[k] = static_cast<std::uint32_t>(at - used.begin());
    }
    tile.triangles.push_back(corners);
    tile.faces.push_back(mesh.faces.empty() ? i : mesh.faces[i]);
  }
  extract_parts(mesh, triangles, tile);
  return tile;
}

}  // namespace soms
