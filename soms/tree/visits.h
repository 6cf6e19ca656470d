/// \file
/// How much of a tree an overlap query looks at: counted for one box, expected for random ones.
#pragma once

#include "soms/base/box.h"
#include "soms/tree/tree.h"

#include <cstdint>

namespace soms {

/// What a query of one box looks at.
struct Visits {
  std::uint64_t nodes = 0;      ///< nodes whose box overlaps the query, leaves included
  std::uint64_t leaves = 0;     ///< of these, leaves
  std::uint64_t triangles = 0;  ///< triangles in those leaves: what is left to decide

  [[nodiscard]] bool operator==(const Visits&) const = default;
};

/// What a random query looks at on average.
struct ExpectedVisits {
  double nodes = 0;
  double leaves = 0;
  double triangles = 0;

  [[nodiscard]] bool operator==(const ExpectedVisits&) const = default;
};

/// Descends from the root into each node whose box overlaps `query`; touching counts.
/// \cost  The nodes visited and their children; no recursion.
[[nodiscard]] Visits count_visits(const Tree& tree, const Box& query);

/// Mean of `count_visits` over all boxes with sides `size` that overlap the root's box, placed
/// evenly: a node counts with the volume of its box grown by `size`, divided by that of the root's
/// box grown likewise. 0 for an empty tree.
///
/// With size 0 it is the share of volumes (points); for growing sizes it tends to all nodes. On an
/// axis where both the root and `size` have no extent every box overlaps.
///
/// \errors  ErrorKind::usage unless `size` is finite and not negative.
/// \cost    O(nodes).
/// \source  The surface area heuristic (Goldsmith and Salmon 1987) with the measure of boxes, not
///          of rays: Minkowski sums, as for R-trees in Pagel et al. 1993, Toward an analysis of
///          range query performance in spatial data structures.
[[nodiscard]] ExpectedVisits expected_visits(const Tree& tree, const Vec3& size);

}  // namespace soms
