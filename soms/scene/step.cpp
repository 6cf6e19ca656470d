// A step of a scene: from boxes to pairs of bodies, from these to contacts and gaps.
#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/query/detail/check_options.h"
#include "soms/scene/detail/kept_memory.h"
#include "soms/scene/detail/scene_state.h"
#include "soms/scene/detail/widened.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace soms {

using detail::Candidate;
using detail::Resident;
using detail::Residents;

namespace {

/// Bytes that the narrow phase needs for a question, and for a pair of triangles found.
constexpr std::size_t kBytesOfAQuestion = 256;
constexpr std::size_t kBytesOfAFind = 16;

void check_options(const StepOptions& options) {
  detail::check_options(OverlapOptions{.mode = options.mode});
  if (!(options.clearance >= 0) || std::isinf(options.clearance)) {
    throw Error(ErrorKind::usage,
                "step options: the clearance is negative, infinite or not a number",
                "give a length, or 0 for contacts alone");
  }
  if (options.clearance > 0 && options.scope == StepScope::first_contact) {
    throw Error(ErrorKind::usage,
                "step options: a clearance goes with StepScope::every_pair alone, as "
                "first_contact leaves pairs of bodies out",
                "set the scope to every_pair, or the clearance to 0");
  }
}

}  // namespace

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

/// Candidates ascend by mover, then part, and so do those that may be near.
void Scene::State::find_environment_candidates(double clearance, StepReport& report) {
  candidates.clear();
  near.clear();
  const auto& places = movers.places();
  for (std::uint32_t mover = 0; mover < places.size(); ++mover) {
    const Resident& resident = places[mover].value;
    if (resident.box.empty()) {
      continue;
    }
    met.clear();
    const bool wide = clearance > 0;
    part_set.boxes().query(wide ? detail::widened(resident.box, clearance) : resident.box,
                           [&](std::uint32_t part) { met.push_back(part); });
    std::sort(met.begin(), met.end());
    for (const std::uint32_t part : met) {
      const auto& place = parts.places()[part];
      const bool meets = !wide || overlaps(resident.box, place.value.box);
      report.box_pairs += meets ? 1 : 0;
      if (detail::holds(resident.ignored_others, place.id)) {
        continue;
      }
      if (meets) {
        candidates.push_back({mover, part});
      }
      if (wide) {
        near.push_back({mover, part});
      }
    }
  }
}

