/// \file
/// Labels, markers and captions of a draw list. Private to the renderer.
#pragma once

#include "apps/view/drawing/gl/gl_objects.h"
#include "apps/view/drawing/gl/gl_view.h"
#include "apps/view/drawing/renderer.h"

namespace soms::view {

/// Letters and signs as strokes, each a rectangle that holds a round pen's path.
class GlLabels {
 public:
  GlLabels();

  /// Draws what `overlay.h` makes, in one draw call. A point has `density` pixels.
  void draw(const DrawList& list, const Camera& camera, Size size, double density,
            DrawStatistics& statistics);

 private:
  GlProgram program_;
  GlBuffer strokes_;
  GlVertexArray reading_;
};

}  // namespace soms::view
