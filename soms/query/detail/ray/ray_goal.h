/// \file
/// What is made of the triangles that a ray's traversal meets: the first one, any, or all.
#pragma once

#include "soms/geometry/detail/exact/exact_ray.h"
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

/// The first triangle. Those that bounds in float cannot part are kept until all was looked at.
class ClosestHitGoal {
 public:
  using Answer = ClosestHit;

  void begin() { nearest_.clear(); }

  /// Looks at a block's triangles; true when nothing else matters.
  bool look(RayTarget& target, const LineBlockTask& task);

  /// The answer; all was looked at if `complete`. Of a first triangle that floats part from all
  /// others it gives only the number: `finish` adds the rest.
  [[nodiscard]] ClosestHit end(RayTarget& target, bool complete);

  /// Finishes the answer of the target's ray.
  static void finish(RayTarget& target, ClosestHit& answer);

  /// Finishes those of many rays, so that one computes while others load.
  static void finish_all(RayTarget& target, std::span<const RayLine> lines,
                         std::span<ClosestHit> answers);

 private:
  /// A triangle that the ray meets, and bounds of where.
  struct Candidate {
    float near;
    float far;
    TriangleId id;
    bool inside;
  };

  void offer(RayTarget& target, const Candidate& candidate);

  std::vector<Candidate> nearest_;
};

/// Any triangle.
class AnyHitGoal {
 public:
  using Answer = AnyHit;

  void begin() { hit_ = false; }

  bool look(RayTarget& target, const LineBlockTask& task);
  [[nodiscard]] AnyHit end(RayTarget& target, bool complete) const;

  static void finish(RayTarget&, AnyHit&) {}

  static void finish_all(RayTarget&, std::span<const RayLine>, std::span<AnyHit>) {}

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

  void begin() { found_.clear(); }

  bool look(RayTarget& target, const LineBlockTask& task);
  [[nodiscard]] Answer end(RayTarget& target, bool complete);

  static void finish(RayTarget&, Answer&) {}

  static void finish_all(RayTarget&, std::span<const RayLine>, std::span<Answer>) {}

 private:
  std::vector<FoundHit> found_;
};

}  // namespace soms::detail
