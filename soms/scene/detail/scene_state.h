/// \file
/// What a scene holds: its bodies, and the memory of its steps.
#pragma once

#include "soms/query/distance.h"
#include "soms/scene/broad_phase.h"
#include "soms/scene/detail/first_contacts.h"
#include "soms/scene/detail/narrow_phase.h"
#include "soms/scene/detail/pair_answers.h"
#include "soms/scene/detail/residents.h"
#include "soms/scene/detail/search/body_search.h"
#include "soms/scene/detail/swept_phase.h"
#include "soms/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms {

/// Where a step puts what it finds of movers and other bodies.
template <typename Contact, typename Gap, typename Passage>
struct FoundLists {
  std::vector<Contact>& contacts;
  std::vector<Gap>& gaps;
  std::vector<Passage>& passages;
};

template <typename Contact, typename Gap, typename Passage>
FoundLists(std::vector<Contact>&, std::vector<Gap>&, std::vector<Passage>&)
    -> FoundLists<Contact, Gap, Passage>;

struct Scene::State {
  detail::Residents movers{"mover"};
  detail::Residents parts{"part of the environment"};
  bool parts_changed = false;
  bool movers_changed = false;  ///< since `mover_set` was built
  bool filter_changed = false;
  bool has_filter = false;
  std::uint64_t shapes_set = 0;
  std::uint64_t steps = 0;  ///< that are done
  detail::BodySet part_set;
  detail::BodySet mover_set;  ///< for queries of points and rays alone
  BroadPhase broad_phase;

  // Memory of a step, kept for the next.
  std::vector<Box> boxes;
  std::vector<std::uint32_t> met;
  std::vector<detail::Candidate> candidates;  ///< pairs of bodies whose boxes meet
  std::vector<detail::Candidate> near;        ///< within the clearance: `candidates` and more
  std::vector<detail::Candidate> passing;     ///< whose boxes over the way meet, one of them moves
  std::vector<detail::BodyPair> questions;
  std::size_t most_candidates = 0;  ///< of this step
  std::size_t most_near = 0;        ///< of this step
  std::size_t most_passing = 0;     ///< of this step
  detail::FirstContacts first_contacts;
  detail::NarrowPhase environment;
  detail::NarrowPhase mutual;
  detail::PairAnswers<Distance, detail::kFewQuestions> distances;
  detail::SweptPhase swept_phase;

  [[nodiscard]] StepReport step(const StepOptions& options, const Limits& limits);

  /// Builds the set of the bodies that were changed since it was built.
  void refresh_parts();
  void refresh_movers();

 private:
  void refresh_filter();
  void find_environment_candidates(const StepOptions& options, StepReport& report);
  void find_mover_candidates(const StepOptions& options, StepReport& report);
  void add_candidate(const detail::Candidate& pair, bool meets, bool is_near, bool passes);
  template <typename Lists>
  void compare(detail::NarrowPhase& narrow_phase, const detail::Residents& others,
               const StepOptions& options, const Limits& limits, const Lists& lists,
               StepReport& report);
  template <typename Contact>
  void ask(detail::NarrowPhase& narrow_phase, const detail::Residents& others,
           const detail::PairQuery& query, const Limits& limits, std::vector<Contact>& contacts,
           StepReport& report);
  template <typename Contact>
  void ask_until_first(detail::NarrowPhase& narrow_phase, const detail::Residents& others,
                       const detail::PairQuery& query, const Limits& limits,
                       std::vector<Contact>& contacts, StepReport& report);
  template <typename Contact>
  void append(const detail::Candidate& candidate, const detail::Residents& others,
              std::span<const TrianglePair> pairs, std::vector<Contact>& contacts) const;
  void keep_apart(const detail::NarrowPhase& narrow_phase);
  template <typename Gap>
  void measure(const detail::Residents& others, double clearance, const Limits& limits,
               std::vector<Gap>& gaps, StepReport& report);
  template <typename Passage>
  void pass(const detail::NarrowPhase& narrow_phase, const detail::Residents& others,
            const Limits& limits, std::vector<Passage>& passages, StepReport& report);

  [[nodiscard]] detail::BodyPair question(const detail::Candidate& candidate,
                                          const detail::Residents& others) const {
    return {&movers.places()[candidate.mover].value.body,
            &others.places()[candidate.other].value.body};
  }

  void give_back();
};

}  // namespace soms
