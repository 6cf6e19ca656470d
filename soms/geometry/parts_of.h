/// \file
/// The parts of many triangles, and where a part stands among the others.
#pragma once

#include "soms/geometry/part_runs.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soms {

/// The innermost part of each triangle of a mesh, as `part_of` says, found in logarithmic time. A
/// value of its own: the mesh may go, and parts that change afterwards need a new one.
///
/// \code
///   const soms::PartsOf parts(mesh);
///   const std::uint32_t part = parts(triangle);
///   if (part != soms::Part::kNoParent) {
///     std::cout << mesh.parts[part].name;
///   }
/// \endcode
class PartsOf {
 public:
  /// Of a mesh without parts.
  PartsOf() = default;

  /// \cost As `part_runs`; 16 bytes a run.
  explicit PartsOf(const MeshView& mesh);

  /// The part's index in `Mesh::parts`; Part::kNoParent where no part holds the triangle.
  /// \cost O(log p) for p parts.
  [[nodiscard]] std::uint32_t operator()(TriangleId triangle) const;

  [[nodiscard]] bool operator==(const PartsOf&) const = default;

 private:
  std::vector<PartRun> runs_;
};

/// Names of the parts around `part`, the outermost first, and its own name last; unnamed ones are
/// empty. Ends at a part that encloses itself, which no file that soms reads has.
/// \pre `part` < mesh.parts.size(), and parents exist, as `check` makes sure.
[[nodiscard]] std::vector<std::string> part_path(const MeshView& mesh, std::uint32_t part);

}  // namespace soms
