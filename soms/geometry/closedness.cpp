#include "soms/geometry/closedness.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/parts/connected_parts.h"
#include "soms/geometry/detail/parts/joined.h"
#include "soms/geometry/detail/parts/odd_edges.h"
#include "soms/geometry/detail/parts/part_work.h"

#include <algorithm>
#include <span>
#include <utility>

namespace soms {

namespace {

using detail::OddEdge;
using detail::Work;

/// What the odd edges of a part say of it.
void judge(const MeshView& mesh, std::span<const OddEdge> edges, const Pose& pose,
           PartClosedness& part) {
  for (const OddEdge& edge : edges) {
    part.odd_edges += edge.among_all ? 1U : 0U;
    part.odd_proper_edges += edge.among_proper ? 1U : 0U;
  }
  part.closed = detail::cover_evenly(mesh, edges, pose);
}

/// A mesh whose vertices are joined, and what is known of its triangles.
struct Joined {
  MeshView mesh;
  std::vector<std::uint32_t> vertices;
  std::vector<bool> degenerate;
};

PartClosedness counted(const Joined& joined, TriangleId first, std::uint32_t count) {
  PartClosedness part{.first = first, .triangles = count};
  const auto begin = joined.degenerate.begin() + first;
  part.degenerate = static_cast<std::uint64_t>(std::count(begin, begin + count, true));
  return part;
}

/// Connected parts, what was counted of them, and to which one each vertex belongs.
struct Connected {
  std::vector<PartClosedness> parts;
  std::vector<std::uint32_t> part_of;  ///< of joined vertices that triangles use
};

/// Takes `connecting_work` of `work`.
Connected connect(const Joined& joined, Work& work) {
  detail::ConnectedParts found = detail::connected_parts(joined.mesh, joined.vertices, work);
  Connected connected;
  for (const TriangleId first : found.first) {
    connected.parts.push_back({.first = first});
  }
  work.run(joined.mesh.triangles.size(), [&](std::size_t i) {
    PartClosedness& part = connected.parts[found.part_of[joined.mesh.triangles[i][0]]];
    ++part.triangles;
    part.degenerate += joined.degenerate[i] ? 1U : 0U;
  });
  connected.part_of = std::move(found.part_of);
  return connected;
}

/// Decides for each connected part.
void judge(const MeshView& mesh, std::vector<OddEdge> odd, const Pose& pose, Connected& connected) {
  const auto part = [&](const OddEdge& edge) { return connected.part_of[edge.ends[0]]; };
  std::stable_sort(odd.begin(), odd.end(),
                   [&](const OddEdge& a, const OddEdge& b) { return part(a) < part(b); });
  for (std::size_t begin = 0; begin < odd.size();) {
    std::size_t end = begin + 1;
    while (end < odd.size() && part(odd[end]) == part(odd[begin])) {
      ++end;
    }
    judge(mesh, std::span(odd).subspan(begin, end - begin), pose,
          connected.parts[part(odd[begin])]);
    begin = end;
  }
}

std::uint64_t connecting_work(const MeshView& mesh) {
  return detail::connected_parts_work(mesh) + mesh.triangles.size();
}

std::vector<PartClosedness> named_parts(const Joined& joined, const PartClosedness& whole,
                                        const Pose& pose, Work& work) {
  std::vector<PartClosedness> parts;
  for (const Part& run : joined.mesh.parts) {
    if (run.count == joined.mesh.triangles.size()) {
      parts.push_back(whole);
    } else {
      parts.push_back(counted(joined, run.first, run.count));
      judge(joined.mesh,
            detail::odd_edges_of_run(joined.mesh, joined.vertices, joined.degenerate, run), pose,
            parts.back());
    }
    work.skip(run.count);
  }
  return parts;
}

}  // namespace

Closedness closedness(const MeshView& mesh, const ClosednessOptions& options,
                      const Limits& limits) {
  const PlainArithmetic plain;
  check(options.pose);
  check_range(options.pose, bounds(mesh));
  const std::uint64_t triangles = mesh.triangles.size();
  const std::uint64_t of_parts = options.parts ? detail::part_work(mesh).value_or(0) : 0;
  Work work(limits, detail::joining_work(mesh) + triangles + detail::odd_edges_work(mesh) +
                        (options.connected ? connecting_work(mesh) : 0) + of_parts + 1);
  Joined joined{mesh, detail::joined_by_position(mesh, work), {}};
  joined.degenerate = detail::degenerate_triangles(mesh, work);
  const std::vector<OddEdge> odd =
      detail::odd_edges(mesh, joined.vertices, joined.degenerate, work);
  Closedness answer;
  answer.whole = counted(joined, 0, static_cast<std::uint32_t>(triangles));
  judge(mesh, odd, options.pose, answer.whole);
  for (const OddEdge& edge : odd) {
    if (answer.places.size() < options.places && edge.among_all) {
      answer.places.push_back(edge.place);
    }
  }
  if (options.connected) {
    Connected connected = connect(joined, work);
    judge(mesh, odd, options.pose, connected);
    answer.connected = std::move(connected.parts);
  }
  if (of_parts != 0) {
    answer.parts = named_parts(joined, answer.whole, options.pose, work);
  }
  return answer;
}

Mesh closed_parts(const MeshView& mesh, const Pose& pose, const Limits& limits) {
  const PlainArithmetic plain;
  check(pose);
  check_range(pose, bounds(mesh));
  Work work(limits, detail::joining_work(mesh) + mesh.triangles.size() +
                        detail::odd_edges_work(mesh) + connecting_work(mesh) + 1);
  Joined joined{mesh, detail::joined_by_position(mesh, work), {}};
  joined.degenerate = detail::degenerate_triangles(mesh, work);
  const std::vector<OddEdge> odd =
      detail::odd_edges(mesh, joined.vertices, joined.degenerate, work);
  Connected connected = connect(joined, work);
  judge(mesh, odd, pose, connected);
  MeshView others = mesh;
  others.triangles = {};
  others.faces = {};
  Mesh left(others);
  std::vector<std::uint32_t> place{0};  // of each triangle, and of the end, among those left
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    if (connected.parts[connected.part_of[joined.vertices[t[0]]]].closed) {
      left.triangles.push_back(t);
      left.faces.push_back(mesh.faces.empty() ? static_cast<std::uint32_t>(i) : mesh.faces[i]);
    }
    place.push_back(static_cast<std::uint32_t>(left.triangles.size()));
  }
  for (Part& part : left.parts) {
    const std::uint32_t end = place[part.first + part.count];
    part.first = place[part.first];
    part.count = end - part.first;
  }
  return left;
}

}  // namespace soms
