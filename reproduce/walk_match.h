/// \file
/// All walks against each other on one trip: answers that must be the same, counts, times.
#pragma once

#include "soms/query/overlap.h"

#include "reproduce/experiment.h"
#include "reproduce/frames.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::reproduce {

/// Trips whose leaves hold more pairs of triangles than this (spatial median that stops early) have
/// their triangles tested in a whole run only, and timed once.
inline constexpr std::uint64_t kManyTrianglePairs = 20'000'000;

/// A test, whatever the trees.
struct WalkTest {
  const Model* scene = nullptr;     ///< of a drive; without it the object comes at its like
  Approach from = Approach::right;  ///< from this side
};

/// What is true about a test, found without any canonical tree: by the library's own query and, in
/// some frames, by brute force.
struct WalkTruth {
  Trip trip = {};                                        ///< with the library's own trees
  std::vector<std::vector<TrianglePair>> contacts = {};  ///< by frame
  Cost cost = {};                                        ///< of the library's own query
  Timing time = {};                                      ///< of the trip by it
  std::vector<std::size_t> checked = {};  ///< frames that brute force was asked about
  std::vector<std::vector<TrianglePair>> by_force = {};
};

/// What a walk did on a trip.
struct WalkOutcome {
  Walk walk = {};
  Totals sum = {};
  Timing time = {};  ///< of the walks alone, milliseconds a trip
};

/// All walks on a trip.
struct WalkMatch {
  Trip trip = {};
  std::string title = {};  ///< of the build
  std::vector<WalkOutcome> outcomes = {};
  /// With triangles; nothing in a quick run where there are very many.
  std::optional<Totals> answers = std::nullopt;
  /// Milliseconds a trip beside a walk: moving the boxes, testing the triangles. The same for all.
  std::optional<double> other_time = std::nullopt;

  /// What the walk with this name did. \pre It is one of those compared.
  [[nodiscard]] const WalkOutcome& outcome(std::string_view walk) const;
};

/// The walks that are compared: all of them; in a quick run those in the order of the tree.
[[nodiscard]] std::vector<Walk> compared_walks(const Context& context);

/// The truth about a test.
/// \errors std::logic_error where the library's own query and brute force disagree; cancelled.
[[nodiscard]] WalkTruth truth_of(const Context& context, const WalkTest& test);

/// All walks on the trees of two builds: pairs of leaves compared in every frame, contacts with the
/// truth.
/// \errors std::logic_error where answers disagree; ErrorKind::cancelled.
[[nodiscard]] WalkMatch match_of(const Context& context, const WalkTest& test,
                                 const Contender& build_of_scene, const Contender& build_of_object,
                                 const WalkTruth& truth);

}  // namespace soms::reproduce
