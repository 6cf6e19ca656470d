/// \file
/// What is queried of the bodies on a ray.
#pragma once

#include "soms/query/ray.h"
#include "soms/scene/detail/search/body_search.h"
#include "soms/scene/detail/search/measures.h"

#include <cstdint>
#include <optional>
#include <span>

namespace soms::detail {

/// Where does a ray meet the surfaces first, if at all?
class LineQuestion : public LineMeasure {
 public:
  using Answer = ClosestHit;
  using Found = BodyHit;

  LineQuestion(const Ray& given, const RayOptions& options, LeftOut left_out, const Limits& limits)
      : LineMeasure(given), options_(options), left_out_(left_out), limits_(limits) {}

  /// The body takes part, with the options for it.
  [[nodiscard]] bool takes_part(std::uint32_t number) const {
    return number != left_out_ || options_.skip;
  }

  [[nodiscard]] RayOptions options_for(std::uint32_t number) const {
    return {number == left_out_ ? options_.skip : std::nullopt};
  }

  [[nodiscard]] ClosestHit ask(const Body& body, std::uint32_t number, double limit) const {
    return takes_part(number)
               ? soms::closest_hit(body, shortened(line(), limit), options_for(number), limits_)
               : ClosestHit();
  }

  [[nodiscard]] AnyHit ask_any(const Body& body, std::uint32_t number) const {
    return takes_part(number) ? soms::any_hit(body, line(), options_for(number), limits_)
                              : AnyHit();
  }

  /// The hits of this line in a batch of its own.
  [[nodiscard]] AllHits ask_all(const Body& body, std::uint32_t number) const {
    return takes_part(number) ? soms::all_hits(body, std::span<const Ray>(&line(), 1),
                                               options_for(number), limits_)
                              : soms::all_hits(Body(), std::span<const Ray>(&line(), 1));
  }

 private:
  const RayOptions& options_;
  LeftOut left_out_;
  const Limits& limits_;
};

}  // namespace soms::detail
