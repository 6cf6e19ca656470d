/// \file
/// The table of traversals: name, meaning and function of each.
#pragma once

#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/traversal_options.h"

#include <span>
#include <string_view>

namespace soms {

/// The one signature of traversals: reports every pair of leaves whose boxes overlap, each once,
/// and counts the work. Options were checked, both trees have a node, and with `recursive` they are
/// not too deep.
using TraversalFunction = TraversalCounts (*)(const PosedTree& a, const PosedTree& b,
                                              const TraversalOptions& options,
                                              const TraversalVisitor& visitor,
                                              TraversalWorkspace& workspace);

/// An entry of the table of traversals.
struct TraversalEntry {
  Traversal traversal;
  std::string_view name;   ///< snake_case: CSV, JSON, Python
  std::string_view kebab;  ///< kebab-case: the command line
  std::string_view description;
  TraversalFunction function;  ///< nullptr for `fast`, which traverses the layout, not the trees
};

/// An entry of the table of E-Node's descents.
struct DescentEntry {
  Descent descent;
  std::string_view name;   ///< snake_case
  std::string_view kebab;  ///< kebab-case
  std::string_view description;
};

/// All traversals, in the order of the enumeration.
[[nodiscard]] std::span<const TraversalEntry> traversals();

/// All descents of E-Node, in the order of the enumeration.
[[nodiscard]] std::span<const DescentEntry> descents();

/// The entry of a traversal. \errors ErrorKind::usage for a value outside the enumeration.
[[nodiscard]] const TraversalEntry& entry(Traversal traversal);

/// The entry of a descent. \errors ErrorKind::usage for a value outside the enumeration.
[[nodiscard]] const DescentEntry& entry(Descent descent);

/// The entry of the traversal with this name, in snake_case or kebab-case. "default" is
/// the one that TraversalOptions start with.
/// \errors ErrorKind::usage, which lists the names.
[[nodiscard]] const TraversalEntry& traversal_named(std::string_view name);

/// The entry of the descent with this name.
/// \errors ErrorKind::usage, which lists the names.
[[nodiscard]] const DescentEntry& descent_named(std::string_view name);

/// True for E-Node, from the roots or from a front: only it has a descent and an order.
[[nodiscard]] bool has_descent(Traversal traversal);

/// Throws ErrorKind::usage unless the options go together: `ericson` with the rule of a baseline,
/// the front with descent both or larger and with pruning, and options that have no effect beside
/// the traversal at their defaults. Values outside their enumerations fail.
void check(const TraversalOptions& options);

/// Traverses two trees by a named traversal.
///
/// The answer (the set of pairs reported) is the same for every traversal and option: all pairs of
/// leaves whose boxes overlap; touching counts. An empty tree has none. Order and work differ.
///
/// \errors  As `check`; usage for Traversal::fast, for boxes that are not as many as nodes, and for
///          recursion in trees that are together deeper than `kMaxRecursion`.
/// \cost    At worst every pair of nodes. Reuses the workspace; no recursion unless requested.
/// \source  thesis, section 4.5.2 by its captions; Ericson 2005, section 6.3.
TraversalCounts traverse(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                         const TraversalVisitor& visitor, TraversalWorkspace& workspace);

/// As above, with a workspace of its own.
TraversalCounts traverse(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                         const TraversalVisitor& visitor = {});

namespace detail {

/// Throws ErrorKind::usage unless both trees are given, each with one box a node.
void check_boxes(const PosedTree& a, const PosedTree& b);

}  // namespace detail

/// Most nested calls of a recursive traversal: fits a stack of 256 KiB with room, also in debug and
/// sanitizer builds. The depths of both trees together plus one must not exceed it.
inline constexpr std::uint32_t kMaxRecursion = 256;

}  // namespace soms
