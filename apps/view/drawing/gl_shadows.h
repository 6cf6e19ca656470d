/// \file
/// Maps of what the sun sees first. Private to the renderer.
#pragma once

#include "apps/view/drawing/gl_objects.h"
#include "apps/view/drawing/gl_surfaces.h"
#include "apps/view/drawing/gl_view.h"
#include "apps/view/drawing/sun_maps.h"

#include <array>
#include <cstdint>

namespace soms::view {

class GlShadows {
 public:
  explicit GlShadows(DepthMode mode);
  ~GlShadows();
  GlShadows(const GlShadows&) = delete;
  GlShadows& operator=(const GlShadows&) = delete;

  /// Draws the maps of what `surfaces` shows; without `drawn` the sun is seen everywhere. Leaves
  /// another frame buffer, viewport and depth test behind.
  void draw(const DrawList& list, const Camera& camera, const GlView& view, bool drawn,
            GlSurfaces& surfaces, GlSlicer& slicer, DrawStatistics& statistics);

  /// True where `draw` drew any.
  [[nodiscard]] bool drawn() const { return drawn_; }

  /// Gives the light to a program that begins with `kLightHead`, and binds the maps.
  void light(const GlProgram& program, const GlView& view) const;

 private:
  DepthMode mode_;
  GlProgram program_;
  std::array<SunMap, 2> maps_{};
  bool drawn_ = false;
  std::uint32_t texture_ = 0;
  std::uint32_t frame_ = 0;
};

}  // namespace soms::view
