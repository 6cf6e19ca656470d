#include "soms/query/contains_parts.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/bodies_of.h"
#include "soms/geometry/closedness.h"
#include "soms/geometry/detail/parts/connected_parts.h"
#include "soms/geometry/detail/parts/joined.h"
#include "soms/geometry/parts_of.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/near/point_query.h"
#include "soms/query/detail/parity/crossing_batch.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

namespace soms {

namespace {

using detail::PointCrossings;

/// A number for each triangle's part: that of Mesh::parts, or of its connected part.
std::vector<std::uint32_t> numbers_of(const MeshView& mesh, Partition partition,
                                      const Limits& limits) {
  std::vector<std::uint32_t> number(mesh.triangles.size());
  if (partition == Partition::named) {
    const PartsOf part(mesh);
    for (std::size_t i = 0; i < number.size(); ++i) {
      number[i] = part(static_cast<TriangleId>(i));
    }
    return number;
  }
  detail::Work work(limits, detail::joining_work(mesh) + detail::connected_parts_work(mesh) + 1);
  const auto joined = detail::joined_by_position(mesh, work);
  const detail::ConnectedParts parts = detail::connected_parts(mesh, joined, work);
  for (std::size_t i = 0; i < number.size(); ++i) {
    number[i] = parts.part_of[mesh.triangles[i][0]];
  }
  return number;
}

/// The mesh with the triangles of a part next to each other, and a part for each.
Mesh sorted_by_part(const MeshView& mesh, const std::vector<TriangleId>& order,
                    const std::vector<std::uint32_t>& number) {
  Mesh sorted;
  sorted.vertices.assign(mesh.vertices.begin(), mesh.vertices.end());
  for (const TriangleId id : order) {
    if (sorted.parts.empty() || number[id] != number[order[sorted.triangles.size() - 1]]) {
      sorted.parts.emplace_back().first = static_cast<std::uint32_t>(sorted.triangles.size());
    }
    sorted.triangles.push_back(mesh.triangles[id]);
    ++sorted.parts.back().count;
  }
  return sorted;
}

/// Parts that a ray crosses an odd number of times or that the point is on, sorted.
std::vector<PartSide> sides_of(const DividedBody& body, const PointCrossings& met) {
  std::vector<PartSide> sides;
  for (const TriangleId id : met.crossed) {
    sides.push_back({body.part_of(id), Side::inside});
  }
  for (const TriangleId id : met.on) {
    sides.push_back({body.part_of(id), Side::on});
  }
  std::sort(sides.begin(), sides.end(), [](const PartSide& a, const PartSide& b) {
    return std::pair(a.part, a.side) < std::pair(b.part, b.side);
  });
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < sides.size();) {
    const std::uint32_t part = sides[begin].part;
    bool odd = false;
    bool on = false;
    for (; begin < sides.size() && sides[begin].part == part; ++begin) {
      on = on || sides[begin].side == Side::on;
      odd = odd != (sides[begin].side == Side::inside);
    }
    if (on || (odd && body.parts()[part].closed)) {
      sides[kept++] = {part, on ? Side::on : Side::inside};
    }
  }
  sides.resize(kept);
  return sides;
}

}  // namespace

DividedBody::Found DividedBody::divide(const Body& body, Partition partition,
                                       const std::vector<std::uint32_t>& number,
                                       const Limits& limits) {
  const MeshView& mesh = body.shape.mesh();
  std::vector<TriangleId> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), TriangleId{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](TriangleId a, TriangleId b) { return number[a] < number[b]; });
  const Mesh sorted = sorted_by_part(mesh, order, number);
  const Closedness closedness =
      soms::closedness(sorted, {.pose = body.pose, .places = 0, .parts = true}, limits);
  Found found;
  found.part_of.resize(mesh.triangles.size());
  for (std::size_t k = 0; k < sorted.parts.size(); ++k) {
    const Part& run = sorted.parts[k];
    const PartClosedness& part = closedness.parts[k];
    const TriangleId first = order[run.first];
    found.parts.push_back({.named = partition == Partition::named ? number[first] : Part::kNoParent,
                           .first = first,
                           .triangles = run.count,
                           .closed = part.closed,
                           .odd_edges = part.odd_edges});
    found.open += part.closed ? 0U : 1U;
    for (std::uint32_t i = 0; i < run.count; ++i) {
      found.part_of[order[run.first + i]] = static_cast<std::uint32_t>(k);
    }
  }
  return found;
}

