/// \file
/// Courses of a body past another, on the trees of several builds: what each costs.
#pragma once

#include "thesis/run/experiment.h"
#include "thesis/trips/contenders.h"
#include "thesis/trips/frames.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// A build of the still body's tree and of the moving body's.
struct BuildPairing {
  std::string title;  ///< "SOMS"
  Contender of_scene = {};
  Contender of_object = {};
};

/// Builds with this name in both lists, paired. \pre both lists have it.
[[nodiscard]] BuildPairing pairing(std::span<const Contender> of_scene,
                                   std::span<const Contender> of_object, std::string_view name);

/// Trips that are one subject of a claim, whatever the trees.
struct RideCourse {
  std::string model;    ///< name of the object that moves
  std::string subject;  ///< "bunny, four sides", "bunny, u_mixed drive"
  std::vector<std::function<Trip(const BuildPairing&)>> trips = {};
};

/// For each object the four sides that the thesis names as one course, since opposite sides cost
/// the same; then for each scene the drive and, where something can be touched, the drive that
/// touches. `context` must outlive the courses. \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<RideCourse> thesis_courses(const Context& context);

/// A course on the trees of one build, by one traversal.
struct Ride {
  std::string model = {};
  std::string subject = {};
  BuildPairing build = {};
  std::string traversal = {};
  std::vector<Trip> trips = {};
  Totals sum = {};  ///< pairs of leaves only
  /// Milliseconds of collision detection by round, over the frames in which the roots overlap.
  /// Empty where the leaves hold more than kManyTrianglePairs.
  std::vector<double> rounds = {};
  int processes = 1;  ///< that the rounds come from

  /// Box tests and pairs of triangles together.
  [[nodiscard]] std::uint64_t tests() const {
    return sum.counts.box_tests + sum.counts.triangle_pairs;
  }
};

/// The course on all builds by a traversal, times taken in turn. \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<Ride> ride(const Context& context, const RideCourse& course,
                                     std::span<const BuildPairing> builds,
                                     const NamedTraversal& traversal);

}  // namespace soms::reproduce
