/// \file
/// Open parts that close each other, or may.
#pragma once

#include "soms/geometry/bodies_of.h"
#include "soms/geometry/detail/parts/odd_edges.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// A part that is open alone.
struct OpenPart {
  std::uint32_t part = Part::kNoParent;
  std::vector<Segment> edges = {};  ///< used by an odd number of its triangles, each of two places
};

/// The groups of `bodies_of` that open parts are in, by their first parts.
/// \pre  Each part is named once, Part::kNoParent last.
/// \cost O(k log k) exact comparisons for k edges, as a rule.
[[nodiscard]] std::vector<PartGroup> groups_of_open(const MeshView& mesh,
                                                    std::span<const OpenPart> parts);

}  // namespace soms::detail
