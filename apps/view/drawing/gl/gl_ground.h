/// \file
/// The ground of a draw list. Private to the renderer.
#pragma once

#include "apps/view/drawing/gl/gl_light.h"
#include "apps/view/drawing/gl/gl_objects.h"
#include "apps/view/drawing/gl/gl_shadows.h"
#include "apps/view/drawing/gl/gl_view.h"
#include "apps/view/drawing/renderer.h"

namespace soms::view {

class GlGround {
 public:
  GlGround();

  /// Draws the disc, if there is one and the eye is above it.
  void draw(const DrawList& list, const GlView& view, const GlShadows& shadows,
            DrawStatistics& statistics) const;

 private:
  GlLitProgram program_;
  GlVertexArray nothing_;
};

}  // namespace soms::view
