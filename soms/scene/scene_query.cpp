// What is nearest to points, and first on rays, among the bodies of a scene.
#include "soms/scene/scene_query.h"

#include "soms/base/arithmetic.h"
#include "soms/describe/columns.h"
#include "soms/scene/detail/scene_state.h"
#include "soms/scene/detail/search/body_search.h"
#include "soms/scene/scene.h"

#include <utility>

namespace soms {

namespace {

/// The set of all residents, by place.
void build_set(const detail::Residents& residents, std::vector<Box>& boxes, detail::BodySet& set) {
  std::vector<const Body*> bodies;
  bodies.reserve(residents.places().size());
  for (const auto& place : residents.places()) {
    bodies.push_back(&place.value.body);
  }
  detail::collect_boxes(residents, boxes);
  set.build(std::move(bodies), boxes);
}

}  // namespace

void Scene::State::refresh_parts() {
  if (parts_changed) {
    build_set(parts, boxes, part_set);
    parts_changed = false;
  }
}

void Scene::State::refresh_movers() {
  if (movers_changed) {
    build_set(movers, boxes, mover_set);
    movers_changed = false;
  }
}

/// The bodies of a scene that take part in a query, and what their numbers mean.
class Scene::View {
 public:
  View(State& state, const SceneFilter& filter) : state_(state) {
    const PlainArithmetic plain;
    if (filter.environment) {
      state.refresh_parts();
      sets_.push_back(&state.part_set);
      parts_ = state.part_set.size();
    }
    if (filter.movers) {
      state.refresh_movers();
      sets_.push_back(&state.mover_set);
    }
    if (filter.except) {
      leave_out(*filter.except, filter);
    }
  }

  [[nodiscard]] detail::BodySets sets() const { return sets_; }

  [[nodiscard]] detail::LeftOut left_out() const { return left_out_; }

  /// The skipped triangle of a body that takes no part is none.
  [[nodiscard]] RayOptions options(RayOptions options) const {
    if (excepts_a_stranger_) {
      options.skip.reset();
    }
    return options;
  }

  [[nodiscard]] std::optional<SceneBody> name(std::optional<std::uint32_t> number) const {
    if (!number) {
      return std::nullopt;
    }
    return *number < parts_
               ? SceneBody{SceneBodyKind::environment, state_.parts.places()[*number].id}
               : SceneBody{SceneBodyKind::mover, state_.movers.places()[*number - parts_].id};
  }

  [[nodiscard]] SceneAllHits named(BodyAllHits found) const {
    std::vector<SceneBody> names;
    names.reserve(found.body.size());
    for (const std::uint32_t number : found.body) {
      names.push_back(*name(number));
    }
    return {std::move(found), std::move(names)};
  }

  [[nodiscard]] std::vector<std::optional<SceneBody>> names(
      const std::vector<std::optional<std::uint32_t>>& numbers) const {
    std::vector<std::optional<SceneBody>> names;
    names.reserve(numbers.size());
    for (const std::optional<std::uint32_t> number : numbers) {
      names.push_back(name(number));
    }
    return names;
  }

 private:
  void leave_out(const SceneBody& body, const SceneFilter& filter) {
    const bool part = body.kind == SceneBodyKind::environment;
    const detail::Residents& residents = part ? state_.parts : state_.movers;
    static_cast<void>(residents.at(body.id));  // an error unless it is there
    if (part ? filter.environment : filter.movers) {
      left_out_ = residents.place_of(body.id) + (part ? 0 : static_cast<std::uint32_t>(parts_));
    } else {
      excepts_a_stranger_ = true;
    }
  }

  State& state_;
  std::vector<const detail::BodySet*> sets_;
  std::size_t parts_ = 0;  // bodies before the movers
  detail::LeftOut left_out_;
  bool excepts_a_stranger_ = false;
};

SceneClosest SceneClosestBatch::at(std::size_t i) const {
  return row_of<SceneClosest>(*this, i);
}

SceneHit SceneHitBatch::at(std::size_t i) const {
  return row_of<SceneHit>(*this, i);
}

SceneClosest Scene::closest(const Vec3& point, const ClosestOptions& options,
                            const SceneFilter& filter, const Limits& limits) const {
  const View view(*state_, filter);
  const BodyClosest found = detail::closest(view.sets(), point, options, view.left_out(), limits);
  return {found, view.name(found.body)};
}

SceneClosestBatch Scene::closest(std::span<const Vec3> points, const ClosestOptions& options,
                                 const SceneFilter& filter, const Limits& limits) const {
  const View view(*state_, filter);
  BodyClosestBatch found = detail::closest(view.sets(), points, options, view.left_out(), limits);
  auto names = view.names(found.body);
  return {std::move(found), std::move(names)};
}

SceneHit Scene::closest_hit(const Ray& ray, const RayOptions& options, const SceneFilter& filter,
                            const Limits& limits) const {
  const View view(*state_, filter);
  const BodyHit found =
      detail::closest_hit(view.sets(), ray, view.options(options), view.left_out(), limits);
  return {found, view.name(found.body)};
}

SceneHitBatch Scene::closest_hit(std::span<const Ray> rays, const RayOptions& options,
                                 const SceneFilter& filter, const Limits& limits) const {
  const View view(*state_, filter);
  BodyHitBatch found =
      detail::closest_hit(view.sets(), rays, view.options(options), view.left_out(), limits);
  auto names = view.names(found.body);
  return {std::move(found), std::move(names)};
}

AnyHit Scene::any_hit(const Ray& ray, const RayOptions& options, const SceneFilter& filter,
                      const Limits& limits) const {
  const View view(*state_, filter);
  return detail::any_hit(view.sets(), ray, view.options(options), view.left_out(), limits);
}

AnyHitBatch Scene::any_hit(std::span<const Ray> rays, const RayOptions& options,
                           const SceneFilter& filter, const Limits& limits) const {
  const View view(*state_, filter);
  return detail::any_hit(view.sets(), rays, view.options(options), view.left_out(), limits);
}

SceneAllHits Scene::all_hits(std::span<const Ray> rays, const RayOptions& options,
                             const SceneFilter& filter, const Limits& limits) const {
  const View view(*state_, filter);
  return view.named(
      detail::all_hits(view.sets(), rays, view.options(options), view.left_out(), limits));
}

}  // namespace soms
