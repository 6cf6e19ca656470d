/// \file
/// How an OBJ file names the parts of a mesh.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// A part's name, fit for the rest of a line.
[[nodiscard]] std::string line_name(std::string_view name);

/// Lines that stand before a triangle.
struct ObjGroupLines {
  std::size_t triangle = 0;
  std::string lines;

  [[nodiscard]] bool operator==(const ObjGroupLines&) const = default;
};

/// The lines of a mesh, and what became of the names.
struct ObjGroups {
  std::vector<ObjGroupLines> lines;  ///< by their triangles
  std::uint64_t renamed = 0;         ///< parts that have a number behind their name
};

/// Lines `o` and `g` by which the reader of OBJ finds the same parts: two parts stay two, and a
/// part of several runs stays one. Without nesting, and where names differ, parts are groups.
/// Else the outermost are objects, each with the parts within it as groups, however deep. If an
/// outermost part has several runs, no object can hold it, and all parts are groups. Groups whose
/// names an object, or the file, has twice are numbered.
/// \cost O(p log p) for p parts.
[[nodiscard]] ObjGroups obj_groups(const MeshView& mesh);

}  // namespace soms::detail
