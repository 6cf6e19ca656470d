#include "thesis/races/rides.h"

#include "soms/base/parallel.h"

#include "thesis/races/touching_drive.h"
#include "thesis/races/traversal_match.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace soms::reproduce {

namespace {

/// A ride that is timed, and the frames of each of its trips.
struct TimedRide {
  Ride* ride = nullptr;
  std::vector<std::vector<Frame>> frames = {};
};

Ride ride_of(const RideCourse& course, const BuildPairing& build, const NamedTraversal& traversal) {
  Ride ride{.model = course.model,
            .subject = course.subject,
            .build = build,
            .traversal = traversal.name};
  for (const auto& trip : course.trips) {
    ride.trips.push_back(trip(build));
  }
  return ride;
}

/// Counts rides and answers of each whether it is timed, then of each of its frames whether the
/// roots overlap.
std::vector<Decision> count(std::vector<Ride>& rides, const NamedTraversal& traversal,
                            const Context& context) {
  std::vector<Decision> decisions(rides.size());
  const Limits quiet = context.limits.alone();
  for_each_chunk(rides.size(), 1, context.counting(), [&](std::size_t i, std::size_t) {
    Ride& ride = rides[i];
    Decision& decision = decisions[i];
    decision = {0};
    bool times_show = false;  // a frame is timed in which the roots overlap
    for (const Trip& trip : ride.trips) {
      const std::vector<Frame> frames = traverse_frames(trip, traversal, quiet);
      for (std::size_t k = 0; k < frames.size(); ++k) {
        ride.sum.add(frames[k]);
        decision.push_back(frames[k].roots_overlap ? 1 : 0);
        times_show |= frames[k].roots_overlap && k % context.timed_step(trip.is_drive()) == 0;
      }
    }
    decision.front() = ride.sum.counts.triangle_pairs <= kManyTrianglePairs && times_show ? 1 : 0;
  });
  return decisions;
}

/// The frames that a decision tells of, trip by trip.
std::vector<std::vector<Frame>> frames_of(const Ride& ride, const Decision& decision) {
  std::vector<std::vector<Frame>> frames;
  std::size_t next = 1;
  for (const Trip& trip : ride.trips) {
    std::vector<Frame>& of_trip = frames.emplace_back(trip.offsets.size());
    for (Frame& frame : of_trip) {
      frame.roots_overlap = decision.at(next++) != 0;
    }
  }
  return frames;
}

/// Milliseconds of each ride by round.
RoundsByWork time_rides(std::span<const TimedRide> rides, const NamedTraversal& traversal,
                        int rounds, const Context& context) {
  std::vector<TripRun> runs;
  for (const TimedRide& one : rides) {
    for (const Trip& trip : one.ride->trips) {
      runs.push_back({&trip, traversal, context.timed_step(trip.is_drive())});
    }
  }
  const std::vector<FrameTimes> times = time_trips(runs, rounds, context.limits);
  RoundsByWork all;
  std::size_t next = 0;
  for (const TimedRide& one : rides) {
    std::vector<double>& of_ride = all.emplace_back(static_cast<std::size_t>(rounds));
    for (const std::vector<Frame>& frames : one.frames) {
      const std::vector<double> sums = sums_by_round(times[next++].collision, frames);
      std::transform(sums.begin(), sums.end(), of_ride.begin(), of_ride.begin(), std::plus<>());
    }
  }
  return all;
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
  RaceProcess& process = *context.races;
  std::vector<Ride> rides;
  rides.reserve(builds.size());
  std::vector<TimedRide> timed;
  for (const BuildPairing& build : builds) {
    rides.push_back(ride_of(course, build, traversal));
  }
  std::vector<Decision> counted;
  if (!process.times_only()) {
    counted = count(rides, traversal, context);
  }
  for (std::size_t i = 0; i < rides.size(); ++i) {
    Ride& one = rides[i];
    const Decision decision = process.decide(
        fmt::format("frames of {}, {}, {}", one.subject, one.build.title, one.traversal),
        [&] { return counted.at(i); });
    if (decision.at(0) != 0) {
      timed.push_back({&one, frames_of(one, decision)});
    }
  }
  if (timed.empty()) {
    return rides;
  }
  RoundsByWork rounds = process.gather(
      fmt::format("{}, {}, {} builds", course.subject, traversal.name, timed.size()), [&] {
        return time_rides(timed, traversal, rounds_of_each(process, context.rounds()), context);
      });
  for (std::size_t i = 0; i < timed.size(); ++i) {
    timed[i].ride->rounds = std::move(rounds[i]);
    timed[i].ride->processes = process.gathered_processes();
  }
  return rides;
}

}  // namespace soms::reproduce
