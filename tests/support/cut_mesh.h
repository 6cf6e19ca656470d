/// \file
/// Meshes whose triangles are dealt out to parts.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace soms::test {

/// The mesh with its triangles in parts "p0", "p1", ...: triangle i in part label[i]. Parts without
/// triangles are there, too.
[[nodiscard]] inline Mesh cut_by(const Mesh& mesh, const std::vector<std::uint32_t>& label,
                                 std::uint32_t parts) {
  Mesh cut = mesh;
  cut.triangles.clear();
  cut.parts.clear();
  cut.faces.clear();
  for (std::uint32_t part = 0; part < parts; ++part) {
    const auto first = static_cast<std::uint32_t>(cut.triangles.size());
    for (std::size_t i = 0; i < label.size(); ++i) {
      if (label[i] == part) {
        cut.triangles.push_back(mesh.triangles[i]);
      }
    }
    cut.parts.push_back({.name = "p" + std::to_string(part),
                         .first = first,
                         .count = static_cast<std::uint32_t>(cut.triangles.size()) - first});
  }
  return cut;
}

}  // namespace soms::test
