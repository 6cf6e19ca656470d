/// \file
/// What is added to surfaces once their depths are known: the sky that is hidden by what is near,
/// and the color about contacts. Private to the renderer.
#pragma once

#include "apps/view/drawing/gl/gl_layer.h"
#include "apps/view/drawing/gl/gl_objects.h"
#include "apps/view/drawing/gl/gl_slicer.h"
#include "apps/view/drawing/gl/gl_target.h"
#include "apps/view/drawing/gl/gl_view.h"
#include "apps/view/drawing/renderer.h"

namespace soms::view {

class GlFinish {
 public:
  GlFinish();

  /// Draws over what the target holds; with `relief` the hidden sky, too. Does nothing without
  /// relief and glows. \errors ErrorKind::cancelled.
  void draw(const DrawList& list, const GlView& view, Size size, bool relief, GlTarget& target,
            GlSlicer& slicer, DrawStatistics& statistics);

 private:
  void draw_ambient(const GlView& view, Size size, unsigned depths, GlSlicer& slicer,
                    DrawStatistics& statistics);
  void draw_glows(const DrawList& list, const GlView& view, Size size, unsigned depths,
                  DrawStatistics& statistics);

  GlProgram ambient_program_;
  GlProgram glow_program_;
  GlProgram finish_program_;
  GlLayer open_;
  GlLayer near_;
  GlBuffer glows_;
  GlVertexArray glows_reading_;
  GlVertexArray nothing_;
};

}  // namespace soms::view
