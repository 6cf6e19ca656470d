/// \file
/// A value from 0 to 1 for each pixel of a picture, on the device. Private to the renderer.
#pragma once

#include "apps/view/drawing/camera.h"

namespace soms::view {

class GlLayer {
 public:
  GlLayer() = default;
  ~GlLayer();
  GlLayer(const GlLayer&) = delete;
  GlLayer& operator=(const GlLayer&) = delete;

  /// Draws go into it from here on, from 0 everywhere.
  void begin(Size size);

  [[nodiscard]] unsigned texture() const { return texture_; }

 private:
  Size size_{0, 0};
  unsigned texture_ = 0;
  unsigned frame_ = 0;
};

}  // namespace soms::view
