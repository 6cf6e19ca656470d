/// \file
/// Bounding volumes of 3D Tiles: where a tile says that its content lies.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/affine.h"
#include "soms/io/detail/json_document.h"

#include <array>
#include <cstdint>
#include <optional>

namespace soms::detail {

/// A region of the Earth, a box or a sphere.
class TileVolume {
 public:
  /// `stated`: the "boundingVolume" of a tile or a content; `frame`: from the axes of the tile to
  /// those of the mesh, which move boxes and spheres, not regions. Of several the first of region,
  /// box and sphere counts; one of an extension alone is none.
  /// \errors ErrorKind::bad_file: too few or too many numbers, a negative size.
  [[nodiscard]] static std::optional<TileVolume> read(const JsonValue& stated, const Affine& frame);

  [[nodiscard]] bool is_region() const { return kind_ == Kind::region; }

  /// True for points in it, or beside it by at most 1/10,000 of its size: by the rounding of
  /// vertices to floats.
  [[nodiscard]] bool contains(const Vec3& point) const;

 private:
  enum class Kind { region, box, sphere };

  [[nodiscard]] static TileVolume region(const JsonValue& list);
  [[nodiscard]] static TileVolume box(const JsonValue& list, const Affine& frame);
  [[nodiscard]] static TileVolume sphere(const JsonValue& list, const Affine& frame);
  [[nodiscard]] bool region_contains(const Vec3& point) const;
  [[nodiscard]] bool box_contains(const Vec3& point) const;

  Kind kind_ = Kind::region;
  std::array<double, 6> region_{};  ///< west, south, east, north, lowest, highest
  Vec3 center_;
  std::array<Vec3, 3> axes_;   ///< of a box: from its center to the middles of its sides
  std::array<Vec3, 3> duals_;  ///< which give the shares of the axes in a vector
  double radius_ = 0;
  double slack_ = 0;  ///< meters
};

/// Corners of the mesh, each once, that lie outside of a volume.
[[nodiscard]] std::uint64_t count_outside(const MeshView& mesh, const TileVolume& volume);

}  // namespace soms::detail
