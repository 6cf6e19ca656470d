/// \file
/// Where frames are drawn: a picture on the device with depths, smoothed on request. Private to the
/// renderer.
#pragma once

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/gl/gl_slicer.h"
#include "apps/view/drawing/picture_file.h"

namespace soms::view {

class GlTarget {
 public:
  GlTarget() = default;
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  /// Makes the target current and its viewport whole. Keeps what it has where size and samples
  /// stay. \errors ErrorKind::usage beyond the device's largest picture; ErrorKind::cannot_write
  /// where it has no room for so many samples; ErrorKind::out_of_memory.
  void begin(Size size, int samples);

  /// A texture of the depths drawn so far, one a pixel. The target stays current.
  /// \errors ErrorKind::cancelled, here and below.
  [[nodiscard]] unsigned depths(GlSlicer& slicer);

  /// Makes the target current again after others were drawn into.
  void resume() const;

  /// Averages the samples, and stretches the picture to `wanted` pixels. What is drawn next lies
  /// upon that, until `leave`.
  void finish(GlSlicer& slicer, Size wanted);

  /// Makes the frame buffer of the window current.
  static void leave();

  /// \pre After `finish`.
  [[nodiscard]] Picture read(GlSlicer& slicer) const;

  /// Copies to the frame buffer of the window. \pre After `finish`.
  void present() const;

 private:
  void release();
  void make(Size size, int samples);
  void make_wide(Size size);

  /// What holds the finished picture.
  [[nodiscard]] unsigned finished_frame() const;

  Size size_{0, 0};
  int samples_ = 0;
  unsigned frame_ = 0;  ///< drawn into
  unsigned color_ = 0;
  unsigned depth_ = 0;
  unsigned smooth_frame_ = 0;  ///< averaged; 0 with one sample
  unsigned smooth_color_ = 0;
  unsigned wide_frame_ = 0;  ///< stretched; made when it is first needed
  unsigned wide_color_ = 0;
  Size wide_size_{0, 0};
  Size wanted_{0, 0};         ///< of the finished picture
  unsigned depth_frame_ = 0;  ///< one depth a pixel, made when it is first requested
  unsigned depth_texture_ = 0;
};

}  // namespace soms::view
