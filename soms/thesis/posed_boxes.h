/// \file
/// The boxes of a tree's nodes after its mesh was moved.
#pragma once

#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"
#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/traversal_options.h"
#include "soms/tree/tree.h"

#include <optional>
#include <vector>

namespace soms {

/// Moves the vertices of a mesh and the boxes of its tree; keeps its memory from pose to pose.
///
/// Every box holds the moved, rounded vertices (`Pose::apply`) of all triangles of its node.
/// - `refit`: exactly their bounds, leaves up. When the pose only shifts, each box is shifted: the
///   same numbers, since rounding is monotone (least of the rounded sums = rounded sum of the
///   least).
/// - `rebox`: bounds of the eight moved corners of the node's own box, one ulp wider on each side.
///   That holds all vertices for any pose, without an error bound: a moved coordinate is made of
///   rounded products and sums, each of them monotone in each operand, so over a box its least and
///   greatest *rounded* values are reached at corners. The ulp is the thesis design's.
///
/// Boxes of nodes without triangles stay empty.
/// \source thesis, fig. 4.13.
class PosedBoxes {
 public:
  /// Mesh and tree must outlive the object.
  PosedBoxes(const MeshView& mesh, const Tree& tree);

  /// Moves to a pose; nothing happens when pose and way are those of the last call.
  ///
  /// \pre     `check(pose)` and `check_range(pose, bounds(mesh))` pass.
  /// \cost    O(vertices + nodes).
  void move(const Pose& pose, BoxUpdate update = BoxUpdate::refit);

  /// Moved vertices, as many as the mesh has.
  [[nodiscard]] const std::vector<Vec3>& vertices() const { return vertices_; }

  /// Moved boxes, one a node.
  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }

  /// Moved corners of triangle `i`.
  [[nodiscard]] Triangle triangle(TriangleId i) const {
    const auto& t = mesh_.triangles[i];
    return {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
  }

  [[nodiscard]] PosedTree view() const { return {tree_, boxes_}; }

 private:
  void shift(const Vec3& by);
  void refit();
  void rebox(const Pose& pose);

  MeshView mesh_;
  const Tree* tree_;
  std::vector<Vec3> vertices_;
  std::vector<Box> boxes_;
  std::optional<Pose> pose_;
  BoxUpdate update_ = BoxUpdate::refit;
};

}  // namespace soms
