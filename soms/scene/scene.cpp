#include "soms/scene/scene.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/scene/detail/kept_memory.h"
#include "soms/scene/detail/scene_state.h"

#include <string>
#include <utility>

namespace soms {

using detail::Resident;

Scene::Scene() : state_(std::make_unique<State>()) {
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

EnvironmentId Scene::add_environment(Body body) {
  const PlainArithmetic plain;
  const Box box = detail::world_box(body, body.shape, body.pose, "new part of the environment");
  state_->parts_changed = true;
  return state_->parts.add({std::move(body), box, 0, {}, {}, {}});
}

void Scene::remove_environment(EnvironmentId id) {
  // What may fail for want of memory comes first: the copy of the list and the removal.
  const std::vector<std::uint32_t> movers = state_->parts.at(id).ignored_others;
  state_->parts_changed = true;
  state_->parts.remove(id);
  for (const std::uint32_t mover : movers) {
    detail::erase(state_->movers.at(mover).ignored_others, id);
  }
}

MoverId Scene::add_mover(Body body, std::uint32_t group) {
  const PlainArithmetic plain;
  const Box box = detail::world_box(body, body.shape, body.pose, "new mover");
  state_->filter_changed = state_->filter_changed || group != 0;
  state_->movers_changed = true;
  return state_->movers.add(
      {std::move(body), box, group, {}, {}, detail::LastPlace(state_->steps)});
}

void Scene::remove_mover(MoverId id) {
  const Resident& resident = state_->movers.at(id);
  const std::vector<std::uint32_t> others = resident.ignored_movers;
  const std::vector<std::uint32_t> parts = resident.ignored_others;
  const std::size_t places = state_->movers.places().size();
  state_->movers_changed = true;
  state_->movers.remove(id);
  // An empty place meets nothing, so its group may stay; but places may have moved.
  state_->filter_changed =
      state_->filter_changed || !others.empty() || state_->movers.places().size() != places;
  for (const std::uint32_t other : others) {
    detail::erase(state_->movers.at(other).ignored_movers, id);
  }
  for (const std::uint32_t part : parts) {
    detail::erase(state_->parts.at(part).ignored_others, id);
  }
}

void Scene::ignore(MoverId a, MoverId b) {
  Resident& first = state_->movers.at(a);
  Resident& second = state_->movers.at(b);
  if (a == b) {
    throw Error(ErrorKind::usage, "scene: mover " + std::to_string(a) + " cannot ignore itself",
                "name two movers; a mover is never compared with itself");
  }
  if (detail::insert_mutually(first.ignored_movers, b, second.ignored_movers, a)) {
    state_->filter_changed = true;
  }
}

void Scene::unignore(MoverId a, MoverId b) {
  Resident& first = state_->movers.at(a);
  Resident& second = state_->movers.at(b);
  if (detail::erase(first.ignored_movers, b)) {
    detail::erase(second.ignored_movers, a);
    state_->filter_changed = true;
  }
}

void Scene::set_group(MoverId id, std::uint32_t group) {
  Resident& resident = state_->movers.at(id);
  state_->filter_changed = state_->filter_changed || group != resident.group;
  resident.group = group;
}

void Scene::ignore_environment(MoverId mover, EnvironmentId part) {
  Resident& first = state_->movers.at(mover);
  Resident& second = state_->parts.at(part);
  detail::insert_mutually(first.ignored_others, part, second.ignored_others, mover);
}

void Scene::unignore_environment(MoverId mover, EnvironmentId part) {
  Resident& first = state_->movers.at(mover);
  Resident& second = state_->parts.at(part);
  detail::erase(first.ignored_others, part);
  detail::erase(second.ignored_others, mover);
}

void Scene::set_pose(MoverId id, const Pose& pose) {
  const PlainArithmetic plain;
  Resident& resident = state_->movers.at(id);
  resident.box = detail::world_box(resident.body, resident.body.shape, pose, "mover", id);
  resident.last.leave(resident.body.pose, state_->steps);
  resident.body.pose = pose;
  state_->movers_changed = true;
}

void Scene::set_shape(MoverId id, Shape shape) {
  const PlainArithmetic plain;
  Resident& resident = state_->movers.at(id);
  resident.box = detail::world_box(resident.body, shape, resident.body.pose, "mover", id);
  resident.body.shape = std::move(shape);
  resident.last = detail::LastPlace(state_->steps);
  state_->movers_changed = true;
  ++state_->shapes_set;
}

void Scene::set_environment_shape(EnvironmentId id, Shape shape) {
  const PlainArithmetic plain;
  Resident& resident = state_->parts.at(id);
  resident.box =
      detail::world_box(resident.body, shape, resident.body.pose, "part of the environment", id);
  resident.body.shape = std::move(shape);
  state_->parts_changed = true;
  ++state_->shapes_set;
}

std::size_t Scene::memory() const {
  const State& state = *state_;
  return sizeof(State) + detail::memory_of(state.movers) + detail::memory_of(state.parts) +
         state.part_set.memory() + state.mover_set.memory() + state.broad_phase.memory() +
         detail::bytes(state.boxes) + detail::bytes(state.met) + detail::bytes(state.candidates) +
         detail::bytes(state.near) + detail::bytes(state.passing) + detail::bytes(state.questions) +
         state.first_contacts.memory() + state.environment.memory() + state.mutual.memory() +
         state.distances.memory() + state.swept_phase.memory();
}

const Body& Scene::mover(MoverId id) const {
  return state_->movers.at(id).body;
}

const Body& Scene::environment(EnvironmentId id) const {
  return state_->parts.at(id).body;
}

std::vector<MoverId> Scene::movers() const {
  return state_->movers.ids();
}

std::vector<EnvironmentId> Scene::environments() const {
  return state_->parts.ids();
}

}  // namespace soms
