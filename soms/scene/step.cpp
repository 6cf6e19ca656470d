// A step of a scene: from boxes to pairs of bodies, from these to contacts, gaps and passages.
#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/motion/detail/widened.h"
#include "soms/query/detail/check_options.h"
#include "soms/scene/detail/kept_memory.h"
#include "soms/scene/detail/scene_state.h"

#include <algorithm>
#include <cmath>
#include <span>
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
  const bool measures = options.clearance > 0;
  if ((measures || options.swept) && options.scope == StepScope::first_contact) {
    throw Error(ErrorKind::usage,
                std::string("step options: ") + (measures ? "a clearance" : "swept") +
                    " goes with StepScope::every_pair alone, as first_contact leaves pairs of "
                    "bodies out",
                std::string("set the scope to every_pair, or ") +
                    (measures ? "the clearance to 0" : "swept to false"));
  }
}

/// Only the boxes of bodies where they are matter.
bool is_plain(const StepOptions& options) {
  return !(options.clearance > 0) && !options.swept;
}

/// Which pairs the narrow phase found to touch; pairs are looked up in their order.
class TouchingPairs {
 public:
  /// `candidates`, sorted, are the questions of `narrow_phase`.
  TouchingPairs(std::span<const Candidate> candidates, const detail::NarrowPhase& narrow_phase)
      : candidates_(candidates), narrow_phase_(narrow_phase) {}

  /// \pre No pair is before one that was looked up.
  [[nodiscard]] bool hold(const Candidate& pair) {
    while (next_ < candidates_.size() && candidates_[next_] < pair) {
      ++next_;
    }
    return next_ < candidates_.size() && candidates_[next_] == pair &&
           !narrow_phase_.pairs_of(next_).empty();
  }

 private:
  std::span<const Candidate> candidates_;
  const detail::NarrowPhase& narrow_phase_;
  std::size_t next_ = 0;
};

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

/// Candidates ascend by mover, then part, and so do those that may be near or are passed.
void Scene::State::find_environment_candidates(const StepOptions& options, StepReport& report) {
  candidates.clear();
  near.clear();
  passing.clear();
  const double clearance = options.clearance;
  const bool plain = is_plain(options);
  const auto& places = movers.places();
  for (std::uint32_t mover = 0; mover < places.size(); ++mover) {
    const Resident& resident = places[mover].value;
    if (resident.box.empty()) {
      continue;
    }
    const Box near_box = clearance > 0 ? detail::widened(resident.box, clearance) : resident.box;
    Box box = near_box;
    box.grow(swept_phase.box(movers, mover));
    met.clear();
    part_set.boxes().query(box, [&](std::uint32_t part) { met.push_back(part); });
    std::sort(met.begin(), met.end());
    for (const std::uint32_t part : met) {
      const auto& place = parts.places()[part];
      const bool meets = plain || overlaps(resident.box, place.value.box);
      report.box_pairs += meets ? 1 : 0;
      if (!detail::holds(resident.ignored_others, place.id)) {
        add_candidate(
            {mover, part}, meets, clearance > 0 && overlaps(near_box, place.value.box),
            swept_phase.moves(mover) && overlaps(swept_phase.box(movers, mover), place.value.box));
      }
    }
  }
}

void Scene::State::add_candidate(const Candidate& pair, bool meets, bool is_near, bool passes) {
  if (meets) {
    candidates.push_back(pair);
  }
  if (is_near) {
    near.push_back(pair);
  }
  if (passes) {
    passing.push_back(pair);
  }
}

