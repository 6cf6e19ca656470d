#include "soms/scene/scene.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/hash.h"
#include "soms/scene/broad_phase.h"
#include "soms/scene/detail/box_index.h"
#include "soms/scene/detail/id_list.h"
#include "soms/scene/detail/moved_bounds.h"
#include "soms/scene/detail/narrow_phase.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace soms {

namespace {

/// A body of the scene with its world box, which is set together with the pose and nowhere else.
struct Resident {
  Body body;
  Box box;
  std::uint32_t group = 0;
  /// Mover: numbers of movers not compared with. Kept on both sides, so removal finds all.
  std::vector<std::uint32_t> ignored_movers;
  /// Mover: parts not compared with. Part: the movers that ignore it.
  std::vector<std::uint32_t> ignored_others;
};

using Residents = detail::IdList<Resident>;

/// A pair of bodies, by places in the lists.
struct Candidate {
  std::uint32_t mover = 0;
  std::uint32_t other = 0;
};

bool holds(const std::vector<std::uint32_t>& sorted, std::uint32_t id) {
  return std::binary_search(sorted.begin(), sorted.end(), id);
}

void insert(std::vector<std::uint32_t>& sorted, std::uint32_t id) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), id);
  if (at == sorted.end() || *at != id) {
    sorted.insert(at, id);
  }
}

/// Each into the other's list: into both or, where memory runs short, into none.
void insert_mutually(std::vector<std::uint32_t>& list_a, std::uint32_t b,
                     std::vector<std::uint32_t>& list_b, std::uint32_t a) {
  const auto make_room = [](std::vector<std::uint32_t>& list) {
    if (list.size() == list.capacity()) {
      list.reserve(2 * list.size() + 1);
    }
  };
  make_room(list_a);
  make_room(list_b);
  insert(list_a, b);
  insert(list_b, a);
}

void erase(std::vector<std::uint32_t>& sorted, std::uint32_t id) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), id);
  if (at != sorted.end() && *at == id) {
    sorted.erase(at);
  }
}

/// World box of a body. \errors As `overlap` for the pose; the message names the body.
Box place(const Body& body, const Pose& pose, std::string_view what,
          std::optional<std::uint32_t> id = std::nullopt) {
  try {
    check(pose);
    check_range(pose, body.shape.bounds());
  } catch (const Error& error) {
    std::string subject(what);
    if (id) {
      subject += " " + std::to_string(*id);
    }
    if (!body.name.empty()) {
      subject += " (" + body.name + ")";
    }
    throw Error(error.kind(), subject + ": " + error.place(), error.remedy());
  }
  return detail::moved_bounds(pose, body.shape.bounds());
}

void collect_boxes(const Residents& residents, std::vector<Box>& boxes) {
  boxes.clear();
  for (const auto& resident : residents.places()) {
    boxes.push_back(resident.value.box);
  }
}

}  // namespace

struct Scene::State {
  Residents movers{"mover"};
  Residents parts{"part of the environment"};
  bool parts_changed = false;
  detail::BoxIndex part_index;
  BroadPhase broad_phase;

  // Memory of a step, kept for the next.
  std::vector<Box> boxes;
  std::vector<std::uint32_t> met;
  std::vector<Candidate> candidates;
  std::vector<detail::Question> questions;
  detail::NarrowPhase environment;
  detail::NarrowPhase mutual;
  void refresh_index();
  void find_environment_candidates(StepReport& report);
  void find_mover_candidates(StepReport& report);
  template <typename Contact>
  void ask(detail::NarrowPhase& narrow_phase, const Residents& others,
           const OverlapOptions& options, const Parallel& parallel, std::vector<Contact>& contacts,
           Cost& cost);
};

/// The environment seldom changes: its structure is made when a step first needs it.
void Scene::State::refresh_index() {
  if (parts_changed) {
    collect_boxes(parts, boxes);
    part_index.build(boxes);
    parts_changed = false;
  }
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
      if (!holds(resident.ignored_others, parts.places()[part].id)) {
        candidates.push_back({mover, part});
      }
    }
  }
  report.queries += candidates.size();
}

void Scene::State::find_mover_candidates(StepReport& report) {
  candidates.clear();
  const auto& places = movers.places();
  collect_boxes(movers, boxes);
  const auto pairs = broad_phase.find(boxes);
  report.box_pairs += pairs.size();
  for (const auto& [a, b] : pairs) {
    const Resident& first = places[a].value;
    const bool same_group = first.group != 0 && first.group == places[b].value.group;
    if (!same_group && !holds(first.ignored_movers, places[b].id)) {
      candidates.push_back({a, b});
    }
  }
  report.queries += candidates.size();
}

