/// \file
/// Boxes of which each face is a part.
#pragma once

#include "tests/support/bodies.h"
#include "tests/support/cut_mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::test {

/// A box whose faces are parts "p0" to "p4": the walls, then the floor; and, with a lid, "p5".
[[nodiscard]] inline Mesh tray(const Vec3& lower, const Vec3& upper, bool lid = false) {
  Mesh box = box_body(lower, upper);
  const std::size_t each = box.triangles.size() / 6;
  const std::uint32_t faces = lid ? 6 : 5;
  box.triangles.resize(faces * each);
  std::vector<std::uint32_t> face_of(box.triangles.size());
  for (std::size_t i = 0; i < face_of.size(); ++i) {
    face_of[i] = static_cast<std::uint32_t>(i / each);
  }
  return cut_by(box, face_of, faces);
}

}  // namespace soms::test