DividedBody::Found DividedBody::find(const Body& body, Partition partition, const Limits& limits) {
  const MeshView& mesh = body.shape.mesh();
  std::vector<std::uint32_t> number = numbers_of(mesh, partition, limits);
  Found found = divide(body, partition, number, limits);
  if (partition == Partition::connected || found.open < 2) {
    return found;
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> joined;  // by the first part
  std::map<std::uint32_t, std::uint32_t> first_of;
  for (const PartGroup& group : bodies_of(mesh, limits)) {
    if (group.closed && group.parts.size() > 1) {
      joined[group.parts.front()] = {group.parts.begin() + 1, group.parts.end()};
      for (const std::uint32_t part : group.parts) {
        first_of[part] = group.parts.front();
      }
    }
  }
  if (joined.empty()) {
    return found;
  }
  for (std::uint32_t& part : number) {
    const auto first = first_of.find(part);
    part = first == first_of.end() ? part : first->second;
  }
  found = divide(body, partition, number, limits);
  for (DividedPart& part : found.parts) {
    if (const auto others = joined.find(part.named); others != joined.end()) {
      part.joined = others->second;
    }
  }
  return found;
}

DividedBody::DividedBody(Body body, Partition partition, const Limits& limits)
    : body_(std::move(body)), partition_(partition) {
  const PlainArithmetic plain;
  detail::check_pose(body_.pose, body_.shape);
  found_ = std::make_shared<const Found>(find(body_, partition, limits));
}

ContainsParts contains(const DividedBody& body, const Vec3& point, const Limits& limits) {
  detail::check_point(point);
  return contains(body, std::span(&point, 1), limits).at(0);
}

std::span<const PartSide> ContainsPartsBatch::parts_of(std::size_t point) const {
  return std::span(parts).subspan(offsets[point], offsets[point + 1] - offsets[point]);
}

ContainsParts ContainsPartsBatch::at(std::size_t point) const {
  const std::span<const PartSide> row = parts_of(point);
  return {{row.begin(), row.end()}, coverage[point], costs[point]};
}

ContainsPartsBatch contains(const DividedBody& body, std::span<const Vec3> points,
                            const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_points(points);
  ContainsPartsBatch answer;
  answer.costs.resize(points.size());
  answer.coverage.assign(points.size(), Coverage::complete);
  answer.offsets.assign(points.size() + 1, 0);
  const Body& whole = body.body();
  if (detail::is_empty(whole.shape)) {
    return answer;
  }
  std::fill(answer.coverage.begin(), answer.coverage.end(), Coverage::cut);
  std::vector<std::vector<PartSide>> rows(points.size());

  struct Nothing {};

  const detail::ParityFrame frame(whole.shape.layout(), whole.pose);
  detail::for_each_crossing<Nothing>(
      whole, frame, points, answer.costs, limits,
      [&](Nothing&, std::size_t i, const PointCrossings& met, detail::Limit&) {
        rows[i] = sides_of(body, met);
        answer.coverage[i] = Coverage::complete;
      });
  for (std::size_t i = 0; i < points.size(); ++i) {
    detail::append(answer.parts, rows[i]);
    answer.offsets[i + 1] = answer.parts.size();
  }
  answer.cost = detail::sum_of(answer.costs);
  return answer;
}

}  // namespace soms
