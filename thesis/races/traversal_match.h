/// \file
/// All traversals against each other on one trip: answers that must be the same, counts, times.
#pragma once

#include "soms/query/overlap.h"

#include "thesis/run/experiment.h"
#include "thesis/trips/frames.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soms::reproduce {

/// Trips whose leaves hold more pairs of triangles than this (spatial median that stops early) have
/// their triangles tested in a whole run only, and timed once.
inline constexpr std::uint64_t kManyTrianglePairs = 20'000'000;

/// A test, whatever the trees.
struct TraversalTest {
  const Model* object = nullptr;    ///< what moves
  const Model* scene = nullptr;     ///< of a drive; without it the object comes at its like
  Approach from = Approach::right;  ///< from this side
};

/// Time of a trip, or of every so many frames of it.
struct TripTime {
  Timing timing = {};  ///< milliseconds of the frames that are timed
  std::size_t frames = 0;

  /// Of the median. \pre frames are timed.
  [[nodiscard]] double microseconds_a_frame() const {
    return 1000 * timing.median / static_cast<double>(frames);
  }
};

/// What is true about a test, found without any canonical tree: by the library's own query and, in
/// some frames, by brute force.
struct TraversalTruth {
  Trip trip = {};                                        ///< with the library's own trees
  std::vector<std::vector<TrianglePair>> contacts = {};  ///< by frame
  Cost cost = {};                                        ///< of the library's own query
  TripTime time = {};                                    ///< of the trip by it
  std::vector<std::size_t> checked = {};                 ///< frames checked by brute force
  std::vector<std::vector<TrianglePair>> by_force = {};
};

/// What a traversal did on a trip.
struct TraversalOutcome {
  NamedTraversal traversal = {};
  Totals sum = {};
  TripTime time = {};  ///< of the traversals alone
};

/// All traversals on a trip.
struct TraversalMatch {
  Trip trip = {};
  std::string title = {};  ///< of the build
  std::vector<TraversalOutcome> outcomes = {};
  /// With triangles; nothing in a quick run where there are very many.
  std::optional<Totals> answers = std::nullopt;
  /// Beside a traversal: moving the boxes, testing the triangles. The same for all.
  std::optional<TripTime> other_time = std::nullopt;

  /// What the traversal with this name did. \pre It is one of those compared.
  [[nodiscard]] const TraversalOutcome& outcome(std::string_view traversal) const;
};

/// The traversals that are compared: all of them; in a quick run those in the order of the tree.
[[nodiscard]] std::vector<NamedTraversal> compared_traversals(const Context& context);

/// The truth about a test.
/// \errors std::logic_error where the library's own query and brute force disagree; cancelled.
[[nodiscard]] TraversalTruth truth_of(const Context& context, const TraversalTest& test);

/// The trees that traversals are compared on.
struct TreesOfMatch {
  const Contender* of_scene = nullptr;
  const Contender* of_object = nullptr;
};

/// All traversals on pairs of trees: pairs of leaves compared in every frame, contacts with the
/// truth. Counts come from all counting threads, then times from one.
/// \shape one TraversalMatch a pair of trees.
/// \errors std::logic_error where answers disagree; ErrorKind::cancelled.
[[nodiscard]] std::vector<TraversalMatch> matches_of(const Context& context,
                                                     const TraversalTest& test,
                                                     std::span<const TreesOfMatch> trees,
                                                     const TraversalTruth& truth);

}  // namespace soms::reproduce
