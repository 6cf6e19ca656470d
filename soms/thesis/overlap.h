/// \file
/// Overlap by the named traversals of the thesis, with their counts: for comparison, teaching and
/// reproduction. `soms::overlap` gives the same answers sooner.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/body.h"
#include "soms/query/overlap.h"
#include "soms/query/overlap_method.h"
#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/traversal_options.h"

#include <span>
#include <vector>

namespace soms::thesis {

/// Answer of an overlap query by a traversal.
struct CountedOverlap {
  Overlap answer;
  TraversalCounts counts;  ///< zeros for Traversal::fast

  [[nodiscard]] bool operator==(const CountedOverlap&) const = default;
};

/// `soms::overlap` by `traversal`: Traversal::fast calls it, named ones traverse the canonical
/// trees on one thread. Traversal::e_node_front starts at the roots, since there is no last pose.
///
/// \errors As `soms::overlap` and `check(TraversalOptions)`; ErrorKind::usage for a named traversal
///         of shapes made without ShapeOptions::keep_tree.
/// \cost   As NamedOverlap, for a pose that is new.
[[nodiscard]] CountedOverlap overlap(const Body& a, const Body& b,
                                     const TraversalOptions& traversal,
                                     const OverlapOptions& options = {}, const Limits& limits = {});

/// The same for `mover` at each of `poses`. Answers equal those of single queries. Only the front
/// of Traversal::e_node_front goes from pose to pose: with it costs, the pair of mode `any` and the
/// pairs that a limit lets through follow the poses before, too.
///
/// \shape  `poses`: n; answers: n.
/// \errors As above; a pose at fault is named by its index.
[[nodiscard]] std::vector<CountedOverlap> overlap(const Shape& mover, std::span<const Pose> poses,
                                                  const Body& fixed,
                                                  const TraversalOptions& traversal,
                                                  const OverlapOptions& options = {},
                                                  const Limits& limits = {});

/// A named traversal for scenes: StepOptions::method.
class TraversalMethod final : public OverlapMethod {
 public:
  /// \errors ErrorKind::usage for Traversal::fast, and as `check(TraversalOptions)`.
  explicit TraversalMethod(const TraversalOptions& traversal);
  ~TraversalMethod() override;

  /// \errors ErrorKind::usage for shapes made without ShapeOptions::keep_tree; cancelled.
  [[nodiscard]] OverlapBatch ask(const Shape& mover, std::span<const Pose* const> poses,
                                 const Body& fixed, const OverlapOptions& options,
                                 const Limits& limits) const override;

 private:
  TraversalOptions traversal_;
};

}  // namespace soms::thesis
