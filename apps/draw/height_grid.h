/// \file
/// A city seen from above, on square cells: how high its top is, what lies there, where the ground
/// is.
#pragma once

#include "soms/base/box.h"
#include "soms/base/parallel.h"
#include "soms/geometry/mesh.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace soms::command {

/// What a triangle is, as far as the name of its part tells.
enum class Surface : std::uint8_t { nothing, ground, street, water, furniture, building };

/// Kind of surface from the name of a part; `building` unless a word of the name says otherwise.
[[nodiscard]] Surface surface_named(std::string_view name);

/// The least height above the ground of what maps draw as a building, in units of the model.
inline constexpr double kLeastBuilding = 2.5;

/// Tops of meshes by cells: a cell shows the highest triangle over its center.
class HeightGrid {
 public:
  /// Square cells over the ground plan of `area`, `cells` of them along its longer side.
  HeightGrid(const Box& area, std::size_t cells);

  /// \errors ErrorKind::cancelled.
  void add(const MeshView& mesh, const Limits& limits = {});

  /// Estimates the ground below every cell from the lowest vertices around it. Call it once, after
  /// the last `add`. \errors ErrorKind::cancelled.
  void find_ground(const Limits& limits = {});

  [[nodiscard]] std::size_t columns() const { return columns_; }

  [[nodiscard]] std::size_t rows() const { return rows_; }

  [[nodiscard]] double cell() const { return cell_; }

  [[nodiscard]] const Vec3& origin() const { return origin_; }

  [[nodiscard]] Surface surface(std::size_t column, std::size_t row) const {
    return surfaces_[row * columns_ + column];
  }

  /// Height of the top; meaningless where the surface is `nothing`.
  [[nodiscard]] double top(std::size_t column, std::size_t row) const {
    return tops_[row * columns_ + column];
  }

  /// Height of the top above the ground; 0 where there is nothing.
  [[nodiscard]] double height(std::size_t column, std::size_t row) const;

  /// Estimated ground at a point, inside the area or beside it.
  [[nodiscard]] double ground(double x, double y) const;

  /// True if the city has triangles around a point, within some tens of meters.
  [[nodiscard]] bool built_near(double x, double y) const;

  /// Height that a mover of half width `reach` can stand on at (x, y), or NaN where a building or
  /// anything higher than a step is in the way.
  [[nodiscard]] double standing(double x, double y, double reach) const;

 private:
  /// Returns how many cells it looked at.
  std::size_t add(const Triangle& triangle, Surface surface);
  void fill_unknown_tiles();
  [[nodiscard]] double tile_ground(std::ptrdiff_t column, std::ptrdiff_t row) const;

  Vec3 origin_;
  double cell_ = 1;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<double> tops_;
  std::vector<Surface> surfaces_;
  double tile_ = 1;  ///< side of the squares in which the ground is sought
  std::size_t tile_columns_ = 1;
  std::size_t tile_rows_ = 1;
  std::vector<std::pair<std::uint32_t, double>> lowest_;  ///< tile and height of every vertex
  std::vector<double> ground_;
  std::vector<std::uint8_t> known_;  ///< tiles with vertices enough
};

}  // namespace soms::command
