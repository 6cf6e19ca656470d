#include "reproduce/rides.h"

#include "reproduce/traversal_tables.h"

#include <fmt/format.h>

#include <utility>

namespace soms::reproduce {

BuildPairing pairing(std::span<const Contender> of_scene, std::span<const Contender> of_object,
                     std::string_view name) {
  const Contender& scene = build_named(of_scene, name);
  return {scene.title, scene, build_named(of_object, name)};
}

std::vector<TraversalTest> thesis_courses(const Context& context) {
  std::vector<TraversalTest> courses;
  for (const auto& [from, name] : kApproaches) {
    courses.push_back({nullptr, from});
  }
  for (const Model& scene : context.models.scenes) {
    courses.push_back({&scene});
  }
  return courses;
}

std::string subject_of(const Trip& trip) {
  return fmt::format("{} {}", trip.still, trip.test);
}

std::vector<Ride> ride(const Context& context, const TraversalTest& test,
                       std::span<const BuildPairing> builds, const NamedTraversal& traversal) {
  std::vector<Ride> rides;
  for (const BuildPairing& build : builds) {
    Ride one{.build = build,
             .traversal = traversal.name,
             .trip = trip_of(context, test, build.of_scene, build.of_object)};
    one.frames = traverse_frames(one.trip, traversal, context.parallel);
    one.sum = totals(one.frames);
    rides.push_back(std::move(one));
  }
  std::vector<TripRun> runs;
  std::vector<Ride*> timed;
  for (Ride& one : rides) {
    if (one.sum.counts.triangle_pairs <= kManyTrianglePairs && one.sum.root_overlap_frames > 0) {
      runs.push_back({&one.trip, traversal});
      timed.push_back(&one);
    }
  }
  const std::vector<FrameTimes> times = time_trips(runs, context.rounds(), context.parallel);
  for (std::size_t i = 0; i < timed.size(); ++i) {
    timed[i]->rounds = sums_by_round(times[i].collision, timed[i]->frames);
  }
  return rides;
}

}  // namespace soms::reproduce
