#include "apps/view/drawing/gl/gl_renderer.h"

#include "soms/base/error.h"

#include "apps/view/drawing/gl/gl_boxes.h"
#include "apps/view/drawing/gl/gl_finish.h"
#include "apps/view/drawing/gl/gl_ground.h"
#include "apps/view/drawing/gl/gl_labels.h"
#include "apps/view/drawing/gl/gl_objects.h"
#include "apps/view/drawing/gl/gl_shaders.h"
#include "apps/view/drawing/gl/gl_shadows.h"
#include "apps/view/drawing/gl/gl_strokes.h"
#include "apps/view/drawing/gl/gl_surfaces.h"
#include "apps/view/drawing/gl/gl_target.h"
#include "apps/view/drawing/gl/gl_view.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace soms::view {

namespace {

constexpr int kLeastVersion = 33;

std::string words(GLenum what) {
  const GLubyte* text = glGetString(what);
  return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

void check_version() {
  const int version = epoxy_gl_version();
  if (version < kLeastVersion || !epoxy_is_desktop_gl()) {
    throw Error(ErrorKind::cannot_write,
                "OpenGL: " + words(GL_RENDERER) + " offers version " + words(GL_VERSION) +
                    ", and 3.3 is needed",
                "update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1");
  }
}

DepthMode depth_mode() {
  return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control")
             ? DepthMode::reversed
             : DepthMode::plain;
}

Size scaled(Size size, double scale) {
  const auto side = [scale](int pixels) {
    return scale == 1 ? pixels : std::max(1, static_cast<int>(std::lround(pixels * scale)));
  };
  return {side(size.width), side(size.height)};
}

/// Of all instances.
std::uint64_t count_triangles(const DrawList& list) {
  std::uint64_t count = 0;
  for (const Instance& instance : list.instances) {
    count += list.meshes[instance.mesh].mesh->triangles.size();
  }
  return count;
}

}  // namespace

struct GlRenderer::Parts {
  Parts()
      : background("background", shader::kBackgroundVertex, shader::kBackgroundFragment),
        shadows(mode) {}

  // Reversed depths need no bounds: precision is the same wherever the range begins.
  [[nodiscard]] DepthRange depths(const DrawList& list, const Camera& camera) const {
    if (mode == DepthMode::plain) {
      Box all = bounds_beside_meshes(list);
      all.grow(surfaces.bounds(list));
      return depth_range(camera, all);
    }
    const double reach = distance_to_target(camera);
    return reach > 0 ? DepthRange{std::max(reach * 2e-3, camera.cut), reach * 1e3}
                     : depth_range(camera, Box{});
  }

  // Clears and paints what lies behind all. \pre `set_state`.
  void draw_background(const Background& colors, const GlView& view, Size size) {
    glDisable(GL_DEPTH_TEST);
    background.use();
    background.set("beneath", std::span<const float, 4>(parts_of(colors.beneath)));
    background.set("lower", std::span<const float, 4>(parts_of(colors.lower)));
    background.set("upper", std::span<const float, 4>(parts_of(colors.upper)));
    background.set("slopes", view.slopes[0], view.slopes[1]);
    background.set("right", std::span(view.right));
    background.set("upward", std::span(view.upward));
    background.set("forward", std::span(view.forward));
    background.set("above", std::span(view.above));
    nothing.bind();
    slicer.in_bands(size, [&](int low, int high) {
      const Band band(size, low, high);
      glClear(GL_DEPTH_BUFFER_BIT);
      glDrawArrays(GL_TRIANGLES, 0, 3);
      ++statistics.draw_calls;
    });
    glEnable(GL_DEPTH_TEST);
  }

  void set_state() const {
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_POLYGON_OFFSET_FILL);  // these two where a drawing was stopped
    glDisable(GL_DEPTH_CLAMP);
    glEnable(GL_MULTISAMPLE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    if (mode == DepthMode::reversed) {
      glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
      glClearDepth(0);
      glDepthFunc(GL_GEQUAL);
    } else {
      glClearDepth(1);
      glDepthFunc(GL_LEQUAL);
    }
  }

