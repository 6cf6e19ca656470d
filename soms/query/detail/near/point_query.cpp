#include "soms/query/detail/near/point_query.h"

#include "soms/base/box.h"
#include "soms/base/error.h"
#include "soms/base/pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace soms::detail {

namespace {

/// Fewer points than this are not worth sorting, nor is a tree that fits a cache.
constexpr std::size_t kLeastPoints = 4096;
constexpr std::size_t kLeastTriangles = 16384;

constexpr double kCells = 0x1p21;  // of the curve, on each axis

void check_point(const Vec3& point, const std::string& name) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(point[axis])) {
      throw Error(ErrorKind::not_finite, name + ": " + "xyz"[axis] + " is not a finite number",
                  "repair or drop the point");
    }
    if (std::abs(point[axis]) > kMaxCoordinate) {
      throw Error(ErrorKind::out_of_range, name + ": " + "xyz"[axis] + " exceeds 2^300",
                  "scale the mesh and the point");
    }
  }
}

/// Bits 0, 3, 6 and so on of the result are those of the argument, which are 21.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x001f00000000ffffU;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffU;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fU;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3U;
  return (bits | bits << 2) & 0x1249249249249249U;
}

template <class Source>
NearEnd traverse(const PointFrame& frame, PointPose& pose, PointGoal& goal, Limit& limit,
                 PointMemory& memory) {
  PointTraversal<Source> traversal(frame, pose, goal, memory);
  traversal.run(limit);
  return {traversal.complete(), traversal.complete() ? goal.upper() : traversal.at_least(),
          traversal.cost()};
}

}  // namespace

void check_point(const Vec3& point) {
  check_point(point, "point");
}

void check_points(std::span<const Vec3> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    if (!(std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate &&
          std::abs(p.z) <= kMaxCoordinate)) {
      check_point(p, "point " + std::to_string(i));
    }
  }
}

NearEnd pursue(const PointFrame& frame, const Vec3& point, PointGoal& goal, const Limits& limits,
               PointMemory& memory) {
  PointPose pose(frame, point);
  Limit limit(limits);
  return frame.body().layout().compact() != nullptr
             ? traverse<CompactSource>(frame, pose, goal, limit, memory)
             : traverse<WideSource>(frame, pose, goal, limit, memory);
}

std::vector<std::uint32_t> order_of(std::span<const Vec3> points, const Shape& shape) {
  if (points.size() < kLeastPoints || shape.mesh().triangles.size() < kLeastTriangles ||
      points.size() > std::numeric_limits<std::uint32_t>::max()) {
    return {};
  }
  Box box;
  for (const Vec3& point : points) {
    box.grow(point);
  }
  const Vec3 extent = box.extent();
  const double size = std::max({extent.x, extent.y, extent.z});
  std::vector<std::pair<std::uint64_t, std::uint32_t>> codes;
  codes.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::uint64_t code = 0;
    for (std::size_t axis = 0; axis < 3 && size > 0; ++axis) {
      const double cell = (points[i][axis] - box.lower[axis]) / size * kCells;
      code |= spread(static_cast<std::uint64_t>(std::min(cell, kCells - 1))) << axis;
    }
    codes.emplace_back(code, static_cast<std::uint32_t>(i));
  }
  std::sort(codes.begin(), codes.end());
  std::vector<std::uint32_t> order;
  order.reserve(codes.size());
  for (const auto& [code, index] : codes) {
    order.push_back(index);
  }
  return order;
}

}  // namespace soms::detail