/// With a clearance, each of two boxes takes half of it.
void Scene::State::find_mover_candidates(double clearance, StepReport& report) {
  candidates.clear();
  near.clear();
  detail::collect_boxes(movers, boxes);
  const bool wide = clearance > 0;
  if (wide) {
    for (Box& box : boxes) {
      box = detail::widened(box, clearance / 2);
    }
  }
  refresh_filter();
  const auto pairs = broad_phase.find(boxes);
  std::vector<Candidate>& found = wide ? near : candidates;
  found.reserve(pairs.size());
  for (const auto& [a, b] : pairs) {
    found.push_back({a, b});
  }
  if (wide) {
    const auto box = [this](std::uint32_t place) { return movers.places()[place].value.box; };
    std::copy_if(near.begin(), near.end(), std::back_inserter(candidates),
                 [&](const Candidate& pair) { return overlaps(box(pair.mover), box(pair.other)); });
  }
  report.box_pairs += candidates.size();
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
                       const detail::PairQuery& query, const Limits& limits,
                       std::vector<Contact>& contacts, StepReport& report) {
  questions.clear();
  for (const Candidate& candidate : candidates) {
    questions.push_back(question(candidate, others));
  }
  report.queries += questions.size();
  report.cost += narrow_phase.ask(questions, query, limits);
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
                                   const detail::PairQuery& query, const Limits& limits,
                                   std::vector<Contact>& contacts, StepReport& report) {
  first_contacts.begin(candidates, &others == &movers);
  for (auto round = first_contacts.next_round(); !round.empty();
       round = first_contacts.next_round()) {
    questions.clear();
    for (const std::uint32_t k : round) {
      questions.push_back(question(candidates[k], others));
    }
    report.queries += questions.size();
    report.cost += narrow_phase.ask(questions, query, limits);
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

/// Leaves in `near` the pairs for which `narrow_phase` found no touch. Both lists are sorted, and
/// `candidates`, its questions, are among `near`.
void Scene::State::keep_apart(const detail::NarrowPhase& narrow_phase) {
  std::size_t k = 0;
  std::erase_if(near, [&](const Candidate& pair) {
    return k < candidates.size() && candidates[k] == pair && !narrow_phase.pairs_of(k++).empty();
  });
}

/// The distances of the pairs in `near`, as far as they are within the clearance.
template <typename Gap>
void Scene::State::measure(const Residents& others, double clearance, const Limits& limits,
                           std::vector<Gap>& gaps, StepReport& report) {
  questions.clear();
  for (const Candidate& candidate : near) {
    questions.push_back(question(candidate, others));
  }
  report.gap_queries += questions.size();
  report.cost += near_phase.ask(questions, {.at_most = clearance}, limits);
  for (std::size_t k = 0; k < near.size(); ++k) {
    const Distance& answer = near_phase.answers()[k];
    if (!answer.farther && answer.triangles) {
      gaps.push_back({movers.places()[near[k].mover].id, others.places()[near[k].other].id,
                      answer.triangles->a, answer.triangles->b, answer.distance, answer.point_a,
                      answer.point_b});
    }
  }
}

/// Compares the pairs of bodies that were found.
template <typename Contact, typename Gap>
void Scene::State::compare(detail::NarrowPhase& narrow_phase, const Residents& others,
                           const StepOptions& options, const Limits& limits,
                           std::vector<Contact>& contacts, std::vector<Gap>& gaps,
                           StepReport& report) {
  most_candidates = std::max(most_candidates, candidates.size());
  most_near = std::max(most_near, near.size());
  const detail::PairQuery query{{.mode = options.mode}, options.method};
  if (options.scope == StepScope::first_contact) {
    ask_until_first(narrow_phase, others, query, limits, contacts, report);
  } else {
    ask(narrow_phase, others, query, limits, contacts, report);
  }
  if (options.clearance > 0) {
    keep_apart(narrow_phase);
    measure(others, options.clearance, limits, gaps, report);
  }
  const std::size_t needed =
      kBytesOfAQuestion * candidates.size() + kBytesOfAFind * contacts.size();
  if (detail::is_far_above(narrow_phase.memory(), needed)) {
    narrow_phase = {};
  }
}

/// What earlier steps needed and this one did not.
void Scene::State::give_back() {
  const std::size_t bodies = std::max(movers.places().size(), parts.places().size());
  detail::give_back(boxes, bodies);
  detail::give_back(met, bodies);
  detail::give_back(candidates, most_candidates);
  detail::give_back(near, most_near);
  detail::give_back(questions, std::max(most_candidates, most_near));
  first_contacts.give_back();
  near_phase.give_back(most_near);
}

StepReport Scene::State::step(const StepOptions& options, const Limits& limits) {
  check_options(options);  // also where nothing meets
  StepReport report;
  report.scope = options.scope;
  report.mover_mover = options.mover_mover;
  report.shapes_set = shapes_set;
  report.clearance = options.clearance;
  const bool until_first = options.scope == StepScope::first_contact;
  report.coverage =
      options.mode == OverlapMode::all && !until_first ? Coverage::complete : Coverage::first;
  check(limits);
  most_candidates = 0;
  most_near = 0;
  first_contacts.start(until_first ? movers.places().size() : 0);
  refresh_parts();
  find_environment_candidates(options.clearance, report);
  compare(environment, parts, options, limits, report.environment, report.environment_gaps, report);
  if (options.mover_mover) {
    check(limits);
    if (!options.coherent) {
      broad_phase.forget();
    }
    find_mover_candidates(options.clearance, report);
    compare(mutual, movers, options, limits, report.movers, report.mover_gaps, report);
  }
  give_back();
  return report;
}

StepReport Scene::step(const StepOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  return state_->step(options, limits);
}

}  // namespace soms
