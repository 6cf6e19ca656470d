#include "soms/query/contains.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/base/text.h"
#include "soms/describe/columns.h"
#include "soms/query/detail/closed_surface.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/parity/parity_traversal.h"

#include <cmath>
#include <string>
#include <utility>

namespace soms {

namespace {

using detail::OddEdge;
using detail::ParityFrame;

/// Points that a thread takes at a time: some hundred microseconds' work.
constexpr std::size_t kPointsOfBlock = 1024;

constexpr std::size_t kEdgesInMessage = 3;

std::string in_text(const Vec3& p) {
  std::string text = "(";
  text += shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + ")";
  return text;
}

/// "triangle 4 from (0, 0, 1) to (1, 0, 1)", for the first few.
std::string places_of(const Body& body, const std::vector<OddEdge>& odd) {
  const MeshView& mesh = body.shape.mesh();
  std::string text;
  std::size_t named = 0;
  for (const OddEdge& edge : odd) {
    if (edge.among_all && named < kEdgesInMessage) {
      const auto& t = mesh.triangles[edge.place.triangle];
      const Vec3 from = body.pose.apply(mesh.vertices[t[edge.place.corner]]);
      const Vec3 to = body.pose.apply(mesh.vertices[t[(edge.place.corner + 1) % 3]]);
      text += (named == 0 ? "the first of triangle " : ", of triangle ") +
              std::to_string(edge.place.triangle) + " from " + in_text(from) + " to " + in_text(to);
      ++named;
    }
  }
  return text;
}

bool in_range(const Vec3& p) {
  return std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate &&
         std::abs(p.z) <= kMaxCoordinate;
}

/// What is wrong with a point that is not in range; `whose` names it.
Error fault_of(const Vec3& p, const std::string& whose) {
  constexpr std::array<const char*, 3> kNames{": x", ": y", ": z"};
  std::size_t axis = 0;
  while (axis < 2 && std::abs(p[axis]) <= kMaxCoordinate) {
    ++axis;
  }
  return std::isfinite(p[axis])
             ? Error(ErrorKind::out_of_range, whose + kNames[axis] + " is beyond 2^300",
                     "use a larger unit of length")
             : Error(ErrorKind::not_finite, whose + kNames[axis] + " is not a finite number",
                     "give three finite coordinates");
}

}  // namespace

ClosedBody::ClosedBody(Body body, const Limits& limits) : body_(std::move(body)) {
  const PlainArithmetic plain;
  detail::check_pose(body_.pose, body_.shape);
  surface_ = std::make_shared<const detail::ClosedSurface>(
      detail::closed_surface(body_.shape.mesh(), limits));
  check_closed();
}

ClosedBody::ClosedBody(Body body, std::shared_ptr<const detail::ClosedSurface> surface)
    : body_(std::move(body)), surface_(std::move(surface)) {
  const PlainArithmetic plain;
  detail::check_pose(body_.pose, body_.shape);
  check_closed();
}

ClosedBody ClosedBody::at(const Pose& pose) const {
  Body body = body_;
  body.pose = pose;
  return {std::move(body), surface_};
}

void ClosedBody::check_closed() const {
  const MeshView& mesh = body_.shape.mesh();
  const std::vector<OddEdge>& odd = surface_->odd;
  if (surface_->is_closed(mesh, body_.pose)) {
    return;
  }
  const std::uint64_t count = surface_->odd_count();
  const std::string whose = !body_.name.empty() ? body_.name : mesh.source;
  throw Error(
      ErrorKind::not_closed,
      (whose.empty() ? std::string("the body") : whose) + ": not closed: " +
          (count == 1 ? std::string("1 edge belongs") : std::to_string(count) + " edges belong") +
          " to an odd number of triangles, " + places_of(body_, odd),
      "close the surface, or take its closed parts alone (closed_parts)");
}

const detail::ClosedSurface& detail::surface_of(const ClosedBody& body) {
  return *body.surface_;
}

ClosedBody detail::closed_body(Body body, std::shared_ptr<const ClosedSurface> surface) {
  return {std::move(body), std::move(surface)};
}

Contains contains(const ClosedBody& body, const Vec3& point, const Limits& limits) {
  if (!in_range(point)) {
    throw fault_of(point, "point");
  }
  const ContainsBatch batch = contains(body, std::span(&point, 1), limits);
  return batch.at(0);
}

Contains ContainsBatch::at(std::size_t point) const {
  return row_of<Contains>(*this, point);
}

ContainsBatch contains(const ClosedBody& body, std::span<const Vec3> points, const Limits& limits) {
  const PlainArithmetic plain;
  const Shape& shape = body.body().shape;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!in_range(points[i])) {
      throw fault_of(points[i], "point " + std::to_string(i));
    }
  }
  ContainsBatch answer;
  resize_columns<Contains>(answer, points.size());
  if (detail::is_empty(shape)) {
    answer.side.assign(points.size(), Side::outside);
    return answer;
  }
  const ParityFrame frame(shape.layout(), body.body().pose);
  const std::span<Side> sides(answer.side);
  const std::span<Cost> costs(answer.costs);
  detail::MemoryPool<std::unique_ptr<detail::ParityMemory>> pool;
  for_each_chunk(points.size(), kPointsOfBlock, limits.without_deadline(),
                 [&](std::size_t begin, std::size_t end) {
                   auto place =
                       pool.take([&] { return detail::parity_memory(body.body(), frame); });
                   detail::Limit limit(limits);
                   const std::size_t count = end - begin;
                   place->memory->decide(points.subspan(begin, count), sides.subspan(begin, count),
                                         costs.subspan(begin, count), limit);
                   pool.give_back(std::move(place));
                 });
  std::transform(answer.side.begin(), answer.side.end(), answer.coverage.begin(), [](Side side) {
    return side == Side::undecided ? Coverage::cut : Coverage::complete;
  });
  sum_costs<Contains>(answer);
  return answer;
}

ContainsBatch contains(const Body& body, std::span<const Vec3> points, const Limits& limits) {
  return contains(ClosedBody(body, limits.silent().without_deadline()), points, limits);
}

}  // namespace soms
