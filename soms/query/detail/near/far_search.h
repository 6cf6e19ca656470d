/// \file
/// The nearest triangles of bodies that are many times their size apart: those that reach farthest
/// toward the other body.
///
/// Along one direction n between the bodies the gap of two triangles is a sum, of what each of them
/// reaches: |g| >= n.g = n.a - n.b. So each tree is searched by itself for the triangles that reach
/// far enough, in O(log n) where few do, and only their pairs are bounded, along a direction of
/// their own. A traversal of pairs of nodes would look at each of the one with each of the other.
///
/// Rounding, in units of u64 V (near_pose.h): a moved origin along n, 7 and 5.3; a moved vertex
/// that bounds of nodes stand for, 7; the length of n and a sum of two of these, 18: below 65. A
/// moved corner is exact, and along n off by 5.3. All keys and limits give way by kFarRounding,
/// and by kFarBoxes of a node's radius for sums over its boxes in float. What underflows: the
/// 2^-1064 and 2^-100 of near_pose.h.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/near/near_goal.h"

#include <cstddef>
#include <vector>

namespace soms::detail {

/// A search for one goal.
template <class Source>
class FarSearch {
 public:
  FarSearch(const PairFrame& frame, NearGoal& goal);

  /// True when everything that mattered was offered to the goal. False where too many triangles
  /// reach as far, as those of flat faces do, or where time is up: then the search is left to a
  /// traversal, which finds the goal's bound lower than it was.
  /// \errors ErrorKind::cancelled.
  [[nodiscard]] bool run(Limit& limit);

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  /// Most triangles of a body that are kept, and most pairs of them that are looked at.
  static constexpr std::size_t kTriangles = 2048;
  static constexpr std::size_t kLooks = 4 * kTriangles;  ///< at triangles for the farthest one
  static constexpr std::size_t kPairs = 8192;

  /// A body, and +1 or -1: a point reaches to that times its place along the direction, and the
  /// less that is, the nearer it is to the other body.
  struct Side {
    const PosedShape* body;
    Source source;
    double sign;
  };

  /// A node, or a triangle, with the least that a point of it reaches to.
  struct Reach {
    double least;
    std::uint32_t id;

    [[nodiscard]] bool operator<(const Reach& other) const {
      return least < other.least || (least == other.least && id < other.id);
    }
  };

  struct Candidate {
    double lower;
    TrianglePair ids;

    [[nodiscard]] bool operator<(const Candidate& other) const {
      return lower < other.lower || (lower == other.lower && ids < other.ids);
    }
  };

  /// The triangle that reaches farthest; false where too many reach as far, or time is up. Then
  /// `least` is that of those looked at.
  [[nodiscard]] bool find_least(Side& side, Limit& limit, Reach& least);

  /// All triangles that reach to `most`; false where they are too many, or time is up.
  [[nodiscard]] bool collect(Side& side, double most, Limit& limit, std::vector<Reach>& found);

  void open(Side& side, std::uint32_t node, double most);
  template <class Take>
  void look_at_leaf(Side& side, std::uint32_t token, const Take& take);

  /// Bounds the pairs that may matter; false where they are too many.
  [[nodiscard]] bool pair_up(const std::vector<Reach>& of_x, const std::vector<Reach>& of_y);
  [[nodiscard]] double lower_bound(const TrianglePair& ids) const;

  /// No pair whose reaches add up to more than this matters.
  [[nodiscard]] double most() const { return goal_.upper() + slack_; }

  const PairFrame& frame_;
  NearGoal& goal_;
  Side x_;
  Side y_;
  Vec3 direction_;
  double slack_;
  Cost cost_;
  std::vector<Reach> nodes_;  // a heap, the least on top
  std::vector<std::uint32_t> leaves_;
  std::vector<Candidate> candidates_;
};

extern template class FarSearch<WideSource>;
extern template class FarSearch<CompactSource>;

}  // namespace soms::detail
