/// \file
/// One course, ridden on the trees of several builds: what each costs.
#pragma once

#include "reproduce/contenders.h"
#include "reproduce/frames.h"
#include "reproduce/traversal_match.h"

#include <cstdint>
#include <span>
#include <string>
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

/// A course on the trees of one build.
struct Ride {
  BuildPairing build = {};
  std::string traversal = {};
  Trip trip = {};
  std::vector<Frame> frames = {};  ///< pairs of leaves only
  Totals sum = {};
  /// Milliseconds of collision detection by round, over the frames in which the roots overlap.
  /// Empty where the leaves hold more than kManyTrianglePairs.
  std::vector<double> rounds = {};

  /// Box tests and pairs of triangles together.
  [[nodiscard]] std::uint64_t tests() const {
    return sum.counts.box_tests + sum.counts.triangle_pairs;
  }
};

/// The three sides that the thesis has figures for, then a drive through each scene.
[[nodiscard]] std::vector<TraversalTest> thesis_courses(const Context& context);

/// "bunny right", "u_mixed drive".
[[nodiscard]] std::string subject_of(const Trip& trip);

/// The course on all builds by a traversal, times taken in turn. \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<Ride> ride(const Context& context, const TraversalTest& test,
                                     std::span<const BuildPairing> builds,
                                     const NamedTraversal& traversal);

}  // namespace soms::reproduce
