/// \file
/// Labels of a draw list. Private to the renderer.
#pragma once

#include "apps/view/drawing/gl_objects.h"
#include "apps/view/drawing/gl_view.h"
#include "apps/view/drawing/renderer.h"

namespace soms::view {

/// Letters as strokes, each a rectangle that holds a round pen's path.
class GlLabels {
 public:
  GlLabels();

  /// Writes those labels that have room, in one draw call.
  void draw(const DrawList& list, const Camera& camera, Size size, DrawStatistics& statistics);

 private:
  GlProgram program_;
  GlBuffer strokes_;
  GlVertexArray reading_;
};

}  // namespace soms::view
