/// \file
/// What does a ray meet, on which side of a surface is a point? Decided without any tree, before a
/// time counts.
#pragma once

#include "soms/base/box.h"

#include "bench/peers/core/bunches.h"
#include "bench/peers/core/distance_judge.h"
#include "bench/peers/libraries/library.h"

#include <cstddef>
#include <limits>

namespace soms::bench {

/// What a ray meets, as far as rounding leaves it open: a triangle whose edge is as near to the ray
/// as rounding may shift it is met or not.
struct Crossings {
  std::size_t sure = 0;
  std::size_t open = 0;
  double least = std::numeric_limits<double>::infinity();  ///< the first hit is not before this,
  double most = std::numeric_limits<double>::infinity();   ///< nor behind this
};

/// Shoots rays at every bunch whose box they meet, and at every triangle in it.
class RayJudge {
 public:
  explicit RayJudge(const FloatMesh& body);

  /// Where libraries compute in `precision`; exact ones are allowed the rounding of this judge.
  [[nodiscard]] Crossings crossings(const ProbeRay& ray, Precision precision) const;

  /// How far rounding in `precision` may take a point of the ray.
  [[nodiscard]] double slack(const ProbeRay& ray, Precision precision) const;

  /// Triangles that are looked at for a ray, roughly.
  [[nodiscard]] std::size_t looks() const {
    return body_.list.size() + body_.triangles.size() / 16;
  }

 private:
  Bunches body_;
  double reach_;
};

/// Counts what rays in any direction cross. Where every ray that it tries meets an edge, or begins
/// at the surface, an exact test says whether the point is on the surface.
class SideJudge {
 public:
  explicit SideJudge(const FloatMesh& body);

  /// 1 inside, 0 outside, kOnSurface on it; kOpen where rounding leaves it open.
  [[nodiscard]] double side(const Vec3& point) const;

  static constexpr double kOpen = -1;

  [[nodiscard]] std::size_t looks() const { return rays_.looks(); }

 private:
  RayJudge rays_;
  DistanceJudge distances_;
};

/// A mesh of one point at the origin: a mover whose distance at a pose is that of a point.
[[nodiscard]] FloatMesh point_mesh();

}  // namespace soms::bench