  // Leaves the context as others, such as a panel's renderer, expect it.
  void reset_state() const {
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_DEPTH_TEST);
    if (mode == DepthMode::reversed) {
      glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
      glClearDepth(1);
      glDepthFunc(GL_LESS);
    }
  }

  void draw_layer(const DrawList& list, const GlView& view, bool on_top) {
    boxes.draw_solid(list, view, shadows, on_top, statistics);
    slicer.drawn(0);
    surfaces.draw_marks(list, view, shadows, on_top, slicer, statistics);
    strokes.draw(list, view, on_top, statistics);
    boxes.draw_translucent(list, view, shadows, on_top, statistics);
    slicer.drawn(0);
  }

  DepthMode mode = depth_mode();  // before what is made for it
  GlSlicer slicer;
  GlTarget target;
  GlProgram background;
  GlVertexArray nothing;
  GlShadows shadows;
  GlSurfaces surfaces;
  GlGround ground;
  GlFinish finish;
  GlBoxes boxes;
  GlStrokes strokes;
  GlLabels labels;
  DrawStatistics statistics;
  bool drawn = false;
};

GlRenderer::GlRenderer() {
  check_version();
  parts_ = std::make_unique<Parts>();
}

GlRenderer::~GlRenderer() = default;

void GlRenderer::draw(const DrawList& list, const Camera& camera, Size size,
                      const DrawOptions& options) {
  check(list);
  Parts& p = *parts_;
  p.drawn = false;
  p.statistics = {};
  const Size drawn = scaled(size, options.scale);
  p.target.begin(drawn, options.samples);
  p.surfaces.bring(list, p.slicer, p.statistics);
  p.boxes.bring(list, p.statistics);
  GlView view = gl_view(camera, size, list.light, p.depths(list, camera), p.mode);
  view.point = static_cast<float>(options.density);
  p.slicer.begin(count_triangles(list), drawn);
  p.set_state();
  p.shadows.draw(list, camera, view, options.shadows, p.surfaces, p.slicer, p.statistics);
  p.surfaces.choose(list, camera, size, view, options, p.statistics);
  p.statistics.marks = list.marks.size();
  p.target.resume();
  p.set_state();
  p.draw_background(list.background, view, drawn);
  p.surfaces.draw_solid(view, p.shadows, p.slicer, p.statistics);
  p.ground.draw(list, view, p.shadows, p.statistics);
  p.finish.draw(list, view, drawn, options.relief && p.statistics.triangles > 0, p.target, p.slicer,
                p.statistics);
  p.draw_layer(list, view, false);
  p.surfaces.draw_translucent(view, p.shadows, p.slicer, p.statistics);
  glDisable(GL_DEPTH_TEST);
  p.draw_layer(list, view, true);
  // What is written stays sharp where the scene is drawn with fewer pixels.
  p.target.finish(p.slicer, size);
  p.labels.draw(list, camera, size, options.density, p.statistics);
  p.reset_state();
  GlTarget::leave();
  check_device("drawing a frame");
  p.drawn = true;
}

void GlRenderer::take(CutMeshes cut) {
  parts_->surfaces.take(std::move(cut));
}

void GlRenderer::watch(const Limits& limits) {
  parts_->slicer.watch(limits);
}

void GlRenderer::present() {
  if (parts_->drawn) {
    parts_->target.present();
  }
}

Picture GlRenderer::read_pixels() {
  if (!parts_->drawn) {
    throw Error(ErrorKind::usage, "picture: nothing was drawn yet", "draw a frame first");
  }
  return parts_->target.read(parts_->slicer);
}

DrawStatistics GlRenderer::statistics() const {
  return parts_->statistics;
}

void GlRenderer::finish() {
  glFinish();
}

std::string GlRenderer::device() {
  return words(GL_RENDERER) + ", OpenGL " + words(GL_VERSION);
}

}  // namespace soms::view
