/// \file
/// The traversal of a motion: pairs of nodes in space and time, those that may meet first.
#pragma once

#include "soms/motion/detail/contact_goal.h"
#include "soms/motion/detail/kernels/motion_kernels.h"
#include "soms/motion/detail/motion_bounds.h"
#include "soms/motion/detail/motion_interval.h"
#include "soms/motion/detail/swept_boxes.h"
#include "soms/motion/detail/triangle_lanes.h"
#include "soms/query/answer.h"
#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/engine/limit.h"

#include <cstdint>
#include <deque>
#include <span>
#include <type_traits>
#include <vector>

namespace soms::detail {

/// Pairs of nodes of the mover, x, and the other body, y, each over a stretch of the way. A pair
/// whose windows leave no time is done. Of the others, nodes are descended, the larger one alone
/// where they differ much; the time is halved only where the bow of the way is large beside the
/// nodes, so never for a straight motion. Heaps hold pairs of nodes and of triangles by the time
/// before which they are free: none is looked at before others that may meet first.
template <class Source>
class ContactTraversal {
 public:
  /// `nodes` are ids of nodes and leaves of the other body: what is below none of them is of no
  /// interest. \pre No mesh is empty. Refers to what it is given.
  ContactTraversal(const MotionBounds& bounds, const Shape& mover, const Shape& other,
                   std::span<const std::uint32_t> nodes, ContactGoal& goal);

  /// Runs to the end, or until the limit is spent. True if it came to the end.
  [[nodiscard]] bool run(Limit& limit);

  /// All is free until this, but for what the goal knows; infinity at the end.
  [[nodiscard]] double free_until() const;

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  /// What a source gives is copied where it may give it up for what it gives next.
  template <class Item>
  using Kept = std::conditional_t<Source::kInPlace, const Item&, Item>;

  struct Task {
    double key;  ///< the pair is free until then
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t interval;
    std::uint32_t depth;
  };

  /// The heap's order: the least key on top, of equal ones the deepest.
  struct Later {
    bool operator()(const Task& a, const Task& b) const {
      return a.key > b.key || (a.key == b.key && a.depth < b.depth);
    }
  };

  /// Two triangles and what is left of their time.
  struct Meeting {
    double key;
    double until;
    TrianglePair ids;
  };

  /// The heap's order: the least key on top, of equal ones the least pair.
  struct LaterMeeting {
    bool operator()(const Meeting& a, const Meeting& b) const {
      return a.key > b.key || (a.key == b.key && b.ids < a.ids);
    }
  };

  /// Two leaves over a stretch of the way, and their boxes.
  struct LeafPair {
    const MotionInterval& interval;
    const SweptBoxes& x;
    const SweptBoxes& y;
    double key;
  };

  void push(const Task& task);
  void step(const Task& task, Limit& limit);

  /// The bow of a box of x is large beside both boxes, whose radii sum up to `radii`.
  [[nodiscard]] bool bows(const MotionInterval& interval, double give, double radii) const;

  /// Halves the time unless it leaves the boxes, one of each, apart.
  void halve(const Task& task, const SweptBoxes& x, const SweptBoxes& y);
  void open(const Task& task);
  void look_at_leaves(const Task& task, Limit& limit);
  void look_at_blocks(const TriangleBlock& x, const TriangleBlock& y, const LeafPair& leaves);
  void advance(const Meeting& meeting);

  /// Triangles are at least as early as nodes.
  [[nodiscard]] bool meeting_is_next() const;

  /// The time before which a leaf of the mover, or of the other body, is free of a box beside it;
  /// infinity if it always is. `bow` is as for MotionKernels::sweep.
  [[nodiscard]] double mover_free_of_box(std::uint32_t token, double bow, const SweptBoxes& box,
                                         const MotionInterval& interval);
  [[nodiscard]] double rest_free_of_box(std::uint32_t token, const SweptBoxes& box,
                                        const MotionInterval& interval);

  /// The begin of the first window.
  [[nodiscard]] double first_begin(const MotionInterval& interval) const;
  [[nodiscard]] std::uint32_t halves_of(std::uint32_t interval);

  const MotionBounds& bounds_;
  const Shape& mover_;
  Body resting_;  ///< the other body in the frame of the law
  ContactGoal& goal_;
  Source x_;
  Source y_;
  std::deque<MotionInterval> intervals_;  ///< none is ever moved
  std::vector<Task> heap_;
  const MotionKernels& kernels_;
  TriangleLanes lanes_x_;
  TriangleLanes lanes_y_;
  WindowsOfLanes windows_;
  std::vector<Meeting> meetings_;
  Cost cost_;
  double unfinished_;
};

extern template class ContactTraversal<WideSource>;
extern template class ContactTraversal<CompactSource>;

}  // namespace soms::detail
