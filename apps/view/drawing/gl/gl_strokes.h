/// \file
/// Lines and points. Private to the renderer.
#pragma once

#include "apps/view/drawing/gl/gl_objects.h"
#include "apps/view/drawing/gl/gl_view.h"
#include "apps/view/drawing/renderer.h"

namespace soms::view {

/// Lines and points, whose widths are in pixels.
class GlStrokes {
 public:
  GlStrokes();

  /// Those on top or those that surfaces may hide; one draw call each for lines and points.
  void draw(const DrawList& list, const GlView& view, bool on_top, DrawStatistics& statistics);

 private:
  void draw_lines(const DrawList& list, const GlView& view, bool on_top,
                  DrawStatistics& statistics);
  void draw_points(const DrawList& list, const GlView& view, bool on_top,
                   DrawStatistics& statistics);

  GlProgram line_program_;
  GlProgram point_program_;
  GlBuffer lines_;
  GlBuffer points_;
  GlVertexArray lines_reading_;
  GlVertexArray points_reading_;
};

}  // namespace soms::view
