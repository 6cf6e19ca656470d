/// \file
/// Nearest points of a model, and lists of near triangles, as text.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/query/closest.h"
#include "soms/query/contains.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace soms::command {

/// A triangle in the list of a point.
struct ListedTriangle {
  TriangleId triangle = 0;
  Bracket distance;
};

/// An answer as a sentence about the only point, without a line break. `at_most` is the limit of
/// the question.
[[nodiscard]] std::string point_text(const Closest& answer, std::optional<Side> side,
                                     const MeshView& mesh, double at_most);
[[nodiscard]] std::string list_text(std::span<const ListedTriangle> hits, bool cut,
                                    const MeshView& mesh);

/// Titles of the table of many points for people, and the row of one.
[[nodiscard]] std::string point_head(bool sides);
[[nodiscard]] std::string point_row(std::uint64_t point, const Closest& answer,
                                    std::optional<Side> side, const MeshView& mesh, double at_most,
                                    int digits);
[[nodiscard]] std::string list_head();
[[nodiscard]] std::string list_row(std::uint64_t point, std::span<const ListedTriangle> hits,
                                   bool cut, const MeshView& mesh, int digits);

}  // namespace soms::command
