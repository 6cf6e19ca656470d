#include "thesis/races/traversal_match.h"

#include "soms/base/parallel.h"
#include "soms/query/reference/overlap.h"
#include "soms/thesis/named_overlap.h"

#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace soms::reproduce {

namespace {

Trip trip_of(const TraversalTest& test, const Contender& of_scene, const Contender& of_object) {
  return test.scene == nullptr ? orientation_trip(*test.object, test.from, of_object)
                               : drive_trip(*test.scene, *test.object, of_scene, of_object);
}

std::string place(const Trip& trip, std::size_t frame) {
  return fmt::format("{} of {} past {}, {} trees, frame {}", trip.test, trip.moving, trip.still,
                     trip.rule, frame);
}

/// Progress is the experiment's, not a query's; a query only heeds the stop.
Limits quiet(const Context& context) {
  return context.limits.without_deadline().alone();
}

Overlap fast_answer(const Trip& trip, std::size_t frame, const Limits& limits) {
  return overlap(Body(trip.a), Body(trip.b, trip.pose(frame)), {}, limits);
}

/// Frames that brute force is queried about: with root overlap, spread over the trip.
std::vector<std::size_t> frames_to_check(const Trip& trip) {
  return trip.test == "drive" ? std::vector<std::size_t>{50, 110, 170}
                              : std::vector<std::size_t>{36, 48};
}

bool has_many_pairs(const TraversalMatch& match) {
  return match.outcomes[0].sum.counts.triangle_pairs > kManyTrianglePairs;
}

/// Pairs of leaves of every traversal in every frame.
void traverse_all(const Context& context, TraversalMatch& match) {
  LeafPairs expected;
  for (const NamedTraversal& traversal : compared_traversals(context)) {
    LeafPairs found;
    const std::vector<Frame> frames =
        traverse_frames(match.trip, traversal, quiet(context), &found);
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

/// Contacts of every frame by one traversal: those of every traversal, since the pairs of leaves
/// are.
void answer_all(const Context& context, const TraversalTruth& truth, TraversalMatch& match) {
  if (has_many_pairs(match) && context.quick) {
    return;
  }
  const NamedTraversal larger = named_traversal("larger");
  const std::vector<Frame> frames = answer_frames(match.trip, larger, quiet(context));
  for (std::size_t k = 0; k < frames.size(); ++k) {
    require(frames[k].contacts == truth.contacts[k],
            fmt::format("{}: contacts by {} and by fast", place(match.trip, k), larger.name));
  }
  match.answers = totals(frames);
}

/// Every so many frames of a trip are timed: all of the first object in a whole run.
std::size_t step_of(const Context& context, const Trip& trip) {
  constexpr std::size_t kStep = 8;
  return context.quick || trip.model != context.models.objects.front().name ? kStep : 1;
}

TripTime trip_time(const Trip& trip, std::size_t step, Timing timing) {
  return {std::move(timing), (trip.offsets.size() + step - 1) / step};
}

void time_all(const Context& context, TraversalMatch& match) {
  const std::size_t step = step_of(context, match.trip);
  const Limits limits = quiet(context);
  const int repetitions = context.repetitions(10);
  std::vector<Timing> times =
      time_traversals(match.trip, compared_traversals(context), repetitions, limits, step);
  for (std::size_t i = 0; i < times.size(); ++i) {
    match.outcomes[i].time = trip_time(match.trip, step, std::move(times[i]));
  }
  if (match.answers) {
    Timing beside = time_beside_traversal(match.trip, named_traversal("larger"),
                                          has_many_pairs(match) ? 1 : repetitions, limits, step);
    beside.median = std::max(0.0, beside.median);  // a difference of two times
    match.other_time = trip_time(match.trip, step, std::move(beside));
  }
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
  const Limits limits = quiet(context);
  TraversalTruth truth;
  truth.trip = trip_of(test, own, own);
  const Trip& trip = truth.trip;
  for (std::size_t k = 0; k < trip.offsets.size(); ++k) {
    Overlap answer = fast_answer(trip, k, limits);
    truth.cost += answer.cost;
    truth.contacts.push_back(std::move(answer.pairs));
  }
  truth.checked = frames_to_check(trip);
  for (const std::size_t k : truth.checked) {
    truth.by_force.push_back(
        reference::overlap(trip.a.mesh(), Pose::identity(), trip.b.mesh(), trip.pose(k), limits)
            .pairs);
    require(truth.contacts[k] == truth.by_force.back(),
            fmt::format("{}: contacts by fast and by brute force", place(trip, k)));
  }
  const std::size_t step = step_of(context, trip);
  const auto timed_frames = [&] {
    for (std::size_t k = 0; k < trip.offsets.size(); k += step) {
      (void)fast_answer(trip, k, limits);
    }
  };
  truth.time =
      trip_time(trip, step, time_repeatedly(context.repetitions(20), limits, timed_frames, 1));
  return truth;
}

std::vector<TraversalMatch> matches_of(const Context& context, const TraversalTest& test,
                                       std::span<const TreesOfMatch> trees,
                                       const TraversalTruth& truth) {
  std::vector<TraversalMatch> matches(trees.size());
  for (std::size_t i = 0; i < trees.size(); ++i) {
    matches[i].trip = trip_of(test, *trees[i].of_scene, *trees[i].of_object);
    matches[i].title = trees[i].of_object->title;
  }
  for_each_chunk(matches.size(), 1, context.counting(), [&](std::size_t i, std::size_t) {
    traverse_all(context, matches[i]);
    check_by_force(context, truth, matches[i]);
    answer_all(context, truth, matches[i]);
  });
  for (TraversalMatch& match : matches) {
    time_all(context, match);
  }
  return matches;
}

}  // namespace soms::reproduce
