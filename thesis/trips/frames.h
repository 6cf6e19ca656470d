/// \file
/// One body moves past another, frame by frame, and named traversals ask each frame what they
/// share: counts, answers, times.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/query/overlap.h"
#include "soms/thesis/e_node_front.h"
#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/thesis_frames.h"
#include "soms/thesis/traversal_options.h"
#include "soms/tree/shape.h"

#include "thesis/trips/contenders.h"
#include "thesis/trips/levels.h"
#include "thesis/trips/models.h"
#include "thesis/trips/timing.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// A body that stands still and one that moves past it, both with their canonical trees.
struct Trip {
  std::string model;               ///< name of the object that moves
  std::string still;               ///< name of the model that stands still
  std::string moving;              ///< what moves, as in the golden tables: "bunny500"
  std::string test;                ///< "right" and the other approaches, or "drive"
  std::string rule;                ///< name of the build of both trees
  Shape a = {};                    ///< stands still
  Shape b = {};                    ///< moves
  std::vector<Vec3> offsets = {};  ///< of `b`, one a frame

  /// Through a scene; else an object comes at its like.
  [[nodiscard]] bool is_drive() const { return moving != still; }

  [[nodiscard]] Pose pose(std::size_t frame) const {
    return Pose::translation(offsets[frame].x, offsets[frame].y, offsets[frame].z);
  }
};

/// An object comes at another of its kind (y up), both trees by the same build.
[[nodiscard]] Trip orientation_trip(const Model& object, Approach from, const Contender& build);

/// An object, `driven`, drives through a scene.
[[nodiscard]] Trip drive_trip(const Model& scene, const Model& object,
                              const Contender& build_of_scene, const Contender& build_of_object);

/// A traversal by the name that tables show.
struct NamedTraversal {
  std::string name;
  TraversalOptions options = {};
};

/// All traversals of canonical trees that differ: the baselines, E-Node with its descents and
/// orders, and from the front of the frame before ("start"). Names as in the golden tables.
[[nodiscard]] std::vector<NamedTraversal> all_traversals();

/// The traversal with this name. \pre `all_traversals` has it.
[[nodiscard]] NamedTraversal named_traversal(std::string_view name);

/// What a traversal did in one frame. Triangles only if requested.
struct Frame {
  bool roots_overlap = false;
  TraversalCounts counts = {};
  std::uint64_t triangle_tests = 0;
  std::vector<TrianglePair> contacts = {};
};

/// Sums over the frames of a trip, as in the golden tables.
struct Totals {
  std::uint64_t frames = 0;
  std::uint64_t root_overlap_frames = 0;
  std::uint64_t hit_frames = 0;  ///< frames in which a pair of leaves overlaps
  TraversalCounts counts = {};
  std::uint64_t triangle_tests = 0;
  std::uint64_t contacts = 0;

  void add(const Frame& frame);
};

[[nodiscard]] Totals totals(std::span<const Frame> frames);

/// Traverses a trip, leaf boxes only, frame after frame.
class LeafTraversal {
 public:
  /// `trip` must outlive the object.
  LeafTraversal(const Trip& trip, const TraversalOptions& options);

  /// Moves the boxes to a frame.
  void move(std::size_t frame);

  /// Traverses the frame.
  TraversalCounts run(const TraversalVisitor& visitor = {});

  [[nodiscard]] bool roots_overlap() const;

 private:
  const Trip* trip_;
  TraversalOptions options_;
  PosedBoxes a_;
  PosedBoxes b_;
  std::optional<EnodeFront> front_;
  TraversalWorkspace workspace_;
};

/// Overlapping pairs of leaves of each frame, sorted.
using LeafPairs = std::vector<std::vector<NodePair>>;

/// Counts of each frame by a traversal, leaves only; their pairs go to `pairs` where that is given.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<Frame> traverse_frames(const Trip& trip, const NamedTraversal& traversal,
                                                 const Limits& limits, LeafPairs* pairs = nullptr);

/// Counts and triangle contacts of each frame by a traversal. \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<Frame> answer_frames(const Trip& trip, const NamedTraversal& traversal,
                                               const Limits& limits);

/// Milliseconds of each frame: `collision` is the traversal and the triangle tests, `frame` is
/// moving the boxes as well.
struct FrameTimes {
  std::vector<Timing> collision;
  std::vector<Timing> frame;
};

/// A trip by a traversal, to be timed.
struct TripRun {
  const Trip* trip = nullptr;
  NamedTraversal traversal = {};
  std::size_t step = 1;  ///< every so many frames are timed
};

/// Times trips in turn, frame by frame, every other round in the reverse order: round i of one and
/// round i of another are a pair. \shape one FrameTimes a run, one Timing a frame; frames that are
/// not timed have no rounds. \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<FrameTimes> time_trips(std::span<const TripRun> runs, int repetitions,
                                                 const Limits& limits);

/// Milliseconds by round, summed over the timed frames in which the roots overlap.
[[nodiscard]] std::vector<double> sums_by_round(std::span<const Timing> times,
                                                std::span<const Frame> frames);

/// `time_trips` of several traversals on one trip. \shape one FrameTimes a traversal.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<FrameTimes> time_frames(const Trip& trip,
                                                  std::span<const NamedTraversal> traversals,
                                                  int repetitions, const Limits& limits,
                                                  std::size_t step = 1);

/// Times every `step`-th frame of a trip by several traversals in turn, the traversals alone,
/// without moving boxes and without triangles: milliseconds of these frames. \shape one Timing a
/// traversal. \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<Timing> time_traversals(const Trip& trip,
                                                  std::span<const NamedTraversal> traversals,
                                                  int repetitions, const Limits& limits,
                                                  std::size_t step = 1);

/// Milliseconds of every `step`-th frame beside its traversal: moving the boxes and testing the
/// triangles. The traversal is timed right after each frame, so that both meet the machine alike.
/// \errors ErrorKind::cancelled.
[[nodiscard]] Timing time_beside_traversal(const Trip& trip, const NamedTraversal& traversal,
                                           int repetitions, const Limits& limits,
                                           std::size_t step = 1);

}  // namespace soms::reproduce
