#include "reproduce/rides.h"

#include "reproduce/touching_drive.h"
#include "reproduce/traversal_match.h"
#include "reproduce/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace soms::reproduce {

namespace {

/// A ride that is timed, and the frames of each of its trips.
struct TimedTrip {
  Ride* ride = nullptr;
  std::vector<std::vector<Frame>> frames = {};
};

Ride count_ride(const Context& context, const RideCourse& course, const BuildPairing& build,
                const NamedTraversal& traversal, std::vector<std::vector<Frame>>& frames) {
  Ride ride{.model = course.model,
            .subject = course.subject,
            .build = build,
            .traversal = traversal.name};
  for (const auto& trip : course.trips) {
    ride.trips.push_back(trip(build));
    frames.push_back(traverse_frames(ride.trips.back(), traversal, context.parallel));
    for (const Frame& frame : frames.back()) {
      ride.sum.add(frame);
    }
  }
  return ride;
}

RideCourse four_sides(const Model& object) {
  RideCourse sides{object.name, fmt::format("{}, four sides", object.name), {}};
  for (const auto& [from, name] : kApproaches) {
    sides.trips.emplace_back([&object, side = from](const BuildPairing& build) {
      return orientation_trip(object, side, build.of_object);
    });
  }
  return sides;
}

}  // namespace

BuildPairing pairing(std::span<const Contender> of_scene, std::span<const Contender> of_object,
                     std::string_view name) {
  const Contender& scene = build_named(of_scene, name);
  return {scene.title, scene, build_named(of_object, name)};
}

std::vector<RideCourse> thesis_courses(const Context& context) {
  std::vector<RideCourse> courses;
  for (const Model& object : context.models.objects) {
    courses.push_back(four_sides(object));
    for (const Model& scene : context.models.scenes) {
      const auto drive = [&](const BuildPairing& build) {
        return drive_trip(scene, object, build.of_scene, build.of_object);
      };
      courses.push_back(
          {object.name, fmt::format("{}, {} drive", object.name, scene.name), {drive}});
      const TouchingDrive found = touching_drive(context, scene, object);
      if (found.contact_frames > 0) {
        const auto touching = [&, found](const BuildPairing& build) {
          return touching_drive_trip(scene, object, build.of_scene, build.of_object, found);
        };
        courses.push_back({object.name,
                           fmt::format("{}, {} touching drive", object.name, scene.name),
                           {touching}});
      }
    }
  }
  return courses;
}

std::vector<Ride> ride(const Context& context, const RideCourse& course,
                       std::span<const BuildPairing> builds, const NamedTraversal& traversal) {
  std::vector<Ride> rides;
  rides.reserve(builds.size());
  std::vector<TimedTrip> timed;
  std::vector<TripRun> runs;
  for (const BuildPairing& build : builds) {
    std::vector<std::vector<Frame>> frames;
    rides.push_back(count_ride(context, course, build, traversal, frames));
    Ride& one = rides.back();
    if (one.sum.counts.triangle_pairs <= kManyTrianglePairs && one.sum.root_overlap_frames > 0) {
      for (const Trip& trip : one.trips) {
        runs.push_back({&trip, traversal, context.timed_step(trip.is_drive())});
      }
      timed.push_back({&one, std::move(frames)});
    }
  }
  const std::vector<FrameTimes> times = time_trips(runs, context.rounds(), context.parallel);
  std::size_t next = 0;
  for (const TimedTrip& one : timed) {
    for (const std::vector<Frame>& frames : one.frames) {
      const std::vector<double> sums = sums_by_round(times[next++].collision, frames);
      one.ride->rounds.resize(std::max(one.ride->rounds.size(), sums.size()));
      for (std::size_t i = 0; i < sums.size(); ++i) {
        one.ride->rounds[i] += sums[i];
      }
    }
  }
  return rides;
}

}  // namespace soms::reproduce
