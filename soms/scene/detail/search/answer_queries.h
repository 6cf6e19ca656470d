/// \file
/// The queries of many bodies by a search of their sets: defined here, and instantiated beside
/// their owner. `Owner::view(filter)` is what a query sees: `sets()`; `left_out()`;
/// `options(given)`, the options of rays that have an effect; `named(answer)`, an answer whose
/// bodies have their names.
#pragma once

#include "soms/scene/body_queries.h"
#include "soms/scene/detail/search/body_search.h"

#include <span>

namespace soms {

template <class Owner, class Name, class Filter>
OfBodies<Closest, Name> BodyQueries<Owner, Name, Filter>::closest(const Vec3& point,
                                                                  const ClosestOptions& options,
                                                                  const Filter& filter,
                                                                  const Limits& limits) const {
  const auto view = static_cast<const Owner&>(*this).view(filter);
  return view.named(detail::closest(view.sets(), point, options, view.left_out(), limits));
}

template <class Owner, class Name, class Filter>
OfBodies<ClosestBatch, Name> BodyQueries<Owner, Name, Filter>::closest(
    std::span<const Vec3> points, const ClosestOptions& options, const Filter& filter,
    const Limits& limits) const {
  const auto view = static_cast<const Owner&>(*this).view(filter);
  return view.named(detail::closest(view.sets(), points, options, view.left_out(), limits));
}

template <class Owner, class Name, class Filter>
OfBodies<ClosestHit, Name> BodyQueries<Owner, Name, Filter>::closest_hit(
    const Ray& ray, const RayOptions& options, const Filter& filter, const Limits& limits) const {
  const auto view = static_cast<const Owner&>(*this).view(filter);
  return view.named(
      detail::closest_hit(view.sets(), ray, view.options(options), view.left_out(), limits));
}

template <class Owner, class Name, class Filter>
OfBodies<ClosestHitBatch, Name> BodyQueries<Owner, Name, Filter>::closest_hit(
    std::span<const Ray> rays, const RayOptions& options, const Filter& filter,
    const Limits& limits) const {
  const auto view = static_cast<const Owner&>(*this).view(filter);
  return view.named(
      detail::closest_hit(view.sets(), rays, view.options(options), view.left_out(), limits));
}

template <class Owner, class Name, class Filter>
AnyHit BodyQueries<Owner, Name, Filter>::any_hit(const Ray& ray, const RayOptions& options,
                                                 const Filter& filter, const Limits& limits) const {
  const auto view = static_cast<const Owner&>(*this).view(filter);
  return detail::any_hit(view.sets(), ray, view.options(options), view.left_out(), limits);
}

template <class Owner, class Name, class Filter>
AnyHitBatch BodyQueries<Owner, Name, Filter>::any_hit(std::span<const Ray> rays,
                                                      const RayOptions& options,
                                                      const Filter& filter,
                                                      const Limits& limits) const {
  const auto view = static_cast<const Owner&>(*this).view(filter);
  return detail::any_hit(view.sets(), rays, view.options(options), view.left_out(), limits);
}

template <class Owner, class Name, class Filter>
OfBodies<AllHits, Name> BodyQueries<Owner, Name, Filter>::all_hits(std::span<const Ray> rays,
                                                                   const RayOptions& options,
                                                                   const Filter& filter,
                                                                   const Limits& limits) const {
  const auto view = static_cast<const Owner&>(*this).view(filter);
  return view.named(
      detail::all_hits(view.sets(), rays, view.options(options), view.left_out(), limits));
}

}  // namespace soms
