/// \file
/// Maps of what the sun sees first. Private to the renderer.
#pragma once

#include "apps/view/drawing/gl/gl_objects.h"
#include "apps/view/drawing/gl/gl_surfaces.h"
#include "apps/view/drawing/gl/gl_view.h"
#include "apps/view/drawing/sun_maps.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace soms::view {

class GlShadows {
 public:
  explicit GlShadows(DepthMode mode);
  ~GlShadows();
  GlShadows(const GlShadows&) = delete;
  GlShadows& operator=(const GlShadows&) = delete;

  /// Draws the maps of what `surfaces` shows; without `drawn` the sun is seen everywhere. A map is
  /// kept while what casts, the sun and the ball stay: a camera that turns about its target needs
  /// no new one. Leaves another frame buffer, viewport and depth test behind.
  void draw(const DrawList& list, const Camera& camera, const GlView& view, bool drawn,
            GlSurfaces& surfaces, GlSlicer& slicer, DrawStatistics& statistics);

  /// True where `draw` drew any.
  [[nodiscard]] bool drawn() const { return drawn_; }

  /// Gives the light to a program that begins with `kLightHead`, and binds the maps.
  void light(const GlProgram& program, const GlView& view) const;

 private:
  /// What throws a shadow.
  struct Caster {
    std::uint64_t mesh = 0;
    std::uint64_t version = 0;
    Pose pose;
    bool solid = true;

    [[nodiscard]] bool operator==(const Caster&) const = default;
  };

  [[nodiscard]] static std::vector<Caster> casters_of(const DrawList& list);
  void draw_map(std::size_t layer, const DrawList& list, const GlView& view, GlSurfaces& surfaces,
                GlSlicer& slicer, DrawStatistics& statistics);

  DepthMode mode_;
  GlProgram program_;
  std::vector<Caster> casters_;                ///< of the maps that are kept
  Vec3 toward_;                                ///< likewise
  std::array<std::optional<SunMap>, 2> kept_;  ///< that were drawn to their end
  std::array<SunMap, 2> maps_{};
  bool drawn_ = false;
  std::uint32_t texture_ = 0;
  std::uint32_t frame_ = 0;
};

}  // namespace soms::view
