/// \file
/// How a tree is built: the rule and the options that all rules share.
#pragma once

#include "soms/base/idle_option.h"
#include "soms/base/words.h"
#include "soms/geometry/midpoint.h"

#include <optional>
#include <vector>

namespace soms {

/// Splitting rules; `rule/rules.h` has the table of their names and functions.
enum class Rule {
  object_median,   ///< equal counts on both sides
  object_mean,     ///< plane at the mean of the midpoints
  spatial_median,  ///< plane in the middle of the outer box
  soms,            ///< Spatial Object Median Splitting: plane in the middle of the midpoints' box
  sah,             ///< least surface area cost over 16 bins of the midpoints' box
  soms_sah,        ///< as soms where triangles are small against the node, else as sah
  fast,            ///< SOMS with a second look, on boxes in float, for leaves of 8
  quality,         ///< SAH by blocks of leaves, on boxes in float: the fewest boxes entered
  quick,           ///< by Morton codes: soonest built, for meshes that change or are loaded
};

template <>
inline constexpr auto kWords<Rule> = words("Rule", "How nodes of a tree are divided.",
                                           "object_median", "object_mean", "spatial_median", "soms",
                                           "sah", "soms_sah", "fast", "quality", "quick");

/// Box whose longest axis is split.
enum class AxisFrom {
  outer,  ///< box of all corners
  inner,  ///< box of the midpoints
};

template <>
inline constexpr auto kWords<AxisFrom> = words("AxisFrom",
                                               "From which list the axis of a split is taken.",
                                               "outer", "inner");

/// What happens when a rule leaves one side empty.
enum class EmptySide {
  stop,           ///< the node becomes a leaf with all its triangles
  next_axis,      ///< the other axes in order of extent, then as `stop`
  object_median,  ///< object median on the first axis
  chain,          ///< one child without triangles, the other with all; goes on to the last level
};

template <>
inline constexpr auto kWords<EmptySide> = words("EmptySide",
                                                "What happens where a side of a split is empty.",
                                                "stop", "next_axis", "object_median", "chain");

/// Options of a build. The defaults are the product's; `thesis_options` gives the thesis'.
struct BuildOptions {
  Rule rule = Rule::fast;
  Midpoint midpoint = Midpoint::aabb;
  int c_vertex = 2;  ///< corner that Midpoint::thesis calls C: 0, 1 or 2
  /// Unset: inner for soms, sah and soms_sah, outer for the others.
  std::optional<AxisFrom> axis_from = std::nullopt;
  EmptySide empty_side = EmptySide::object_median;
  /// Levels: nodes at depth level-1 are never divided. 0 means without limit.
  int level = 0;
  /// Number of the root's level, 1 or 0; with 0, level L means depths 0 to L.
  int root_level = 1;
  /// Nodes with at most this many triangles are leaves.
  int per_leaf = 8;

  [[nodiscard]] bool operator==(const BuildOptions&) const = default;
};

/// Options of the thesis for a rule: midpoint thesis, its own axis, empty side `stop`, one triangle
/// a leaf, `level` levels (15 for its PLY objects, 13 for its urban scene). Rules that came after
/// the thesis (`fast`, `quality`, `quick`) use the last two alone. \source  design of the thesis:
/// fig. 4.23, tables 5.3, 5.9.
[[nodiscard]] BuildOptions thesis_options(Rule rule, int level = 15);

/// Options that have no effect beside the others, in the order of the fields. Which they are
/// depends on `rule`, `midpoint` and `level` alone: rules with builders of their own use neither
/// midpoints nor axes and leave no side empty; only the midpoint of the thesis has a corner C; the
/// number of the root's level counts only where levels are limited. \errors  ErrorKind::usage where
/// `rule` is none of the named ones.
[[nodiscard]] std::vector<IdleOption> idle_options(const BuildOptions& options);

/// The same options, those that have no effect set to their defaults: what `build` makes of them.
/// \errors  As `idle_options`.
[[nodiscard]] BuildOptions without_idle(BuildOptions options);

/// Throws ErrorKind::usage unless every option is within its range, and at its default where it has
/// no effect (`idle_options`); names the option.
void check(const BuildOptions& options);

}  // namespace soms
