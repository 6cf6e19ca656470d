#include "soms/scene/scene.h"

#include "soms/base/error.h"
#include "soms/base/hash.h"
#include "soms/scene/broad_phase.h"
#include "soms/scene/detail/box_index.h"
#include "soms/scene/detail/id_list.h"
#include "soms/scene/detail/moved_bounds.h"

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

/// A question for the narrow phase, by places in the lists.
struct Candidate {
  std::uint32_t mover = 0;
  std::uint32_t other = 0;
};

/// Candidates of one chunk that ask about the same shape and the same other body: asked together.
struct Batch {
  const WideTree* layout = nullptr;
  std::uint32_t other = 0;
  std::vector<std::uint32_t> candidates;
  std::vector<Pose> poses;
  OverlapBatch answers;
};

/// What one chunk of candidates found; its memory is kept from step to step.
template <typename Contact>
struct Found {
  std::vector<Contact> contacts;
  Cost cost;
  std::vector<Batch> batches;
  std::vector<std::span<const TrianglePair>> answers;
};

template <typename Contact>
std::size_t memory_of(const std::vector<Found<Contact>>& found) {
  std::size_t size = detail::bytes(found);
  for (const Found<Contact>& chunk : found) {
    size += detail::bytes(chunk.contacts);
  }
  return size;
}

/// Candidates that one thread takes at a time. A constant, so that results join the same way for
/// any number of threads.
constexpr std::size_t kChunk = 64;

/// Fewer candidates than this are each worth all threads.
constexpr std::size_t kFew = 4;

bool holds(const std::vector<std::uint32_t>& sorted, std::uint32_t id) {
  return std::binary_search(sorted.begin(), sorted.end(), id);
}

void insert(std::vector<std::uint32_t>& sorted, std::uint32_t id) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), id);
  if (at == sorted.end() || *at != id) {
    sorted.insert(at, id);
  }
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

/// The batches of `candidates`, in the order in which each begins. `memory` is reused.
std::span<Batch> gather(std::span<const Candidate> candidates, const Residents& movers,
                        std::vector<Batch>& memory) {
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < candidates.size(); ++k) {
    const Body& body = movers.places()[candidates[k].mover].value.body;
    const WideTree* const layout = &body.shape.layout();
    std::size_t at = 0;
    while (at < count && (memory[at].layout != layout || memory[at].other != candidates[k].other)) {
      ++at;
    }
    if (at == count) {
      if (++count > memory.size()) {
        memory.emplace_back();
      }
      memory[at].layout = layout;
      memory[at].other = candidates[k].other;
      memory[at].candidates.clear();
      memory[at].poses.clear();
    }
    memory[at].candidates.push_back(k);
    memory[at].poses.push_back(body.pose);
  }
  return std::span(memory).first(count);
}

/// Asks the narrow phase some candidates and appends what it finds to `found`, in their order.
template <typename Contact>
void ask_one_by_one(std::span<const Candidate> candidates, const Residents& movers,
                    const Residents& others, const OverlapOptions& options,
                    const Parallel& parallel, Found<Contact>& found) {
  for (const Candidate& candidate : candidates) {
    const auto& a = movers.places()[candidate.mover];
    const auto& b = others.places()[candidate.other];
    const Overlap answer = overlap(a.value.body, b.value.body, options, parallel);
    for (const auto& [i, j] : answer.pairs) {
      found.contacts.push_back({a.id, b.id, i, j});
    }
    found.cost += answer.cost;
  }
}

/// The same by batches, which is faster where movers share shapes.
template <typename Contact>
void ask_together(std::span<const Candidate> candidates, const Residents& movers,
                  const Residents& others, const OverlapOptions& options, const Parallel& parallel,
                  Found<Contact>& found) {
  const std::span<Batch> batches = gather(candidates, movers, found.batches);
  found.answers.resize(candidates.size());
  for (Batch& batch : batches) {
    const Shape& shape = movers.places()[candidates[batch.candidates[0]].mover].value.body.shape;
    const Body& other = others.places()[batch.other].value.body;
    batch.answers = overlap(shape, batch.poses, other, options, parallel);
    found.cost += batch.answers.cost;
    for (std::size_t p = 0; p < batch.candidates.size(); ++p) {
      found.answers[batch.candidates[p]] = batch.answers.pairs_of(p);
    }
  }
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const MoverId a = movers.places()[candidates[k].mover].id;
    const std::uint32_t b = others.places()[candidates[k].other].id;
    for (const auto& [i, j] : found.answers[k]) {
      found.contacts.push_back({a, b, i, j});
    }
  }
}

