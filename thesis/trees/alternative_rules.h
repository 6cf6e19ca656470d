/// \file
/// Rules that SOMS might have been, if its captions are read otherwise.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/rule/split.h"
#include "soms/tree/tree.h"

#include <cstddef>
#include <span>

namespace soms::reproduce {

/// The plane halfway between the two midpoints in the middle of their order on the axis: "the
/// Spatial Midpoint between Midpoints of Two Triangles", the two being those around the object
/// median. If the lower one is also the least of all, the plane is at the next greater midpoint.
/// Fails only where all midpoints agree on the axis. For `build_by` with the axis of the inner box.
/// \source thesis, figure 4.6 by its caption.
[[nodiscard]] Split middle_pair(const SplitNode& node, std::size_t axis);

/// Spatial median, and SOMS on the longest axis of the inner box where spatial median leaves a side
/// empty. For `build_by` with the axis of the outer box. Fails only where all midpoints are equal.
/// \source thesis, chapter 1: others continue by a heuristic where the first rule stops.
[[nodiscard]] Split spatial_then_soms(const SplitNode& node, std::size_t axis);

/// The plane halfway between the midpoints of two triangles: the one that holds the least corner on
/// the axis and the one that holds the greatest, of equal corners the first in file order. The axis
/// is the longest of the box of the midpoints. Either side may be empty, even where midpoints
/// differ. \pre There is a triangle.
/// \source  thesis, figures 4.4 ("Minimum and Maximum points") and 4.6 by their captions.
[[nodiscard]] Split corner_pair(const Mesh& mesh, std::span<const TriangleId> triangles);

/// The tree of `level` by `corner_pair`. A rule of the library does not see corners, so the tree is
/// made here. A node of which one side would be empty stays whole.
[[nodiscard]] Tree corner_pair_tree(const Mesh& mesh, int level);

}  // namespace soms::reproduce
