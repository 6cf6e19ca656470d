/// \file
/// What is queried of the bodies on a ray or a segment.
#pragma once

#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/query/detail/ray/ray_line.h"
#include "soms/query/ray.h"
#include "soms/scene/detail/box_bounds.h"
#include "soms/scene/detail/search/body_search.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>

namespace soms::detail {

/// The part of a ray up to t = `limit`.
inline Ray shortened(Ray ray, double limit) {
  ray.length = std::min(ray.length, limit);
  return ray;
}

/// Where a segment is cut is seldom a double: it stays whole.
inline Segment shortened(const Segment& segment, double /*limit*/) {
  return segment;
}

/// Where does a ray or a segment meet the surfaces first, if at all?
template <class Line>
class LineQuestion {
 public:
  using Answer = ClosestHit;
  using Found = BodyHit;

  LineQuestion(const Line& given, const RayOptions& options, LeftOut left_out)
      : given_(given), line_(line_of(given)), options_(options), left_out_(left_out) {
    // The way of a segment is rounded: `entry_at_least` allows for that.
    direction_ = line_.segment ? line_.ahead - line_.origin : line_.ahead;
  }

  [[nodiscard]] static const Bracket& measure(const ClosestHit& answer) { return answer.t; }

  [[nodiscard]] double key(const Box& box) const {
    return entry_at_least(line_.origin, direction_, box);
  }

  [[nodiscard]] double limit() const { return line_.length; }

  /// The body takes part, with the options for it.
  [[nodiscard]] bool takes_part(std::uint32_t number) const {
    return number != left_out_ || options_.skip;
  }

  [[nodiscard]] RayOptions options_for(std::uint32_t number) const {
    return {number == left_out_ ? options_.skip : std::nullopt, options_.deadline};
  }

  [[nodiscard]] ClosestHit ask(const Body& body, std::uint32_t number, double limit) const {
    return takes_part(number)
               ? soms::closest_hit(body, shortened(given_, limit), options_for(number))
               : ClosestHit();
  }

  [[nodiscard]] AnyHit ask_any(const Body& body, std::uint32_t number) const {
    return takes_part(number) ? soms::any_hit(body, given_, options_for(number)) : AnyHit();
  }

  /// The hits of this line in a batch of its own.
  [[nodiscard]] AllHits ask_all(const Body& body, std::uint32_t number) const {
    return takes_part(number)
               ? soms::all_hits(body, std::span<const Line>(&given_, 1), options_for(number))
               : soms::all_hits(Body(), std::span<const Line>(&given_, 1));
  }

  [[nodiscard]] std::strong_ordering compare(const Body& body, TriangleId triangle,
                                             const Body& other, TriangleId others) const {
    return detail::compare(ExactRay(line_, moved_triangle(body, triangle)).time(),
                           ExactRay(line_, moved_triangle(other, others)).time());
  }

 private:
  const Line& given_;
  RayLine line_;
  Vec3 direction_;
  const RayOptions& options_;
  LeftOut left_out_;
};

}  // namespace soms::detail
