/// \file
/// The parts of many triangles.
#pragma once

#include "soms/geometry/part_runs.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soms::command {

/// The innermost part of each triangle of a mesh, as `part_of` says, found in logarithmic time.
class PartsOf {
 public:
  /// The mesh must stay. \cost As `part_runs`.
  explicit PartsOf(const Mesh& mesh);

  /// Part::kNoParent where no part holds the triangle.
  [[nodiscard]] std::uint32_t operator()(TriangleId triangle) const;

  /// The part's name in the file; empty where it has none.
  [[nodiscard]] std::string name(TriangleId triangle) const;

 private:
  const Mesh* mesh_;
  std::vector<PartRun> runs_;
};

}  // namespace soms::command
