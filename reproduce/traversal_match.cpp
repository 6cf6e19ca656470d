#include "reproduce/traversal_match.h"

#include "soms/query/reference/overlap.h"
#include "soms/thesis/named_overlap.h"

#include "reproduce/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace soms::reproduce {

namespace {

Trip trip_of(const Context& context, const TraversalTest& test, const Contender& of_scene,
             const Contender& of_object) {
  const Model& object = context.models.objects.front();
  return test.scene == nullptr ? orientation_trip(object, test.from, of_object)
                               : drive_trip(*test.scene, object, of_scene, of_object);
}

std::string place(const Trip& trip, std::size_t frame) {
  return fmt::format("{} of {} past {}, {} trees, frame {}", trip.test, trip.moving, trip.still,
                     trip.rule, frame);
}

/// Progress is the experiment's, not a query's; a query only heeds the stop.
Parallel quiet(const Context& context) {
  Parallel one_thread;
  one_thread.stop = context.parallel.stop;
  return one_thread;
}

Overlap fast_answer(const Trip& trip, std::size_t frame, const Parallel& parallel) {
  return overlap(Body(trip.a), Body(trip.b, trip.pose(frame)), {}, parallel);
}

/// Frames that brute force is queried about: with root overlap, spread over the trip.
std::vector<std::size_t> frames_to_check(const Trip& trip) {
  return trip.test == "drive" ? std::vector<std::size_t>{50, 110, 170}
                              : std::vector<std::size_t>{36, 48};
}

/// Pairs of leaves of every traversal in every frame.
void traverse_all(const Context& context, TraversalMatch& match) {
  LeafPairs expected;
  for (const NamedTraversal& traversal : compared_traversals(context)) {
    LeafPairs found;
    const std::vector<Frame> frames =
        traverse_frames(match.trip, traversal, context.parallel, &found);
    match.outcomes.push_back({traversal, totals(frames), {}});
    if (match.outcomes.size() == 1) {
      expected = std::move(found);
      continue;
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
      require(found[k] == expected[k],
              fmt::format("{}: pairs of leaves by {} and by {}", place(match.trip, k),
                          traversal.name, match.outcomes[0].traversal.name));
    }
  }
}

/// Contacts by every traversal in the frames checked by brute force.
void check_by_force(const Context& context, const TraversalTruth& truth,
                    const TraversalMatch& match) {
  for (const NamedTraversal& traversal : compared_traversals(context)) {
    thesis::NamedOverlap query(match.trip.a, match.trip.b, traversal.options);
    for (std::size_t i = 0; i < truth.checked.size(); ++i) {
      const std::size_t k = truth.checked[i];
      const Overlap answer = query(Pose::identity(), match.trip.pose(k), {}, quiet(context));
      require(answer.pairs == truth.by_force[i],
              fmt::format("{}: contacts by {} and by brute force", place(match.trip, k),
                          traversal.name));
    }
  }
}

void time_all(const Context& context, TraversalMatch& match) {
  const std::vector<Timing> times = time_traversals(match.trip, compared_traversals(context),
                                                    context.repetitions(10), context.parallel);
  for (std::size_t i = 0; i < times.size(); ++i) {
    match.outcomes[i].time = times[i];
  }
}

/// Contacts of every frame by one traversal: those of every traversal, since the pairs of leaves
/// are.
void answer_all(const Context& context, const TraversalTruth& truth, TraversalMatch& match) {
  const bool many = match.outcomes[0].sum.counts.triangle_pairs > kManyTrianglePairs;
  if (many && context.quick) {
    return;
  }
  const NamedTraversal larger = named_traversal("larger");
  const std::vector<Frame> frames = answer_frames(match.trip, larger, quiet(context));
  for (std::size_t k = 0; k < frames.size(); ++k) {
    require(frames[k].contacts == truth.contacts[k],
            fmt::format("{}: contacts by {} and by fast", place(match.trip, k), larger.name));
  }
  match.answers = totals(frames);
  const Timing beside =
      time_beside_traversal(match.trip, larger, many ? 1 : context.repetitions(10), quiet(context));
  match.other_time = std::max(0.0, beside.median);  // a difference of two times
}

}  // namespace

std::vector<NamedTraversal> compared_traversals(const Context& context) {
  std::vector<NamedTraversal> traversals = all_traversals();
  if (context.quick) {
    std::erase_if(traversals, [](const NamedTraversal& traversal) {
      return traversal.options.order == EntryOrder::volume;
    });
  }
  return traversals;
}

const TraversalOutcome& TraversalMatch::outcome(std::string_view traversal) const {
  return *std::find_if(outcomes.begin(), outcomes.end(), [&](const TraversalOutcome& entry) {
    return entry.traversal.name == traversal;
  });
}

TraversalTruth truth_of(const Context& context, const TraversalTest& test) {
  const std::vector<Contender> builds = all_builds(kSceneLevel);
  const Contender& own = build_named(builds, "default");
  const Parallel parallel = quiet(context);
  TraversalTruth truth;
  truth.trip = trip_of(context, test, own, own);
  const Trip& trip = truth.trip;
  for (std::size_t k = 0; k < trip.offsets.size(); ++k) {
    Overlap answer = fast_answer(trip, k, parallel);
    truth.cost += answer.cost;
    truth.contacts.push_back(std::move(answer.pairs));
  }
  truth.checked = frames_to_check(trip);
  for (const std::size_t k : truth.checked) {
    truth.by_force.push_back(
        reference::overlap(trip.a.mesh(), Pose::identity(), trip.b.mesh(), trip.pose(k), parallel)
            .pairs);
    require(truth.contacts[k] == truth.by_force.back(),
            fmt::format("{}: contacts by fast and by brute force", place(trip, k)));
  }
  const auto whole_trip = [&] {
    for (std::size_t k = 0; k < trip.offsets.size(); ++k) {
      (void)fast_answer(trip, k, parallel);
    }
  };
  truth.time = time_repeatedly(context.repetitions(20), parallel, whole_trip, 1);
  return truth;
}

TraversalMatch match_of(const Context& context, const TraversalTest& test,
                        const Contender& build_of_scene, const Contender& build_of_object,
                        const TraversalTruth& truth) {
  TraversalMatch match;
  match.trip = trip_of(context, test, build_of_scene, build_of_object);
  match.title = build_of_object.title;
  traverse_all(context, match);
  check_by_force(context, truth, match);
  time_all(context, match);
  answer_all(context, truth, match);
  return match;
}

}  // namespace soms::reproduce
