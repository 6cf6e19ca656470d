/// \file
/// The triangles of a body whose boxes meet a box in the world: none is lost.
///
/// A point of a lane lies at x = O + o + Q b / s in the mesh, exactly, with O, o the origins of the
/// tree and the node, Q the node's axes, b in the lane's box c +- h and s the layout's scale
/// (wide_tree.h). Moved and rounded it is off R x + t by 4.01 u64 V (parity_frame.h, also for V).
/// Computed in double are R (O + o) + t, (R Q) c / s and |R Q| h / s. Each is a sum of at most four
/// terms of at most 3.5 V after a product of three, so each is off by less than 3.01 * 3.5 + 4
/// * 3.5 < 25 u64 V on an axis, together 75, and comparing two sums adds 2 * 3.5: below 128 u64 V.
///
/// Beside a triangle, in the mesh. If two triangles share a point where they were moved and
/// rounded, points of theirs in the mesh, at the same barycentric coordinates, are moved by R to
/// within 2 * 4.01 u64 V on each axis: to a vector of a length below 2 * 4.01 * 1.7321 < 14 u64 V.
/// A legal R shortens no vector by more than 2e-6 of it, so the points are less than 15 u64 V from
/// each other, and so are the boxes of the two. That a box of a node may seem elsewhere costs the
/// 75 + 7 above, with the identity as R: with those 15 below 128 u64 V, since no coordinate of the
/// mesh exceeds 3.5 V. Corners that a block stores are off by 3.47 and 6.94 u64 V, as
/// parity_frame.h counts, and by 2^-24 of themselves, which are not longer than the block's radius
/// r. A bound beyond 2 r parts all or nothing; another one is rounded to a float by 2^-23 r at
/// most, after two sums (4 * 3.5 u64 V) and a comparison (2 * 3.5): in doubt by less than 128 u64 V
/// + 2^-22 r, and 2^-140 for floats that underflow. Doubles that do lose 2^-1075 each: 2^-1060.
#pragma once

#include "soms/base/box.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/relative_pose.h"

#include <cstdint>
#include <variant>
#include <vector>

namespace soms::detail {

/// A triangle of a body, moved and rounded.
struct MovedTriangle {
  TriangleId id;
  Triangle triangle;
};

/// Finds triangles of one body. Refers to the body. \pre Its pose passed its checks.
class BoxSearch {
 public:
  explicit BoxSearch(const Body& body);

  /// All triangles whose boxes, moved, share a point with `box`, in place of what `found` held. The
  /// order depends on the tree.
  void find(const Box& box, std::vector<MovedTriangle>& found, Cost& cost);

  /// All triangles that, moved, share a point with triangle `id`, and some of those near it; it is
  /// one of them. \cost Less than that of `find` in the world: the boxes of the tree are not
  /// turned.
  void find_beside(TriangleId id, std::vector<MovedTriangle>& found, Cost& cost);

  [[nodiscard]] Triangle moved(TriangleId id) const;

 private:
  /// Where a search takes place.
  struct Place {
    Pose pose;  // of the mesh
    Matrix3 rotation;
    bool turned;
  };

  void search(const Place& place, const Box& box, std::vector<MovedTriangle>& found, Cost& cost);

  template <class Source>
  void search(Source& source, const Place& place, const Box& box, std::vector<MovedTriangle>& found,
              Cost& cost);

  /// Triangles of a block whose boxes in the world meet the box.
  void add_exactly(const TriangleBlock& block, const Box& box,
                   std::vector<MovedTriangle>& found) const;

  /// All whose boxes in the mesh meet the box, and some of those near it.
  void add_near(const TriangleBlock& block, const Box& box,
                std::vector<MovedTriangle>& found) const;

  /// Lanes of a node whose boxes may meet the box.
  [[nodiscard]] std::uint32_t lanes(const WideNode& node, const Place& place, const Box& box) const;

  const Body& body_;
  Place world_;
  Vec3 origin_;  // of the tree
  double rounding_;
  double unit_;  // of the layout, in the mesh's
  std::variant<WideSource, CompactSource> source_;
  std::vector<std::uint32_t> stack_;
};

}  // namespace soms::detail
