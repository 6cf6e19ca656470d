// What is nearest to points, and first on rays, among the bodies of a scene.
#include "soms/scene/scene_query.h"

#include "soms/base/arithmetic.h"
#include "soms/scene/detail/scene_state.h"
#include "soms/scene/detail/search/answer_queries.h"
#include "soms/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

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

  /// An answer of the search whose bodies have their names.
  template <class Answer>
  [[nodiscard]] OfBodies<Answer, SceneBody> named(OfBodies<Answer, std::uint32_t> found) const {
    auto names = names_of(found.body);
    return {std::move(found), std::move(names)};
  }

 private:
  [[nodiscard]] SceneBody names_of(std::uint32_t number) const {
    return number < parts_
               ? SceneBody{SceneBodyKind::environment, state_.parts.places()[number].id}
               : SceneBody{SceneBodyKind::mover, state_.movers.places()[number - parts_].id};
  }

  [[nodiscard]] std::optional<SceneBody> names_of(std::optional<std::uint32_t> number) const {
    return number ? std::optional(names_of(*number)) : std::nullopt;
  }

  template <class Number>
  [[nodiscard]] auto names_of(const std::vector<Number>& numbers) const {
    std::vector<decltype(names_of(numbers.front()))> names;
    names.reserve(numbers.size());
    for (const Number number : numbers) {
      names.push_back(names_of(number));
    }
    return names;
  }

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

Scene::View Scene::view(const SceneFilter& filter) const {
  return {*state_, filter};
}

template class BodyQueries<Scene, SceneBody, SceneFilter>;

}  // namespace soms
