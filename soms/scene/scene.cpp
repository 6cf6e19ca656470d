#include "soms/scene/scene.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/scene/broad_phase.h"
#include "soms/scene/detail/box_index.h"
#include "soms/scene/detail/first_contacts.h"
#include "soms/scene/detail/kept_memory.h"
#include "soms/scene/detail/narrow_phase.h"
#include "soms/scene/detail/residents.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace soms {

namespace {

using detail::Candidate;
using detail::Resident;
using detail::Residents;

/// Bytes that the narrow phase needs for a question, and for a pair of triangles found.
constexpr std::size_t kBytesOfAQuestion = 256;
constexpr std::size_t kBytesOfAFind = 16;

}  // namespace

struct Scene::State {
  Residents movers{"mover"};
  Residents parts{"part of the environment"};
  bool parts_changed = false;
  bool filter_changed = false;
  bool has_filter = false;
  std::uint64_t shapes_set = 0;
  detail::BoxIndex part_index;
  BroadPhase broad_phase;

  // Memory of a step, kept for the next.
  std::vector<Box> boxes;
  std::vector<std::uint32_t> met;
  std::vector<Candidate> candidates;
  std::vector<detail::BodyPair> questions;
  std::size_t most_candidates = 0;  ///< of this step
  detail::FirstContacts first_contacts;
  detail::NarrowPhase environment;
  detail::NarrowPhase mutual;

  void refresh_index();
  void refresh_filter();
  void find_environment_candidates(StepReport& report);
  void find_mover_candidates(StepReport& report);
  template <typename Contact>
  void ask(detail::NarrowPhase& narrow_phase, const Residents& others,
           const OverlapOptions& options, const Parallel& parallel, std::vector<Contact>& contacts,
           StepReport& report);
  template <typename Contact>
  void ask_until_first(detail::NarrowPhase& narrow_phase, const Residents& others,
                       const OverlapOptions& options, const Parallel& parallel,
                       std::vector<Contact>& contacts, StepReport& report);
  template <typename Contact>
  void append(const Candidate& candidate, const Residents& others,
              std::span<const TrianglePair> pairs, std::vector<Contact>& contacts) const;

  [[nodiscard]] detail::BodyPair question(const Candidate& candidate,
                                          const Residents& others) const {
    return {&movers.places()[candidate.mover].value.body,
            &others.places()[candidate.other].value.body};
  }

  void give_back();
};

/// The environment seldom changes: its structure is made when a step first needs it.
void Scene::State::refresh_index() {
  if (parts_changed) {
    detail::collect_boxes(parts, boxes);
    part_index.build(boxes);
    parts_changed = false;
  }
}

/// Groups and ignored pairs by place, as the broad phase wants them.
void Scene::State::refresh_filter() {
  if (!filter_changed) {
    return;
  }
  std::vector<std::uint32_t> groups;
  std::vector<BoxPair> ignored;
  const auto& places = movers.places();
  for (std::uint32_t place = 0; place < places.size(); ++place) {
    const Resident& resident = places[place].value;
    if (resident.group != 0) {
      groups.resize(place);
      groups.push_back(resident.group);
    }
    const auto& ids = resident.ignored_movers;
    for (auto id = std::upper_bound(ids.begin(), ids.end(), places[place].id); id != ids.end();
         ++id) {
      ignored.emplace_back(place, movers.place_of(*id));
    }
  }
  const bool filters = !groups.empty() || !ignored.empty();
  if (filters || has_filter) {
    broad_phase.set_filter(std::move(groups), ignored);
    has_filter = filters;
  }
  filter_changed = false;
}

/// Candidates ascend by mover, then part.
void Scene::State::find_environment_candidates(StepReport& report) {
  candidates.clear();
  const auto& places = movers.places();
  for (std::uint32_t mover = 0; mover < places.size(); ++mover) {
    const Resident& resident = places[mover].value;
    if (resident.box.empty()) {
      continue;
    }
    met.clear();
    part_index.query(resident.box, [&](std::uint32_t part) { met.push_back(part); });
    std::sort(met.begin(), met.end());
    report.box_pairs += met.size();
    for (const std::uint32_t part : met) {
      if (!detail::holds(resident.ignored_others, parts.places()[part].id)) {
        candidates.push_back({mover, part});
      }
    }
  }
  most_candidates = std::max(most_candidates, candidates.size());
}

void Scene::State::find_mover_candidates(StepReport& report) {
  candidates.clear();
  detail::collect_boxes(movers, boxes);
  refresh_filter();
  const auto pairs = broad_phase.find(boxes);
  report.box_pairs += pairs.size();
  candidates.reserve(pairs.size());
  for (const auto& [a, b] : pairs) {
    candidates.push_back({a, b});
  }
  most_candidates = std::max(most_candidates, candidates.size());
}

/// Appends the pairs of triangles of a candidate.
template <typename Contact>
void Scene::State::append(const Candidate& candidate, const Residents& others,
                          std::span<const TrianglePair> pairs,
                          std::vector<Contact>& contacts) const {
  const MoverId a = movers.places()[candidate.mover].id;
  const std::uint32_t b = others.places()[candidate.other].id;
  for (const auto& [i, j] : pairs) {
    contacts.push_back({a, b, i, j});
  }
}

