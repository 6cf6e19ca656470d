#include "soms/geometry/defects.h"

#include "soms/geometry/orientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace soms {

namespace {

using Corners = std::array<std::uint32_t, 3>;

bool less(const Vec3& p, const Vec3& q) {
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

bool collinear(const Triangle& t) {
  return orientation2d(t.a, t.b, t.c, Projection::xy) == Sign::zero &&
         orientation2d(t.a, t.b, t.c, Projection::yz) == Sign::zero &&
         orientation2d(t.a, t.b, t.c, Projection::zx) == Sign::zero;
}

std::vector<bool> used_vertices(const Mesh& mesh) {
  std::vector<bool> used(mesh.vertices.size());
  for (const Corners& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      used[v] = true;
    }
  }
  return used;
}

/// For each used vertex one number a position: equal positions have equal numbers.
std::vector<std::uint32_t> joined_by_position(const Mesh& mesh, const std::vector<bool>& used) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (used[v]) {
      order.push_back(v);
    }
  }
  std::sort(order.begin(), order.end(), [&mesh](std::uint32_t v, std::uint32_t w) {
    return less(mesh.vertices[v], mesh.vertices[w]);
  });
  std::vector<std::uint32_t> joined(mesh.vertices.size());
  std::uint32_t first = 0;
  for (const std::uint32_t v : order) {
    if (v == order.front() || less(mesh.vertices[first], mesh.vertices[v])) {
      first = v;
    }
    joined[v] = first;
  }
  return joined;
}

/// An edge as its triangle runs along it, smaller end first.
struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  bool reversed;

  Edge(std::uint32_t from, std::uint32_t to)
      : low(std::min(from, to)), high(std::max(from, to)), reversed(from > to) {}

  [[nodiscard]] bool same_ends(const Edge& e) const { return low == e.low && high == e.high; }

  [[nodiscard]] bool operator<(const Edge& e) const {
    return low != e.low ? low < e.low : high < e.high;
  }
};

void count_edges(std::vector<Edge>& edges, Defects& defects) {
  std::sort(edges.begin(), edges.end());
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].same_ends(edges[begin])) {
      ++end;
    }
    const std::size_t uses = end - begin;
    const bool flipped = uses == 2 && edges[begin].reversed == edges[begin + 1].reversed;
    defects.open_edges += static_cast<std::uint64_t>(uses == 1);
    defects.non_manifold_edges += static_cast<std::uint64_t>(uses > 2);
    defects.flipped_edges += static_cast<std::uint64_t>(flipped);
    begin = end;
  }
}

std::uint64_t count_duplicates(std::vector<Corners>& triangles) {
  std::sort(triangles.begin(), triangles.end());
  std::uint64_t duplicates = 0;
  for (std::size_t i = 1; i < triangles.size(); ++i) {
    duplicates += static_cast<std::uint64_t>(triangles[i] == triangles[i - 1]);
  }
  return duplicates;
}

}  // namespace

Defects find_defects(const Mesh& mesh) {
  Defects defects;
  const std::vector<bool> used = used_vertices(mesh);
  defects.unused_vertices = static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false));
  const std::vector<std::uint32_t> joined = joined_by_position(mesh, used);
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  std::vector<Corners> sorted;
  sorted.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners& t = mesh.triangles[i];
    Corners corners{joined[t[0]], joined[t[1]], joined[t[2]]};
    if (collinear(mesh.triangle(static_cast<TriangleId>(i)))) {
      ++defects.degenerate;
    } else {
      edges.emplace_back(corners[0], corners[1]);
      edges.emplace_back(corners[1], corners[2]);
      edges.emplace_back(corners[2], corners[0]);
    }
    std::sort(corners.begin(), corners.end());
    sorted.push_back(corners);
  }
  defects.duplicate = count_duplicates(sorted);
  count_edges(edges, defects);
  return defects;
}

}  // namespace soms
