/// \file
/// Overlap of two shapes by one named traversal of their canonical trees, pose after pose.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/query/overlap.h"
#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/traversal_options.h"
#include "soms/tree/shape.h"

#include <memory>

namespace soms::thesis {

/// Overlap queries of two shapes by one named traversal, pose after pose: keeps the moved boxes of
/// a body that stands still, and the front of Traversal::e_node_front.
class NamedOverlap {
 public:
  /// \errors ErrorKind::usage without kept trees, for Traversal::fast, and for options that do not
  ///         go together (`check(TraversalOptions)`).
  NamedOverlap(const Shape& a, const Shape& b, const TraversalOptions& options);
  ~NamedOverlap();
  NamedOverlap(NamedOverlap&&) noexcept;
  NamedOverlap& operator=(NamedOverlap&&) noexcept;

  /// Answer at two poses, as `soms::overlap` defines it.
  /// A limit of N counts as cut only when an (N+1)-th pair was found; which N are returned follows
  /// the traversal's order, with a front also the frames before.
  ///
  /// \errors  ErrorKind::not_rigid, not_finite, out_of_range for a pose; cancelled.
  /// \cost    O(n) to move the boxes of a body whose pose changed, then the traversal. One thread:
  ///          of `limits` only `stop` is heeded.
  /// \threads One caller at a time.
  [[nodiscard]] Overlap operator()(const Pose& pose_a, const Pose& pose_b,
                                   const OverlapOptions& options, const Limits& limits);

  /// Moves both bodies now: a query at the same poses that follows finds them moved. For who times
  /// the two apart.
  /// \errors ErrorKind::not_rigid, not_finite, out_of_range for a pose.
  void move(const Pose& pose_a, const Pose& pose_b);

  /// Work of the traversal of the last query; zeros before the first.
  [[nodiscard]] const TraversalCounts& counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace soms::thesis