/// Asks the narrow phase all candidates and appends what it finds to `contacts`, in their order.
template <typename Contact>
void ask(const std::vector<Candidate>& candidates, const Residents& movers, const Residents& others,
         OverlapMode mode, const Parallel& parallel, std::vector<Found<Contact>>& found,
         std::vector<Contact>& contacts, Cost& cost) {
  const std::size_t chunks = (candidates.size() + kChunk - 1) / kChunk;
  if (found.size() < chunks) {
    found.resize(chunks);
  }
  // A lone pair of large meshes is split inside; many pairs are shared out.
  const bool lone = candidates.size() < kFew;
  const Parallel shared{lone ? 1 : parallel.threads, parallel.stop, {}};
  const Parallel inside{lone ? parallel.threads : 1, parallel.stop, {}};
  const OverlapOptions options{.mode = mode};
  for_each_chunk(candidates.size(), kChunk, shared, [&](std::size_t begin, std::size_t end) {
    Found<Contact>& mine = found[begin / kChunk];
    mine.contacts.clear();
    mine.cost = {};
    const std::span part = std::span(candidates).subspan(begin, end - begin);
    if (lone) {
      ask_one_by_one(part, movers, others, options, inside, mine);
    } else {
      ask_together(part, movers, others, options, inside, mine);
    }
  });
  for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
    contacts.insert(contacts.end(), found[chunk].contacts.begin(), found[chunk].contacts.end());
    cost += found[chunk].cost;
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
  std::vector<Found<EnvironmentContact>> found_environment;
  std::vector<Found<MoverContact>> found_movers;

  void refresh_index();
  void find_environment_candidates(StepReport& report);
  void find_mover_candidates(StepReport& report);
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

Scene::Scene() : state_(std::make_unique<State>()) {
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

EnvironmentId Scene::add_environment(Body body) {
  const Box box = place(body, body.pose, "new part of the environment");
  state_->parts_changed = true;
  return state_->parts.add({std::move(body), box, 0, {}, {}});
}

void Scene::remove_environment(EnvironmentId id) {
  for (const std::uint32_t mover : state_->parts.at(id).ignored_others) {
    erase(state_->movers.at(mover).ignored_others, id);
  }
  state_->parts.remove(id);
  state_->parts_changed = true;
}

MoverId Scene::add_mover(Body body, std::uint32_t group) {
  const Box box = place(body, body.pose, "new mover");
  return state_->movers.add({std::move(body), box, group, {}, {}});
}

void Scene::remove_mover(MoverId id) {
  const Resident& resident = state_->movers.at(id);
  for (const std::uint32_t other : resident.ignored_movers) {
    erase(state_->movers.at(other).ignored_movers, id);
  }
  for (const std::uint32_t part : resident.ignored_others) {
    erase(state_->parts.at(part).ignored_others, id);
  }
  state_->movers.remove(id);
}

void Scene::ignore(MoverId a, MoverId b) {
  Resident& first = state_->movers.at(a);
  Resident& second = state_->movers.at(b);
  if (a == b) {
    throw Error(ErrorKind::usage, "scene: mover " + std::to_string(a) + " is to ignore itself",
                "name two movers; a mover is never compared with itself");
  }
  insert(first.ignored_movers, b);
  insert(second.ignored_movers, a);
}

void Scene::ignore_environment(MoverId mover, EnvironmentId part) {
  Resident& first = state_->movers.at(mover);
  Resident& second = state_->parts.at(part);
  insert(first.ignored_others, part);
  insert(second.ignored_others, mover);
}

void Scene::set_pose(MoverId id, const Pose& pose) {
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
         detail::bytes(state.candidates) + memory_of(state.found_environment) +
         memory_of(state.found_movers);
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
  State& state = *state_;
  StepReport report;
  report.coverage = options.mode == OverlapMode::all ? Coverage::complete : Coverage::first;
  check_stop(parallel);
  state.refresh_index();
  state.find_environment_candidates(report);
  ask(state.candidates, state.movers, state.parts, options.mode, parallel, state.found_environment,
      report.environment, report.cost);
  if (options.mover_mover) {
    state.find_mover_candidates(report);
    ask(state.candidates, state.movers, state.movers, options.mode, parallel, state.found_movers,
        report.movers, report.cost);
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
