/// \file
/// The traversal of a motion: pairs of nodes in space and time, those that may meet first.
#pragma once

#include "soms/motion/detail/contact_goal.h"
#include "soms/motion/detail/motion_bounds.h"
#include "soms/motion/detail/motion_interval.h"
#include "soms/motion/detail/swept_boxes.h"
#include "soms/motion/detail/swept_triangle.h"
#include "soms/query/answer.h"
#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/engine/limit.h"

#include <cstdint>
#include <vector>

namespace soms::detail {

/// Pairs of nodes of the mover, x, and the other body, y, each over a stretch of the way. A pair
/// whose windows leave no time is done. Of the others, nodes are descended, the larger one alone
/// where they differ much; the time is halved only where the bow of the way is large beside the
/// nodes, so never for a straight motion. A heap holds them by the time before which they are free.
template <class Source>
class ContactTraversal {
 public:
  /// \pre No mesh is empty. Refers to what it is given.
  ContactTraversal(const MotionBounds& bounds, const Shape& mover, const Shape& other,
                   ContactGoal& goal);

  /// Runs to the end, or until the limit is spent. True if it came to the end.
  [[nodiscard]] bool run(Limit& limit);

  /// All is free until this, but for what the goal knows; infinity at the end.
  [[nodiscard]] double free_until() const;

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
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
    double from;
    double until;
    std::uint32_t x;  ///< among the swept ones
    TriangleId id_x;
    TriangleId id_y;
  };

  /// Two leaves over a stretch of the way.
  struct LeafPair {
    const MotionInterval& interval;
    const SweptBoxes& x;
    std::size_t lane_x;
    const SweptBoxes& y;
    std::size_t lane_y;
    double key;
  };

  void push(const Task& task);
  void step(const Task& task, Limit& limit);

  /// Halves the time if the bow of x is large beside the boxes. True if it did.
  [[nodiscard]] bool halve(const Task& task, const SweptBoxes& x, std::size_t lane_x,
                           const SweptBoxes& y, std::size_t lane_y);
  void open(const Task& task);
  void look_at_leaves(const Task& task, Limit& limit);
  void look_at_blocks(const TriangleBlock& x, const TriangleBlock& y, const LeafPair& leaves);
  void advance_meetings();

  /// The time before which a leaf is free of a box beside it; infinity if it always is.
  [[nodiscard]] double free_of_box(std::uint32_t token, const SweptBoxes& x,
                                   const MotionInterval& interval);
  [[nodiscard]] double free_of_box(const SweptBoxes& y, std::uint32_t token,
                                   const MotionInterval& interval);
  [[nodiscard]] std::uint32_t halves_of(std::uint32_t interval);

  const MotionBounds& bounds_;
  const Shape& mover_;
  Body resting_;  ///< the other body in the frame of the law
  ContactGoal& goal_;
  Source x_;
  Source y_;
  std::vector<MotionInterval> intervals_;
  std::vector<Task> heap_;
  std::vector<SweptTriangle> swept_;
  std::vector<TriangleId> swept_ids_;
  std::vector<Meeting> meetings_;
  Cost cost_;
  double unfinished_;
};

extern template class ContactTraversal<WideSource>;
extern template class ContactTraversal<CompactSource>;

}  // namespace soms::detail
