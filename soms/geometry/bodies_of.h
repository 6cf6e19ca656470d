/// \file
/// Which parts of a mesh are one body: a file may cut a closed solid into groups, materials or
/// faces.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace soms {

/// Parts of a mesh that are one body, as far as anybody can tell.
struct PartGroup {
  /// The parts that are the innermost of its triangles (as PartsOf has it), ascending;
  /// Part::kNoParent, for the triangles that no part holds, last.
  std::vector<std::uint32_t> parts = {};
  /// The parts are closed: the only one alone, or several that close each other.
  bool closed = false;

  [[nodiscard]] bool operator==(const PartGroup&) const = default;
};

/// The bodies of a mesh: each part that is the innermost of a triangle is in one group.
///
/// A part that is closed alone, as `closedness` decides it, is a body. Open parts close each other
/// where their odd edges cover each line evenly together, exactly, so T-junctions count. Such parts
/// are one body where there is no choice: none of them is in another least set of parts that is
/// closed. What one object holds is looked at first, the innermost object first; what is open there
/// may be closed by parts of others. Where two sets could be meant, as of two solids that meet in
/// one edge and are cut there, no group is called closed.
///
/// Parts that stay open are a group where stretches of their odd edges coincide: nobody knows what
/// they enclose together. On a line, only stretches that hang together by common ends are compared.
///
/// Decided for vertices as they are; a pose may open a T-junction, as `closedness` says.
/// \pre     `check(mesh)` passes.
/// \errors  ErrorKind::cancelled.
/// \cost    O(n log n) time for n triangles where there are several parts; 24 bytes an edge.
[[nodiscard]] std::vector<PartGroup> bodies_of(const MeshView& mesh, const Limits& limits = {});

}  // namespace soms
