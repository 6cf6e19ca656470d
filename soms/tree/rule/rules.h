/// \file
/// The table of splitting rules: their names, what they do, and their functions.
#pragma once

#include "soms/tree/build_options.h"
#include "soms/tree/rule/split.h"

#include <span>
#include <string_view>

namespace soms {

/// A row of the table of rules.
struct RuleEntry {
  Rule rule = Rule::soms;
  std::string_view name = {};         ///< snake_case, as in files
  std::string_view kebab = {};        ///< kebab-case, as on the command line
  std::string_view description = {};  ///< one line for help texts and pages
  RuleFunction split = nullptr;
  AxisFrom axis_from =
      AxisFrom::inner;       ///< box whose longest axis is split unless the options say otherwise
  bool needs_outer = false;  ///< it looks at SplitNode::outer
  bool needs_order = false;  ///< it looks at primitives in ascending order of their numbers
  /// Trees are made by a builder of their own, which divides nearly as `split` would; midpoint,
  /// axis_from and empty_side have no effect (`idle_options`).
  bool own_builder = false;
};

/// All rules, in the order of `Rule`.
[[nodiscard]] std::span<const RuleEntry> rules();

/// Row of a rule.
[[nodiscard]] const RuleEntry& entry(Rule rule);

/// Row of the rule with this name, in snake_case or kebab-case.
/// \errors  ErrorKind::usage, which lists the names.
[[nodiscard]] const RuleEntry& rule_named(std::string_view name);

/// The rules' functions, one file each.
namespace rule {

/// Equal counts: left are the first floor(n/2) by midpoint, ties by triangle number. Never fails.
/// \source  Ericson 2005, section 6.2.1.
[[nodiscard]] Split object_median(const SplitNode& node, std::size_t axis);

/// Plane at the mean of the midpoints, summed in ascending order of triangle numbers.
/// \source  Ericson 2005, section 6.2.1.
[[nodiscard]] Split object_mean(const SplitNode& node, std::size_t axis);

/// Plane in the middle of the outer box: fails when all midpoints lie on one side of it.
/// \source  Ericson 2005, section 6.2.1.
[[nodiscard]] Split spatial_median(const SplitNode& node, std::size_t axis);

/// Plane in the middle of the inner box: fails only where all midpoints agree on the axis.
/// \source  thesis, section 4 (fig. 4.6).
[[nodiscard]] Split soms(const SplitNode& node, std::size_t axis);

/// Plane of least surface area cost, of 15 equally spaced ones on each axis of the inner box; of
/// equal costs the first on `axis`. Fails only where all midpoints are equal.
/// \source  Goldsmith and Salmon 1987; Wald 2007, On fast construction of SAH-based bounding
///          volume hierarchies.
[[nodiscard]] Split sah(const SplitNode& node, std::size_t axis);

/// SOMS with a second look where its plane is poor: as `soms`, unless the box of a primitive is
/// wider on `axis` than half the inner box, then as `sah`. Fails only where all midpoints are
/// equal, or agree on `axis` and no primitive has a width there.
[[nodiscard]] Split soms_sah(const SplitNode& node, std::size_t axis);

}  // namespace rule
}  // namespace soms
