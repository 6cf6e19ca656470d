/// \file
/// Small hand-made sets of triangles that show what each splitting rule does, and where it fails.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/build_options.h"

#include <cstddef>
#include <string>
#include <vector>

namespace soms::reproduce {

/// A few triangles and what they are to show.
struct ToySet {
  std::string name;   ///< snake_case, as in tables
  std::string title;  ///< for people
  Mesh mesh;
  bool unlike = false;  ///< whether its triangles are of unlike size
};

/// Sets in the plane z = 0: triangles alike, one that is much larger than the others, each twice as
/// large as the one before, midpoints that all agree, midpoints that agree on the longest axis of
/// the outer box.
[[nodiscard]] std::vector<ToySet> flat_toy_sets();

/// Fifteen small triangles and a large one, in the plane z = 0; the midpoints are a regular grid.
[[nodiscard]] ToySet grid_toy_set();

/// Small houses on a large ground triangle, z up.
[[nodiscard]] ToySet solid_toy_set();

/// Four triangles in space, z up.
[[nodiscard]] ToySet space_toy_set();

/// Eight triangles alike in two rows, in the plane z = 0: SOMS halves them three times.
[[nodiscard]] ToySet eight_toy_set();

/// Triangles alike and small, parallel to the plane z = 0, with these midpoints.
[[nodiscard]] Mesh triangles_at(const std::vector<Vec3>& midpoints);

/// Some triangles of a mesh, in the order of `which`, with all of its vertices.
[[nodiscard]] Mesh some_of(const Mesh& mesh, const std::vector<TriangleId>& which);

/// A rule at work on all triangles of a mesh.
struct ToySplit {
  std::vector<Vec3> midpoints;  ///< of each triangle, as in the thesis
  Box inner;
  Box outer;
  std::size_t axis = 0;
  double plane = 0;             ///< what lies below on the axis goes left
  std::vector<bool> left = {};  ///< for each triangle
  std::size_t left_count = 0;

  /// Whether both sides have triangles.
  [[nodiscard]] bool divides() const { return left_count > 0 && left_count < left.size(); }
};

/// Divides a mesh as the root of a tree with `thesis_options(rule)`. \pre two triangles or more.
[[nodiscard]] ToySplit split_toy(const Mesh& mesh, Rule rule);

}  // namespace soms::reproduce
