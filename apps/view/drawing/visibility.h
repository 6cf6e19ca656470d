/// \file
/// Which tiles of which instances are drawn, and how much of each.
#pragma once

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"
#include "apps/view/drawing/tiles.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace soms::view {

/// The half spaces that a camera sees, through the eye. There is no far plane.
struct Frustum {
  Vec3 eye;
  Vec3 forward;
  std::array<Vec3, 4> inward;  ///< normals of the four sides, pointing inside
};

[[nodiscard]] Frustum frustum(const Camera& camera, Size size);

/// False only if no point of the box can be seen.
[[nodiscard]] bool sees(const Frustum& f, const Box& box);

/// In which pass an instance is drawn.
enum class Pass : std::uint8_t { solid, wire, translucent };

[[nodiscard]] Pass pass_of(const Instance& instance);

/// How much of a tile is drawn.
enum class TileForm : std::uint8_t { least, stand_in, whole };

/// One tile and those instances in which it is drawn alike: one draw call.
struct TileGroup {
  std::uint32_t mesh = 0;
  std::uint32_t tile = 0;
  Pass pass = Pass::solid;
  bool edges = false;  ///< drawn once more, as edges
  std::vector<std::uint32_t> instances;
  std::uint32_t triangles = 0;  ///< how many of the form, the large ones first
  TileForm form = TileForm::whole;
  double depth = 0;  ///< of the nearest instance
};

struct Visible {
  std::vector<TileGroup> groups;  ///< by pass, then from near to far
  std::uint64_t tiles = 0;        ///< of all instances
  std::uint64_t tiles_drawn = 0;
  std::uint64_t triangles = 0;       ///< drawn
  std::uint64_t triangles_left = 0;  ///< seen, and left out to stay within `most_triangles`
};

/// A tile that looks smaller than this across, in pixels, is drawn by its coarsest copy in any
/// case: of a car that far off nobody sees the wheels, but the driver counts their triangles.
inline constexpr double kSpeck = 2;

/// Instances that look smaller than this across, in pixels, become coarse before larger ones of the
/// same mesh.
inline constexpr double kSmallInstance = 40;

/// The triangles of a tile in a form: the first, and how many; of `whole` where it has no copy.
struct TileRun {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

[[nodiscard]] TileRun run_of(const Tile& tile, TileForm form);

/// Chooses what is drawn. Where more triangles are seen than `most_triangles`, each tile gives up
/// its small ones, the more the smaller the tile looks. Where far more are seen, tiles are drawn by
/// their coarsest copies; those that look large for their triangles by stand-ins, and then whole,
/// as far as that goes, and what is near in any case, within half as many more. No tile with a copy
/// is left out, even where the copies alone are too many.
///
/// \shape `tiles`: those of each mesh of the list.
[[nodiscard]] Visible choose_tiles(const DrawList& list,
                                   std::span<const std::span<const Tile>> tiles,
                                   const Camera& camera, Size size, std::uint64_t most_triangles);

/// All opaque tiles of which `reaches` holds, whether the camera sees them or not, by mesh and
/// tile; those whose diagonal is below `speck` by their stand-ins.
[[nodiscard]] std::vector<TileGroup> choose_casters(const DrawList& list,
                                                    std::span<const std::span<const Tile>> tiles,
                                                    const std::function<bool(const Box&)>& reaches,
                                                    double speck = 0);

}  // namespace soms::view