/// With a clearance, each of two boxes takes half of it.
void Scene::State::find_mover_candidates(const StepOptions& options, StepReport& report) {
  candidates.clear();
  near.clear();
  passing.clear();
  detail::collect_boxes(movers, boxes);
  const double clearance = options.clearance;
  const bool plain = is_plain(options);
  const auto near_box = [&](std::uint32_t place) {
    return detail::widened(movers.places()[place].value.box, clearance / 2);
  };
  for (std::uint32_t place = 0; !plain && place < boxes.size(); ++place) {
    if (clearance > 0) {
      boxes[place] = near_box(place);
    }
    boxes[place].grow(swept_phase.box(movers, place));
  }
  refresh_filter();
  for (const auto& [a, b] : broad_phase.find(boxes)) {
    if (plain) {
      candidates.push_back({a, b});
      continue;
    }
    const bool meets = overlaps(movers.places()[a].value.box, movers.places()[b].value.box);
    add_candidate({a, b}, meets, clearance > 0 && overlaps(near_box(a), near_box(b)),
                  (swept_phase.moves(a) || swept_phase.moves(b)) &&
                      overlaps(swept_phase.box(movers, a), swept_phase.box(movers, b)));
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

/// Leaves in `near` the pairs for which `narrow_phase` found no touch.
void Scene::State::keep_apart(const detail::NarrowPhase& narrow_phase) {
  TouchingPairs touching(candidates, narrow_phase);
  std::erase_if(near, [&](const Candidate& pair) { return touching.hold(pair); });
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
  report.cost += distances.ask(questions.size(), limits, [&](std::size_t k, const Limits& inside) {
    return distance(*questions[k].mover, *questions[k].other, {.at_most = clearance}, inside);
  });
  for (std::size_t k = 0; k < near.size(); ++k) {
    const Distance& answer = distances.get()[k];
    if (!answer.farther && answer.triangles) {
      gaps.push_back({movers.places()[near[k].mover].id, others.places()[near[k].other].id,
                      answer.triangles->a, answer.triangles->b, answer.distance, answer.point_a,
                      answer.point_b});
    }
  }
}

/// The passages of the pairs in `passing`. One that touched at the begin is left out where
/// `narrow_phase` found a touch: the two have not parted.
template <typename Passage>
void Scene::State::pass(const detail::NarrowPhase& narrow_phase, const Residents& others,
                        const Limits& limits, std::vector<Passage>& passages, StepReport& report) {
  report.passage_queries += passing.size();
  report.cost += swept_phase.ask(passing, movers, others, limits);
  TouchingPairs touching(candidates, narrow_phase);
  for (std::size_t k = 0; k < passing.size(); ++k) {
    const FirstContact& answer = swept_phase.answers()[k];
    if (answer.verdict == ContactVerdict::free ||
        (answer.verdict == ContactVerdict::started && touching.hold(passing[k]))) {
      continue;
    }
    const TrianglePair pair = answer.triangles.value_or(TrianglePair());
    passages.push_back({movers.places()[passing[k].mover].id, others.places()[passing[k].other].id,
                        pair.a, pair.b, answer.verdict, answer.t, answer.point});
  }
}

/// Compares the pairs of bodies that were found.
template <typename Lists>
void Scene::State::compare(detail::NarrowPhase& narrow_phase, const Residents& others,
                           const StepOptions& options, const Limits& limits, const Lists& lists,
                           StepReport& report) {
  most_candidates = std::max(most_candidates, candidates.size());
  most_near = std::max(most_near, near.size());
  most_passing = std::max(most_passing, passing.size());
  const detail::PairQuery query{{.mode = options.mode}, options.method};
  if (options.scope == StepScope::first_contact) {
    ask_until_first(narrow_phase, others, query, limits, lists.contacts, report);
  } else {
    ask(narrow_phase, others, query, limits, lists.contacts, report);
  }
  if (options.clearance > 0) {
    keep_apart(narrow_phase);
    measure(others, options.clearance, limits, lists.gaps, report);
  }
  if (options.swept) {
    pass(narrow_phase, others, limits, lists.passages, report);
  }
  const std::size_t needed =
      kBytesOfAQuestion * candidates.size() + kBytesOfAFind * lists.contacts.size();
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
  detail::give_back(passing, most_passing);
  detail::give_back(questions, std::max(most_candidates, most_near));
  first_contacts.give_back();
  distances.give_back(most_near);
  swept_phase.give_back(movers.places().size(), most_passing);
}

StepReport Scene::State::step(const StepOptions& options, const Limits& limits) {
  check_options(options);  // also where nothing meets
  StepReport report;
  report.scope = options.scope;
  report.mover_mover = options.mover_mover;
  report.shapes_set = shapes_set;
  report.clearance = options.clearance;
  report.swept = options.swept;
  const bool until_first = options.scope == StepScope::first_contact;
  report.coverage =
      options.mode == OverlapMode::all && !until_first ? Coverage::complete : Coverage::first;
  check(limits);
  most_candidates = 0;
  most_near = 0;
  most_passing = 0;
  first_contacts.start(until_first ? movers.places().size() : 0);
  refresh_parts();
  if (options.swept) {
    swept_phase.start(movers, steps);
  } else {
    swept_phase.skip();
  }
  find_environment_candidates(options, report);
  compare(environment, parts, options, limits,
          FoundLists{report.environment, report.environment_gaps, report.environment_passages},
          report);
  if (limits.progress) {
    limits.progress(options.mover_mover ? 0.5 : 1.0);
  }
  if (options.mover_mover) {
    check(limits);
    if (!options.coherent) {
      broad_phase.forget();
    }
    find_mover_candidates(options, report);
    compare(mutual, movers, options, limits,
            FoundLists{report.movers, report.mover_gaps, report.mover_passages}, report);
    if (limits.progress) {
      limits.progress(1.0);
    }
  }
  give_back();
  ++steps;
  return report;
}

StepReport Scene::step(const StepOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  return state_->step(options, limits);
}

}  // namespace soms
