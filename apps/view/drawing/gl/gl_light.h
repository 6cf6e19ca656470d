/// \file
/// Programs that shade. Private to the renderer.
#pragma once

#include "apps/view/drawing/gl/gl_objects.h"
#include "apps/view/drawing/gl/gl_view.h"

namespace soms::view {

class GlShadows;

/// A program whose fragment shader begins with `kLightHead`, and its twin for pictures without
/// shadows: drivers in software look shadows up before they find that there are none.
class GlLitProgram {
 public:
  GlLitProgram(const char* name, const char* vertex, const char* fragment);

  /// Makes the one for these shadows current, and gives it the light.
  [[nodiscard]] const GlProgram& use(const GlShadows& shadows, const GlView& view) const;

 private:
  GlProgram shadowed_;
  GlProgram unshadowed_;
};

}  // namespace soms::view
