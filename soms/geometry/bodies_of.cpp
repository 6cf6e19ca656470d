#include "soms/geometry/bodies_of.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/parts/joined.h"
#include "soms/geometry/detail/parts/part_groups.h"
#include "soms/geometry/parts_of.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>

namespace soms {

namespace {

using detail::OpenPart;

/// An edge of a triangle of a part, the lesser vertex first.
struct EdgeOfPart {
  std::uint32_t part;
  std::array<std::uint32_t, 2> ends;

  [[nodiscard]] bool operator==(const EdgeOfPart&) const = default;

  // By hand, as older standard libraries have no <=> of arrays.
  [[nodiscard]] bool operator<(const EdgeOfPart& other) const {
    return std::tie(part, ends) < std::tie(other.part, other.ends);
  }
};

std::vector<EdgeOfPart> sorted_edges(const MeshView& mesh, const std::vector<std::uint32_t>& joined,
                                     const std::vector<std::uint32_t>& part_of,
                                     const Limits& limits) {
  std::vector<EdgeOfPart> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = joined[mesh.triangles[i][k]];
      const std::uint32_t to = joined[mesh.triangles[i][(k + 1) % 3]];
      if (from != to) {
        edges.push_back({part_of[i], {std::min(from, to), std::max(from, to)}});
      }
    }
  }
  check(limits);
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The edges that an odd number of a part's triangles use, for each part that has a triangle.
std::vector<OpenPart> odd_edges_by_part(const MeshView& mesh, const std::vector<EdgeOfPart>& edges,
                                        const std::vector<std::uint32_t>& used_parts) {
  std::vector<OpenPart> parts;
  parts.reserve(used_parts.size());
  for (const std::uint32_t part : used_parts) {
    parts.push_back({.part = part});
  }
  auto part = parts.begin();
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end] == edges[begin]) {
      ++end;
    }
    if ((end - begin) % 2 != 0) {
      while (part->part != edges[begin].part) {
        ++part;
      }
      const auto [a, b] = edges[begin].ends;
      part->edges.push_back({mesh.vertices[a], mesh.vertices[b]});
    }
    begin = end;
  }
  return parts;
}

}  // namespace

std::vector<PartGroup> bodies_of(const MeshView& mesh, const Limits& limits) {
  const PlainArithmetic plain;
  const PartsOf parts_of(mesh);
  std::vector<std::uint32_t> part_of(mesh.triangles.size());
  for (std::size_t i = 0; i < part_of.size(); ++i) {
    part_of[i] = parts_of(static_cast<TriangleId>(i));
  }
  std::vector<std::uint32_t> used = part_of;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const Limits silent = limits.alone();
  detail::Work work(silent, detail::joining_work(mesh) + 1);
  const std::vector<std::uint32_t> joined = detail::joined_by_position(mesh, work);
  std::vector<PartGroup> groups;
  std::vector<OpenPart> open;
  for (OpenPart& part :
       odd_edges_by_part(mesh, sorted_edges(mesh, joined, part_of, limits), used)) {
    if (detail::covers_evenly(part.edges)) {
      groups.push_back({.parts = {part.part}, .closed = true});
    } else {
      open.push_back(std::move(part));
    }
  }
  check(limits);
  std::vector<PartGroup> of_open = detail::groups_of_open(mesh, open);
  std::move(of_open.begin(), of_open.end(), std::back_inserter(groups));
  std::sort(groups.begin(), groups.end(), [](const PartGroup& a, const PartGroup& b) {
    return a.parts.front() < b.parts.front();
  });
  return groups;
}

}  // namespace soms
