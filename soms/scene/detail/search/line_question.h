/// \file
/// What is queried of the bodies on a ray or a segment.
#pragma once

#include "soms/query/ray.h"
#include "soms/scene/detail/search/body_search.h"
#include "soms/scene/detail/search/measures.h"

#include <cstdint>
#include <optional>
#include <span>

namespace soms::detail {

/// Where does a ray or a segment meet the surfaces first, if at all?
template <class Line>
class LineQuestion : public LineMeasure<Line> {
 public:
  using Answer = ClosestHit;
  using Found = BodyHit;

  LineQuestion(const Line& given, const RayOptions& options, LeftOut left_out)
      : LineMeasure<Line>(given), options_(options), left_out_(left_out) {}

  /// The body takes part, with the options for it.
  [[nodiscard]] bool takes_part(std::uint32_t number) const {
    return number != left_out_ || options_.skip;
  }

  [[nodiscard]] RayOptions options_for(std::uint32_t number) const {
    return {number == left_out_ ? options_.skip : std::nullopt, options_.deadline};
  }

  [[nodiscard]] ClosestHit ask(const Body& body, std::uint32_t number, double limit) const {
    return takes_part(number)
               ? soms::closest_hit(body, shortened(this->line(), limit), options_for(number))
               : ClosestHit();
  }

  [[nodiscard]] AnyHit ask_any(const Body& body, std::uint32_t number) const {
    return takes_part(number) ? soms::any_hit(body, this->line(), options_for(number)) : AnyHit();
  }

  /// The hits of this line in a batch of its own.
  [[nodiscard]] AllHits ask_all(const Body& body, std::uint32_t number) const {
    return takes_part(number)
               ? soms::all_hits(body, std::span<const Line>(&this->line(), 1), options_for(number))
               : soms::all_hits(Body(), std::span<const Line>(&this->line(), 1));
  }

 private:
  const RayOptions& options_;
  LeftOut left_out_;
};

}  // namespace soms::detail
