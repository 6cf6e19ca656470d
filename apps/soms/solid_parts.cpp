#include "apps/soms/solid_parts.h"

#include "soms/base/error.h"
#include "soms/geometry/closedness.h"
#include "soms/geometry/parts_of.h"
#include "soms/query/overlap.h"

#include <map>
#include <span>
#include <utility>

namespace soms::command {

namespace {

/// Some triangles of a mesh, with the vertices that they use.
Mesh only_triangles(const Mesh& mesh, std::span<const TriangleId> ids) {
  Mesh part;
  part.source = mesh.source;
  std::map<std::uint32_t, std::uint32_t> number;
  for (const TriangleId id : ids) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[id][k];
      const auto [at, is_new] =
          number.emplace(vertex, static_cast<std::uint32_t>(part.vertices.size()));
      if (is_new) {
        part.vertices.push_back(mesh.vertices[vertex]);
      }
      corners[k] = at->second;
    }
    part.triangles.push_back(corners);
  }
  return part;
}

/// A body at a pose, if it is closed there.
std::optional<ClosedBody> closed_at(const std::optional<ClosedBody>& body, const Pose& pose) {
  if (!body) {
    return std::nullopt;
  }
  try {
    return body->at(pose);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::not_closed) {
      throw;
    }
    return std::nullopt;
  }
}

/// A part where a pose has moved it, and the box around it.
struct PlacedPart {
  const SolidPart* part;
  std::optional<ClosedBody> closed;
  Box box;
};

std::vector<PlacedPart> placed_parts(const std::vector<SolidPart>& parts, const Pose& pose) {
  std::vector<PlacedPart> placed;
  for (const SolidPart& part : parts) {
    placed.push_back({&part, closed_at(part.closed, pose), {}});
    for (const Vec3& v : part.body.shape.mesh().vertices) {
      placed.back().box.grow(pose.apply(v));
    }
  }
  return placed;
}

}  // namespace

Solid open_answer(const Body& a, const Body& b,
                  std::optional<std::chrono::steady_clock::time_point> deadline,
                  const Parallel& parallel) {
  const Overlap met = overlap(a, b, {.mode = OverlapMode::any, .deadline = deadline}, parallel);
  return {
      .surfaces_meet = met.any, .why = Undecided::open, .coverage = met.coverage, .cost = met.cost};
}

std::vector<SolidPart> solid_parts(const Mesh& mesh, const Parallel& parallel) {
  const PartsOf part_of(mesh);
  std::map<std::uint32_t, std::vector<TriangleId>> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto id = static_cast<TriangleId>(i);
    triangles[part_of(id)].push_back(id);
  }
  std::vector<SolidPart> parts;
  for (const auto& [part, ids] : triangles) {
    check_stop(parallel);
    SolidPart solid{.part = part, .body = Body(only_triangles(mesh, ids))};
    const Closedness closedness = soms::closedness(solid.body.shape.mesh(), {.places = 0});
    if (closedness.whole.closed) {
      solid.closed.emplace(solid.body);
    } else {
      solid.odd_edges = closedness.whole.odd_edges;
    }
    parts.push_back(std::move(solid));
  }
  return parts;
}

std::vector<SolidPair> solid_pairs(const std::vector<SolidPart>& a, const Pose& pose_a,
                                   const std::vector<SolidPart>& b, const Pose& pose_b,
                                   std::optional<std::chrono::steady_clock::time_point> deadline,
                                   const Parallel& parallel) {
  const std::vector<PlacedPart> placed_a = placed_parts(a, pose_a);
  const std::vector<PlacedPart> placed_b = placed_parts(b, pose_b);
  const Parallel alone{.threads = 1, .stop = parallel.stop};
  std::vector<SolidPair> pairs;
  for (const PlacedPart& pa : placed_a) {
    check_stop(parallel);
    for (const PlacedPart& pb : placed_b) {
      if (!overlaps(pa.box, pb.box)) {
        continue;
      }
      const Solid answer = pa.closed && pb.closed
                               ? solid(*pa.closed, *pb.closed, {.deadline = deadline}, alone)
                               : open_answer(Body(pa.part->body.shape, pose_a),
                                             Body(pb.part->body.shape, pose_b), deadline, alone);
      if (answer.relation != Relation::clear) {
        pairs.push_back({pa.part, pb.part, answer});
      }
    }
  }
  return pairs;
}

}  // namespace soms::command