/// Asks about all candidates and appends what touches to `contacts`, in their order.
template <typename Contact>
void Scene::State::ask(detail::NarrowPhase& narrow_phase, const Residents& others,
                       const OverlapOptions& options, const Parallel& parallel,
                       std::vector<Contact>& contacts, StepReport& report) {
  questions.clear();
  for (const Candidate& candidate : candidates) {
    questions.push_back(question(candidate, others));
  }
  report.queries += questions.size();
  report.cost += narrow_phase.ask(questions, options, parallel);
  std::size_t found = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    found += narrow_phase.pairs_of(k).size();
  }
  contacts.reserve(found);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    append(candidates[k], others, narrow_phase.pairs_of(k), contacts);
  }
}

/// Asks about the candidates round by round until each mover has its first contact or none.
template <typename Contact>
void Scene::State::ask_until_first(detail::NarrowPhase& narrow_phase, const Residents& others,
                                   const OverlapOptions& options, const Parallel& parallel,
                                   std::vector<Contact>& contacts, StepReport& report) {
  first_contacts.begin(candidates, &others == &movers);
  for (auto round = first_contacts.next_round(); !round.empty();
       round = first_contacts.next_round()) {
    questions.clear();
    for (const std::uint32_t k : round) {
      questions.push_back(question(candidates[k], others));
    }
    report.queries += questions.size();
    report.cost += narrow_phase.ask(questions, options, parallel);
    for (std::size_t at = 0; at < round.size(); ++at) {
      const auto pairs = narrow_phase.pairs_of(at);
      if (!pairs.empty()) {
        append(candidates[round[at]], others, pairs, contacts);
        first_contacts.touch(round[at]);
      }
    }
  }
  std::sort(contacts.begin(), contacts.end());
}

/// What earlier steps needed and this one did not.
void Scene::State::give_back() {
  const std::size_t bodies = std::max(movers.places().size(), parts.places().size());
  detail::give_back(boxes, bodies);
  detail::give_back(met, bodies);
  detail::give_back(candidates, most_candidates);
  detail::give_back(questions, most_candidates);
  first_contacts.give_back();
}

Scene::Scene() : state_(std::make_unique<State>()) {
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

EnvironmentId Scene::add_environment(Body body) {
  const PlainArithmetic plain;
  const Box box = detail::world_box(body, body.shape, body.pose, "new part of the environment");
  state_->parts_changed = true;
  return state_->parts.add({std::move(body), box, 0, {}, {}});
}

void Scene::remove_environment(EnvironmentId id) {
  // What may fail for want of memory comes first: the copy of the list and the removal.
  const std::vector<std::uint32_t> movers = state_->parts.at(id).ignored_others;
  state_->parts.remove(id);
  state_->parts_changed = true;
  for (const std::uint32_t mover : movers) {
    detail::erase(state_->movers.at(mover).ignored_others, id);
  }
}

MoverId Scene::add_mover(Body body, std::uint32_t group) {
  const PlainArithmetic plain;
  const Box box = detail::world_box(body, body.shape, body.pose, "new mover");
  state_->filter_changed = state_->filter_changed || group != 0;
  return state_->movers.add({std::move(body), box, group, {}, {}});
}

void Scene::remove_mover(MoverId id) {
  const Resident& resident = state_->movers.at(id);
  const std::vector<std::uint32_t> others = resident.ignored_movers;
  const std::vector<std::uint32_t> parts = resident.ignored_others;
  const std::size_t places = state_->movers.places().size();
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
  resident.body.pose = pose;
}

void Scene::set_shape(MoverId id, Shape shape) {
  const PlainArithmetic plain;
  Resident& resident = state_->movers.at(id);
  resident.box = detail::world_box(resident.body, shape, resident.body.pose, "mover", id);
  resident.body.shape = std::move(shape);
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
         state.part_index.memory() + state.broad_phase.memory() + detail::bytes(state.boxes) +
         detail::bytes(state.met) + detail::bytes(state.candidates) +
         detail::bytes(state.questions) + state.first_contacts.memory() +
         state.environment.memory() + state.mutual.memory();
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

StepReport Scene::step(const StepOptions& options, const Parallel& parallel) {
  const PlainArithmetic plain;
  State& state = *state_;
  StepReport report;
  report.scope = options.scope;
  report.mover_mover = options.mover_mover;
  report.shapes_set = state.shapes_set;
  const bool until_first = options.scope == StepScope::first_contact;
  report.coverage =
      options.mode == OverlapMode::all && !until_first ? Coverage::complete : Coverage::first;
  const OverlapOptions query{.mode = options.mode, .traversal = options.traversal};
  check(query);  // also where nothing meets
  const auto ask = [&](detail::NarrowPhase& narrow_phase, const Residents& others, auto& contacts) {
    if (until_first) {
      state.ask_until_first(narrow_phase, others, query, parallel, contacts, report);
    } else {
      state.ask(narrow_phase, others, query, parallel, contacts, report);
    }
    const std::size_t needed =
        kBytesOfAQuestion * state.candidates.size() + kBytesOfAFind * contacts.size();
    if (detail::is_far_above(narrow_phase.memory(), needed)) {
      narrow_phase = {};
    }
  };
  check_stop(parallel);
  state.most_candidates = 0;
  state.first_contacts.start(until_first ? state.movers.places().size() : 0);
  state.refresh_index();
  state.find_environment_candidates(report);
  ask(state.environment, state.parts, report.environment);
  if (options.mover_mover) {
    check_stop(parallel);
    if (!options.coherent) {
      state.broad_phase.forget();
    }
    state.find_mover_candidates(report);
    ask(state.mutual, state.movers, report.movers);
  }
  state.give_back();
  return report;
}

}  // namespace soms
