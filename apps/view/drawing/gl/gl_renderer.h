/// \file
/// The renderer on OpenGL 3.3 core.
#pragma once

#include "soms/base/parallel.h"

#include "apps/view/drawing/cut_meshes.h"
#include "apps/view/drawing/renderer.h"

#include <memory>
#include <string>

namespace soms::view {

/// Draws with the context that is current in its thread, which must outlive it. Positions go to the
/// device relative to the eye, as floats; the differences are made in double, so pictures at map
/// coordinates are those at the origin. Draw calls: at most 128 a mesh and pass (two more for
/// shadows), two a box group, and twelve.
class GlRenderer final : public Renderer {
 public:
  /// \pre A context is current.
  /// \errors ErrorKind::cannot_write where it offers less than OpenGL 3.3; ErrorKind::unsupported
  ///         where its compiler refuses the shaders.
  GlRenderer();
  ~GlRenderer() override;

  void draw(const DrawList& list, const Camera& camera, Size size,
            const DrawOptions& options = {}) override;
  /// Takes tiles of meshes that will be drawn, which `draw` then need not cut.
  void take(CutMeshes cut);

  /// Draws and reads in parts from here on, between which stop requests are checked and the share
  /// done is reported. \errors Of `draw` and `read_pixels` then: ErrorKind::cancelled.
  void watch(const Limits& limits);
  void present() override;
  [[nodiscard]] Picture read_pixels() override;
  [[nodiscard]] DrawStatistics statistics() const override;

  /// Waits until the device has drawn everything so far.
  static void finish();

  /// The device and its driver, in their own words.
  [[nodiscard]] static std::string device();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace soms::view
