/// \file
/// How far do two convex parts go into each other?
///
/// \code
/// const soms::Mesh mesh = soms::generate_sphere(8);  // of radius 1, about the origin
/// const auto at = [&mesh](double z) {
///   const soms::Pose pose = soms::Pose::translation(0, 0, z);
///   return soms::ConvexPart::of(soms::part_bodies(mesh, pose).front());
/// };
/// const auto answer = soms::penetration(*at(0), *at(1.5));
/// std::cout << "to move by " << answer->depth << " along " << answer->direction << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// to move by 0.288675 along Vec3{-0.5773502691896258, -0.5773502691896258, 0.5773502691896258}
/// \endverbatim
#pragma once

#include "soms/base/vector.h"
#include "soms/clash/part_bodies.h"

#include <optional>
#include <vector>

namespace soms {

/// A translation that separates two parts.
struct Penetration {
  double depth = 0;     ///< its length, in the unit of the parts
  Vec3 direction = {};  ///< of length one: where the second part goes

  [[nodiscard]] bool operator==(const Penetration&) const = default;
};

/// A convex part, prepared for `penetration`.
class ConvexPart {
 public:
  /// Nothing for an open part, and for one that is not convex. A part is not convex if a vertex
  /// lies in front of a face by more than a millionth of the part's extent. So quads that are not
  /// quite plane do no harm.
  /// \cost O(f v) for f triangles and v vertices, less where a part is not convex.
  [[nodiscard]] static std::optional<ConvexPart> of(const PartBody& part);

  [[nodiscard]] const std::vector<Vec3>& corners() const { return corners_; }

  /// Directions across faces, of length one, each once.
  [[nodiscard]] const std::vector<Vec3>& normals() const { return normals_; }

  /// Directions along edges between faces that are not in one plane, of length one, each once.
  [[nodiscard]] const std::vector<Vec3>& edges() const { return edges_; }

 private:
  std::vector<Vec3> corners_;
  std::vector<Vec3> normals_;
  std::vector<Vec3> edges_;
};

/// The shortest translation of `b` after which no interior of the two is shared, by the axes that
/// can separate convex polyhedra. These are across each face, and across each pair of an edge of
/// `a` and an edge of `b`. After it they are separate for certain: rounding makes it longer by a
/// few 1e-15 of the extents. It may exceed the least one by about a millionth of the extents, where
/// faces or edges that are so nearly parallel count as one. Parts that are surely apart have depth
/// 0.
///
/// Nothing where the axes times the corners are more than `kMostPenetrationWork`: bodies with some
/// hundred edges each in directions of their own.
///
/// \source Gottschalk, Lin and Manocha 1996, OBBTree, section 5, for boxes; the same axes separate
///         convex polyhedra in general.
[[nodiscard]] std::optional<Penetration> penetration(const ConvexPart& a, const ConvexPart& b);

/// Products of an axis and a corner that `penetration` takes on, about 5 ms.
inline constexpr double kMostPenetrationWork = 4e6;

}  // namespace soms