/// Asks about all candidates and appends what touches to `contacts`, in their order.
template <typename Contact>
void Scene::State::ask(detail::NarrowPhase& narrow_phase, const Residents& others,
                       const OverlapOptions& options, const Parallel& parallel,
                       std::vector<Contact>& contacts, Cost& cost) {
  questions.clear();
  for (const Candidate& candidate : candidates) {
    questions.push_back({&movers.places()[candidate.mover].value.body,
                         &others.places()[candidate.other].value.body});
  }
  cost += narrow_phase.ask(questions, options, parallel);
  std::size_t found = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    found += narrow_phase.pairs_of(k).size();
  }
  contacts.reserve(found);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const MoverId a = movers.places()[candidates[k].mover].id;
    const std::uint32_t b = others.places()[candidates[k].other].id;
    for (const auto& [i, j] : narrow_phase.pairs_of(k)) {
      contacts.push_back({a, b, i, j});
    }
  }
}

Scene::Scene() : state_(std::make_unique<State>()) {
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

EnvironmentId Scene::add_environment(Body body) {
  const PlainArithmetic plain;
  const Box box = place(body, body.pose, "new part of the environment");
  state_->parts_changed = true;
  return state_->parts.add({std::move(body), box, 0, {}, {}});
}

void Scene::remove_environment(EnvironmentId id) {
  // What may fail for want of memory comes first: the copy of the list and the removal.
  const std::vector<std::uint32_t> movers = state_->parts.at(id).ignored_others;
  state_->parts.remove(id);
  state_->parts_changed = true;
  for (const std::uint32_t mover : movers) {
    erase(state_->movers.at(mover).ignored_others, id);
  }
}

MoverId Scene::add_mover(Body body, std::uint32_t group) {
  const PlainArithmetic plain;
  const Box box = place(body, body.pose, "new mover");
  return state_->movers.add({std::move(body), box, group, {}, {}});
}

void Scene::remove_mover(MoverId id) {
  const Resident& resident = state_->movers.at(id);
  const std::vector<std::uint32_t> others = resident.ignored_movers;
  const std::vector<std::uint32_t> parts = resident.ignored_others;
  state_->movers.remove(id);
  for (const std::uint32_t other : others) {
    erase(state_->movers.at(other).ignored_movers, id);
  }
  for (const std::uint32_t part : parts) {
    erase(state_->parts.at(part).ignored_others, id);
  }
}

void Scene::ignore(MoverId a, MoverId b) {
  Resident& first = state_->movers.at(a);
  Resident& second = state_->movers.at(b);
  if (a == b) {
    throw Error(ErrorKind::usage, "scene: mover " + std::to_string(a) + " is to ignore itself",
                "name two movers; a mover is never compared with itself");
  }
  insert_mutually(first.ignored_movers, b, second.ignored_movers, a);
}

void Scene::ignore_environment(MoverId mover, EnvironmentId part) {
  Resident& first = state_->movers.at(mover);
  Resident& second = state_->parts.at(part);
  insert_mutually(first.ignored_others, part, second.ignored_others, mover);
}

void Scene::set_pose(MoverId id, const Pose& pose) {
  const PlainArithmetic plain;
  Resident& resident = state_->movers.at(id);
  resident.box = place(resident.body, pose, "mover", id);
  resident.body.pose = pose;
}

std::size_t Scene::memory() const {
  const auto of = [](const Residents& residents) {
    std::size_t bytes = residents.places().capacity() * sizeof(Residents::Place);
    for (const auto& place : residents.places()) {
      const Resident& resident = place.value;
      bytes += sizeof(MoverId) *
               (resident.ignored_movers.capacity() + resident.ignored_others.capacity());
    }
    return bytes;
  };
  const State& state = *state_;
  return sizeof(State) + of(state.movers) + of(state.parts) + state.part_index.memory() +
         state.broad_phase.memory() + detail::bytes(state.boxes) + detail::bytes(state.met) +
         detail::bytes(state.candidates) + detail::bytes(state.questions) +
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
  report.coverage = options.mode == OverlapMode::all ? Coverage::complete : Coverage::first;
  const OverlapOptions asked{.mode = options.mode, .traversal = options.traversal};
  check(asked);  // also where nothing meets
  check_stop(parallel);
  state.refresh_index();
  state.find_environment_candidates(report);
  state.ask(state.environment, state.parts, asked, parallel, report.environment, report.cost);
  if (options.mover_mover) {
    check_stop(parallel);
    if (!options.coherent) {
      state.broad_phase.forget();
    }
    state.find_mover_candidates(report);
    state.ask(state.mutual, state.movers, asked, parallel, report.movers, report.cost);
  }
  return report;
}

std::uint64_t StepReport::hash() const {
  Fnv1a hash;
  for (const EnvironmentContact& contact : environment) {
    for (const std::uint32_t value : {contact.mover, contact.part, contact.i, contact.j}) {
      hash.add(value);
    }
  }
  for (const MoverContact& contact : movers) {
    for (const std::uint32_t value : {contact.a, contact.b, contact.i, contact.j}) {
      hash.add(value);
    }
  }
  return hash.value();
}

}  // namespace soms
