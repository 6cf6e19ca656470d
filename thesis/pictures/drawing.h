/// \file
/// Pictures of meshes and boxes: the panels of one drawing are seen from one side.
#pragma once

#include "soms/base/box.h"
#include "soms/geometry/mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace soms::reproduce {

/// Colors of drawn things: those of charts (0 and up, `series_color`), and two more.
inline constexpr int kClay = -1;       ///< a mesh as such
inline constexpr int kHighlight = -2;  ///< what the picture is about: red

/// Where the reader looks from. Parallel projection.
struct View {
  Vec3 toward;  ///< from the eye into the picture, any length
  Vec3 up;      ///< upwards on the page; not along `toward`
};

/// From above, before and beside.
[[nodiscard]] View axonometric(UpAxis up);

/// Onto the plane of x and y, for sets of two dimensions.
[[nodiscard]] View flat_view();

/// A mesh, moved by `shift`.
struct DrawnMesh {
  const Mesh* mesh = nullptr;  ///< outlives the drawing
  Vec3 shift = {};
  int color = kClay;
  std::vector<int> colors = {};  ///< a color for each triangle; empty: all have `color`
};

/// The edges of a box.
struct DrawnBox {
  Box box;
  int color = 0;
  bool dashed = false;
};

/// A dot.
struct DrawnPoint {
  Vec3 at;
  int color = 0;
};

/// The part within a box of the plane where coordinate `axis` is `value`.
struct DrawnPlane {
  std::size_t axis = 0;
  double value = 0;
  Box within;
  int color = 0;
};

/// A picture with words above and below.
struct Panel {
  std::string title = {};
  std::string note = {};
  std::vector<DrawnMesh> meshes = {};
  std::vector<DrawnBox> boxes = {};
  std::vector<DrawnPoint> points = {};
  std::vector<DrawnPlane> planes = {};
};

/// What an entry of the legend stands for.
enum class KeyKind { fill, box, dashed_box, plane, point };

/// An entry of the legend.
struct Key {
  KeyKind kind = KeyKind::fill;
  int color = 0;
  std::string words;
};

/// Panels side by side, in rows.
struct Drawing {
  std::string title = {};
  View view = {};
  int columns = 2;
  bool same_scale = true;  ///< else each panel's picture is as large as fits
  std::vector<Key> keys = {};
  std::vector<Panel> panels = {};
  /// Bytes that the SVG should not pass. What is hidden is never written; where that is not enough
  /// the triangles that show least are left out, and the drawing says how many.
  std::size_t budget = 400'000;
};

/// Hidden surfaces by painter's order; triangles shaded; boxes as lines above them, far ones
/// fainter.
[[nodiscard]] std::string draw(const Drawing& drawing);

}  // namespace soms::reproduce
