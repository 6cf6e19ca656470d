/// \file
/// A trip whose boxes and triangles were all moved beforehand: what is left to do, and to time, is
/// the query alone.
#pragma once

#include "soms/base/limits.h"
#include "soms/thesis/e_node_front.h"
#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/traversal_options.h"
#include "soms/thesis/traversals.h"

#include "thesis/races/race_process.h"
#include "thesis/trips/frames.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soms::reproduce {

/// The frames of a trip, moved.
class MovedTrip {
 public:
  /// `trip` must outlive the object. \errors ErrorKind::cancelled.
  MovedTrip(const Trip& trip, const Limits& limits);

  [[nodiscard]] const Trip& trip() const { return *trip_; }

  [[nodiscard]] std::size_t frames() const { return boxes_.size(); }

  /// 0, 1, ... in order.
  [[nodiscard]] std::vector<std::size_t> all_frames() const;

  [[nodiscard]] PosedTree still() const { return still_.view(); }

  [[nodiscard]] PosedTree moving(std::size_t frame) const {
    return {trip_->b.tree(), boxes_[frame]};
  }

  /// Pairs of triangles of two leaves that touch in a frame; at most `most` are counted.
  [[nodiscard]] std::uint64_t contacts(std::size_t frame, NodePair leaves,
                                       std::uint64_t most) const;

 private:
  [[nodiscard]] Triangle moved(std::size_t frame, TriangleId triangle) const;

  const Trip* trip_;
  PosedBoxes still_;
  std::vector<std::vector<Box>> boxes_;      ///< of the moving body, by frame
  std::vector<std::vector<Vec3>> vertices_;  ///< of the moving body, by frame
};

/// A traversal that is compared with others.
struct TripRacer {
  std::string name;  ///< as in the tables: "enode_both"
  TraversalOptions options = {};
  bool chain = false;  ///< `e_node_chain` instead of what `options` say
};

/// Traverses the frames of a moved trip; E-Node from the last front goes from frame to frame.
class FrameTraversal {
 public:
  /// Both must outlive the object. \pre Both trees have a node, the trip has a frame.
  FrameTraversal(const MovedTrip& moved, const TripRacer& racer);

  /// Forgets the frames before.
  void restart();

  TraversalCounts run(std::size_t frame, const TraversalVisitor& visitor = {});

 private:
  const MovedTrip* moved_;
  const TripRacer* racer_;
  TraversalFunction function_;
  std::optional<EnodeFront> front_;
  TraversalWorkspace workspace_;
};

/// What a query is to find.
enum class Question {
  leaf_pairs,       ///< all pairs of leaves whose boxes overlap: the traversal alone
  contacts,         ///< all pairs of triangles that touch: traversal and triangles
  first_leaf_pair,  ///< stops at the first pair of leaves
  first_contact,    ///< stops at the first pair of triangles that touch
};

/// Asks a question in some frames of a trip, from a fresh start of the traversal. Returns how many
/// leaf pairs, contacts, or frames with a hit there are: the same for all traversals.
std::uint64_t ask(const MovedTrip& moved, FrameTraversal& traversal, Question question,
                  std::span<const std::size_t> frames);

/// The middle `share`-th of frames, neighbors as before; at least one if there is one.
[[nodiscard]] std::vector<std::size_t> middle_of(std::span<const std::size_t> frames,
                                                 std::size_t share);

/// What is timed on a trip.
struct TripRace {
  std::span<const TripRacer> racers;
  Question question = Question::leaf_pairs;
  std::span<const std::size_t> frames;
  int rounds = 0;          ///< of all processes
  std::size_t passes = 1;  ///< through the frames, where they take less time than would be seen
};

/// Times the question by several traversals in turn, one reading of the processor clock before and
/// one after all of the frames.
/// \shape one Timing a racer, of the frames once.
/// \errors std::logic_error where answers disagree; ErrorKind::cancelled.
[[nodiscard]] std::vector<Timing> race(RaceProcess& process, const MovedTrip& moved,
                                       const TripRace& race, const Limits& limits);

}  // namespace soms::reproduce
