/// \file
/// Bodies, trees and options that the tests of traversals share.
#pragma once

#include "soms/base/pose.h"
#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/traversal_options.h"
#include "soms/tree/tree.h"

#include "tests/support/support.h"

#include <string>
#include <vector>

namespace soms::test {

/// All traversals with all the options that mean something to them.
[[nodiscard]] std::vector<TraversalOptions> every_traversal_options();

/// A short name of options, for traces.
[[nodiscard]] std::string describe(const TraversalOptions& options);

/// Kinds of bodies of which overlaps go wrong.
enum class Kind { random, lattice, degenerate, nested, coincident };

inline constexpr std::array kKinds{Kind::random, Kind::lattice, Kind::degenerate, Kind::nested,
                                   Kind::coincident};

/// `count` triangles of a kind, of size about 1, in a cube of about 2. Lattice bodies touch in
/// faces, edges and corners when their poses are lattice poses.
[[nodiscard]] Mesh body(Rng& rng, Kind kind, std::size_t count);

/// A pose that suits a kind: rotations for random bodies, quarter turns and whole shifts for
/// lattices. Shifts up to `reach` along each axis.
[[nodiscard]] Pose pose(Rng& rng, Kind kind, double reach = 1);

/// A valid tree of a mesh split at random: unbalanced, with leaves of up to `per_leaf`, and here
/// and there a child without triangles.
[[nodiscard]] Tree random_tree(Rng& rng, const Mesh& mesh, std::size_t per_leaf);

/// All pairs of leaves whose boxes overlap, by trying all.
[[nodiscard]] std::vector<NodePair> overlapping_leaves(const PosedTree& a, const PosedTree& b);

/// Sorted by the first node, then the second.
[[nodiscard]] std::vector<NodePair> sorted(std::vector<NodePair> pairs);

}  // namespace soms::test
