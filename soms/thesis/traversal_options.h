/// \file
/// Traversals of two trees, by name. All give the same answers; they differ in work.
#pragma once

#include "soms/base/idle_option.h"
#include "soms/base/words.h"

#include <vector>

namespace soms {

/// Traversals; `traversal/traversals.h` has the table of their names and functions.
enum class Traversal {
  fast,          ///< the product's default: the wide layout, margins proved, any pose
  a_first,       ///< descend the first tree to its leaves, then the second
  b_first,       ///< the mirror image
  alternate,     ///< each in turn
  larger,        ///< descend the node of greater model-space volume
  simultaneous,  ///< descend both
  ericson,       ///< generic recursion with a choice of the above (default larger)
  larsson,       ///< alias of simultaneous, a reconstruction
  e_node,        ///< E-Node: all child pairs are tested before any is entered
  e_node_front,  ///< E-Node that starts from the last front (a session keeps it)
};

template <>
inline constexpr auto kWords<Traversal> = words("Traversal", "Which traversal of the thesis it is.",
                                                "fast", "a_first", "b_first", "alternate", "larger",
                                                "simultaneous", "ericson", "larsson", "e_node",
                                                "e_node_front");

/// Which child pairs E-Node tests.
enum class Descent { both, larger, cross, fewest };

template <>
inline constexpr auto kWords<Descent> = words("Descent", "Which node is descended into first.",
                                              "both", "larger", "cross", "fewest");

/// Order in which E-Node enters overlapping child pairs.
enum class EntryOrder { tree, volume };

template <>
inline constexpr auto kWords<EntryOrder> = words("EntryOrder", "In which order nodes are entered.",
                                                 "tree", "volume");

/// How node boxes follow a pose.
enum class BoxUpdate {
  refit,  ///< recomputed from the moved vertices: exact bounds
  rebox,  ///< bounds of the eight moved corners, widened outward: looser, cheaper
};

template <>
inline constexpr auto kWords<BoxUpdate> = words("BoxUpdate", "How boxes follow what moves.",
                                                "refit", "rebox");

/// Options of a named traversal; `fast` has none. One that has no effect beside `traversal` stays
/// at its default, or the query is refused (`idle_options`).
struct TraversalOptions {
  Traversal traversal = Traversal::fast;
  Descent descent = Descent::both;             ///< of E-Node
  EntryOrder order = EntryOrder::tree;         ///< of E-Node
  Traversal ericson_rule = Traversal::larger;  ///< descent rule of `ericson`
  bool recursive = false;                      ///< baselines, e_node: recursion, not a stack
  bool prune = true;                           ///< false only to show its cost (fig. 4.35)
  BoxUpdate update = BoxUpdate::refit;

  [[nodiscard]] bool operator==(const TraversalOptions&) const = default;
};

/// Options that have no effect beside `traversal`, in the order of the fields: `fast` has none of
/// them, `descent` and `order` are E-Node's, `ericson_rule` is that of `ericson`, `recursive` that
/// of the baselines (`a_first` to `larsson`) and of `e_node`.
[[nodiscard]] std::vector<IdleOption> idle_options(const TraversalOptions& options);

/// The same options, those that have no effect set to their defaults: what a traversal makes of
/// them.
[[nodiscard]] TraversalOptions without_idle(TraversalOptions options);

}  // namespace soms
