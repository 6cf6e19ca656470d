/// \file
/// What is measured where many bodies, or many tiles, are searched for the nearest: how far a point
/// is, and where a line enters. Their order is decided exactly.
#pragma once

#include "soms/base/bracket.h"
#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/geometry/detail/point_to_triangle.h"
#include "soms/geometry/point_distance.h"
#include "soms/query/closest.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/query/detail/ray/ray_line.h"
#include "soms/query/ray.h"
#include "soms/scene/detail/box_bounds.h"

#include <algorithm>
#include <compare>

namespace soms::detail {

/// The order of two things that are measured, by their brackets where these tell, or by
/// `exactly()`. Brackets are the narrowest ones: those that differ tell the order of what is in
/// them, and equal ones of two equal ends that there is no difference.
template <class Exactly>
[[nodiscard]] std::strong_ordering order_of(const Bracket& here, const Bracket& there,
                                            const Exactly& exactly) {
  if (here.lower != there.lower) {
    return here.lower < there.lower ? std::strong_ordering::less : std::strong_ordering::greater;
  }
  if (here.upper != there.upper) {
    return here.upper < there.upper ? std::strong_ordering::less : std::strong_ordering::greater;
  }
  return here.lower == here.upper ? std::strong_ordering::equal : exactly();
}

/// The distance from a point, which must stay.
class PointMeasure {
 public:
  PointMeasure(const Vec3& point, const ClosestOptions& options, const Limits& limits)
      : point_(point), options_(options), limits_(limits) {}

  [[nodiscard]] static const Bracket& measure(const Closest& answer) { return answer.distance; }

  /// Not above the distance of anything in a box.
  [[nodiscard]] double key(const Box& box) const { return distance_at_least(point_, box); }

  [[nodiscard]] double limit() const { return options_.at_most; }

  /// The nearest point of a body, if it is not beyond `limit`.
  [[nodiscard]] Closest nearest(const Body& body, double limit) const {
    Closest answer = soms::closest(body, point_, {limit}, limits_);
    if (answer.coverage == Coverage::cut && answer.triangle) {
      // What was proved of the body is not what is measured.
      answer.distance = point_distance(point_, moved_triangle(body, *answer.triangle)).distance;
    }
    return answer;
  }

  [[nodiscard]] std::strong_ordering compare(const Body& body, TriangleId triangle,
                                             const Body& other, TriangleId others) const {
    PointToTriangle here(point_, moved_triangle(body, triangle));
    PointToTriangle there(point_, moved_triangle(other, others));
    return here.compare(there);
  }

 private:
  const Vec3& point_;
  const ClosestOptions& options_;
  const Limits& limits_;
};

/// The part of a ray up to t = `limit`. A segment stays whole: where it is cut is seldom a double.
inline Ray shortened(Ray ray, double limit) {
  ray.length = std::min(ray.length, limit);
  return ray;
}

/// Where a ray, which must stay, meets surfaces.
class LineMeasure {
 public:
  explicit LineMeasure(const Ray& given) : given_(given), line_(line_of(given)) {
    // The way of a segment is rounded: `entry_at_least` allows for that.
    direction_ = line_.segment ? line_.ahead - line_.origin : line_.ahead;
  }

  [[nodiscard]] static const Bracket& measure(const ClosestHit& answer) { return answer.t; }

  /// Not above t of anything in a box.
  [[nodiscard]] double key(const Box& box) const {
    return entry_at_least(line_.origin, direction_, box);
  }

  [[nodiscard]] double limit() const { return line_.length; }

  /// As it was given.
  [[nodiscard]] const Ray& line() const { return given_; }

  [[nodiscard]] std::strong_ordering compare(const Body& body, TriangleId triangle,
                                             const Body& other, TriangleId others) const {
    return detail::compare(ExactRay(line_, moved_triangle(body, triangle)).time(),
                           ExactRay(line_, moved_triangle(other, others)).time());
  }

 private:
  const Ray& given_;
  RayLine line_;
  Vec3 direction_;
};

}  // namespace soms::detail
