/// \file
/// What is made of the triangles that a ray's traversal meets: the first one, any, or all.
#pragma once

#include "soms/geometry/detail/exact_ray.h"
#include "soms/geometry/detail/ray_plane.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/query/detail/ray/crossings.h"
#include "soms/query/detail/ray/ray_frame.h"
#include "soms/query/ray.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace soms::detail {

/// A ray and the body that it is sent at.
struct RayTarget {
  const Body* body = nullptr;
  RayLine line;
  ScaledDirection direction{RayLine{}};
  RayCourse course;
  std::optional<TriangleId> skip;
  Cost cost;
};

/// A triangle that a ray meets, and how it was found.
struct Meeting {
  FoundHit hit;
  std::unique_ptr<ExactRay> exact;  // where floats did not decide
};

/// Decides whether the ray meets a triangle; `inside`: its line surely crosses it, off its edges.
[[nodiscard]] std::optional<Meeting> meet(RayTarget& target, TriangleId id, bool inside);

/// The first triangle.
class ClosestHitGoal {
 public:
  using Answer = ClosestHit;
  static constexpr bool kNearestFirst = true;

  void begin() { found_ = false; }

  /// Looks at a block's triangles; true when nothing else matters.
  bool look(RayTarget& target, const LineBlockTask& task);

  /// The answer; all was looked at if `complete`.
  [[nodiscard]] ClosestHit end(RayTarget& target, bool complete);

 private:
  void offer(RayTarget& target, TriangleId id, bool inside);
  [[nodiscard]] bool is_nearer(RayTarget& target, Meeting& meeting);

  bool found_ = false;
  Meeting best_;
};

/// Any triangle.
class AnyHitGoal {
 public:
  using Answer = AnyHit;
  static constexpr bool kNearestFirst = true;

  void begin() { hit_ = false; }

  bool look(RayTarget& target, const LineBlockTask& task);
  [[nodiscard]] AnyHit end(RayTarget& target, bool complete) const;

 private:
  bool hit_ = false;
};

/// All triangles.
class AllHitsGoal {
 public:
  struct Answer {
    RayRow row;
    Coverage coverage = Coverage::cut;
    Cost cost;
  };

  static constexpr bool kNearestFirst = false;

  void begin() { found_.clear(); }

  bool look(RayTarget& target, const LineBlockTask& task);
  [[nodiscard]] Answer end(RayTarget& target, bool complete);

 private:
  std::vector<FoundHit> found_;
};

}  // namespace soms::detail
