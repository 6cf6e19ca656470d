/// \file
/// Meshes on the device and the passes that draw their instances. Private to the renderer.
#pragma once

#include "apps/view/drawing/cut_meshes.h"
#include "apps/view/drawing/gl/gl_light.h"
#include "apps/view/drawing/gl/gl_objects.h"
#include "apps/view/drawing/gl/gl_slicer.h"
#include "apps/view/drawing/gl/gl_view.h"
#include "apps/view/drawing/renderer.h"
#include "apps/view/drawing/tiles.h"
#include "apps/view/drawing/visibility.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace soms::view {

class GlShadows;

class GlSurfaces {
 public:
  GlSurfaces();

  /// Takes tiles of meshes that `bring` will bring.
  void take(CutMeshes cut) { cut_ = std::move(cut); }

  /// Brings new and changed meshes to the device and drops those that the list no longer names.
  /// \errors ErrorKind::out_of_memory; ErrorKind::cancelled.
  void bring(const DrawList& list, const GlSlicer& slicer, DrawStatistics& statistics);

  /// Bounds of all instances. \pre After `bring`.
  [[nodiscard]] Box bounds(const DrawList& list) const;

  /// Chooses what is drawn and places it. \pre After `bring`.
  void choose(const DrawList& list, const Camera& camera, Size size, const GlView& view,
              const DrawOptions& options, DrawStatistics& statistics);

  /// Draws the opaque tiles of which `reaches` holds by the program in use, which has the inputs of
  /// `kSurfaceVertex`, small ones as `choose_casters` does. \pre After `bring`; `choose` comes
  /// later.
  void cast(const DrawList& list, const GlView& view,
            const std::function<bool(const Box&)>& reaches, double speck, GlSlicer& slicer,
            DrawStatistics& statistics);

  /// Opaque faces, then edges of triangles.
  void draw_solid(const GlView& view, const GlShadows& shadows, GlSlicer& slicer,
                  DrawStatistics& statistics) const;

  /// Translucent faces: of each pixel the nearest one only, so that a hull looks like glass.
  void draw_translucent(const GlView& view, const GlShadows& shadows, GlSlicer& slicer,
                        DrawStatistics& statistics) const;

  /// Marked triangles, those on top or those that surfaces may hide.
  void draw_marks(const DrawList& list, const GlView& view, const GlShadows& shadows, bool on_top,
                  GlSlicer& slicer, DrawStatistics& statistics) const;

 private:
  struct OnDevice {
    std::uint64_t version = 0;
    bool filled = false;
    GlBuffer vertices;
    GlBuffer indices;
    GlVertexArray reading;
    std::vector<Tile> tiles;
  };

  /// What one row of an instance takes.
  struct Row {
    std::array<float, 12> rows;
    Color tint;
    float plain;
    float brighter;
  };

  /// A draw call to come.
  struct Call {
    const OnDevice* mesh;
    Pass pass;
    bool edges;  ///< drawn once more, as edges
    std::uint32_t first;
    std::uint32_t triangles;
    std::size_t row;
    std::size_t copies;
  };

  void upload(const DrawMesh& mesh, OnDevice& place, const GlSlicer& slicer);
  [[nodiscard]] std::vector<std::span<const Tile>> tiles() const;
  void place(const DrawList& list, const GlView& view, std::span<const TileGroup> groups);
  void begin(const GlView& view, const GlShadows& shadows, float flatness, float shade,
             float lift) const;
  void issue(const Call& call, GlSlicer& slicer, DrawStatistics& statistics) const;

  GlLitProgram program_;
  CutMeshes cut_;                    ///< still to be brought
  std::array<float, 4> focus_ = {};  ///< of the list: a place relative to the eye, and a radius
  std::map<std::uint64_t, OnDevice> meshes_;
  std::vector<const OnDevice*> of_list_;  ///< of each mesh of the list
  GlBuffer rows_;
  std::vector<Call> calls_;
  mutable GlBuffer marks_;
  GlVertexArray marks_reading_;
};

}  // namespace soms::view
