/// \file
/// One body moves past another, frame by frame, and named walks ask each frame what they share:
/// counts, answers, times.
#pragma once

#include "soms/base/parallel.h"
#include "soms/base/vector.h"
#include "soms/query/overlap.h"
#include "soms/query/traversal/e_node_front.h"
#include "soms/query/traversal/pair_traversal.h"
#include "soms/query/traversal/posed_boxes.h"
#include "soms/query/traversal/thesis_frames.h"
#include "soms/query/traversal_options.h"
#include "soms/tree/shape.h"

#include "reproduce/contenders.h"
#include "reproduce/levels.h"
#include "reproduce/models.h"
#include "reproduce/timing.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// How many times as large as its file the object drives through a city.
inline constexpr double kDriveScale = 500;

/// A body that stands still and one that moves past it, both with their canonical trees.
struct Trip {
  std::string still;               ///< name of the model that stands still
  std::string moving;              ///< name of the model that moves, as in the golden tables
  std::string test;                ///< "right" and the other approaches, or "drive"
  std::string rule;                ///< name of the build of both trees
  Shape a = {};                    ///< stands still
  Shape b = {};                    ///< moves
  std::vector<Vec3> offsets = {};  ///< of `b`, one a frame

  [[nodiscard]] Pose pose(std::size_t frame) const {
    return Pose::translation(offsets[frame].x, offsets[frame].y, offsets[frame].z);
  }
};

/// An object comes at another of its kind (y up), both trees by the same build.
[[nodiscard]] Trip orientation_trip(const Model& object, Approach from, const Contender& build);

/// An object, turned z up and enlarged, drives through a scene.
[[nodiscard]] Trip drive_trip(const Model& scene, const Model& object,
                              const Contender& build_of_scene, const Contender& build_of_object);

/// A walk by the name that tables show.
struct Walk {
  std::string name;
  TraversalOptions options = {};
};

/// All walks of canonical trees that differ: the baselines, E-Node with its descents and orders,
/// and from the front of the frame before ("start"). Names as in the golden tables.
[[nodiscard]] std::vector<Walk> all_walks();

/// The walk with this name. \pre `all_walks` has it.
[[nodiscard]] Walk walk_named(std::string_view name);

/// What a walk did in one frame. Triangles only where they were asked about.
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

/// Walks a trip, leaf boxes only, frame after frame.
class LeafWalk {
 public:
  /// `trip` must outlive the object.
  LeafWalk(const Trip& trip, const TraversalOptions& options);

  /// Moves the boxes to a frame.
  void move(std::size_t frame);

  /// Walks the frame.
  TraversalCounts walk(const TraversalVisitor& visitor = {});

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

/// Counts of each frame by a walk, leaves only; their pairs go to `pairs` where that is given.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<Frame> walk_frames(const Trip& trip, const Walk& walk,
                                             const Parallel& parallel, LeafPairs* pairs = nullptr);

/// Counts and triangle contacts of each frame by a walk. \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<Frame> answer_frames(const Trip& trip, const Walk& walk,
                                               const Parallel& parallel);

/// Milliseconds of each frame: `collision` is the walk and the triangle tests, `frame` is moving
/// the boxes as well.
struct FrameTimes {
  std::vector<Timing> collision;
  std::vector<Timing> frame;
};

/// Times whole trips by several walks in turn, frame by frame. \shape one FrameTimes a walk.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<FrameTimes> time_frames(const Trip& trip, std::span<const Walk> walks,
                                                  int repetitions, const Parallel& parallel);

/// Times whole trips by several walks in turn, the walks alone, without moving boxes and without
/// triangles: milliseconds a trip. \shape one Timing a walk. \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<Timing> time_walks(const Trip& trip, std::span<const Walk> walks,
                                             int repetitions, const Parallel& parallel);

/// Milliseconds a trip of what a whole frame takes beside its walk: moving the boxes and testing
/// the triangles. The walk is timed right after each frame, so that both meet the machine alike.
/// \errors ErrorKind::cancelled.
[[nodiscard]] Timing time_beside_walk(const Trip& trip, const Walk& walk, int repetitions,
                                      const Parallel& parallel);

}  // namespace soms::reproduce
