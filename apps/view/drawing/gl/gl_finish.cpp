#include "apps/view/drawing/gl/gl_finish.h"

#include "apps/view/drawing/gl/gl_shaders.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace soms::view {

namespace {

/// Pixels that red reaches at least, so that it is seen beside the curve of a small contact.
constexpr float kLeastGlow = 14;

struct GlowRow {
  std::array<float, 3> a;
  std::array<float, 3> b;
  float radius;
};

void set_places(const GlProgram& program, const GlView& view) {
  program.use();
  program.set("depths", 0);
  program.set("inverse_depth", view.inverse_depth[0], view.inverse_depth[1]);
  program.set("slopes", view.slopes[0], view.slopes[1]);
}

void bind_texture(unsigned unit, unsigned texture) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace

GlFinish::GlFinish()
    : ambient_program_("ambient", shader::kBackgroundVertex,
                       std::string(shader::kPlaceHead) + shader::kAmbientFragment),
      glow_program_("glow", shader::kGlowVertex,
                    std::string(shader::kPlaceHead) + shader::kGlowFragment),
      finish_program_("finish", shader::kBackgroundVertex, shader::kFinishFragment) {
  glows_reading_.floats(0, 3, glows_, sizeof(GlowRow), offsetof(GlowRow, a), 1);
  glows_reading_.floats(1, 3, glows_, sizeof(GlowRow), offsetof(GlowRow, b), 1);
  glows_reading_.floats(2, 1, glows_, sizeof(GlowRow), offsetof(GlowRow, radius), 1);
}

void GlFinish::draw_ambient(const GlView& view, Size size, unsigned depths, GlSlicer& slicer,
                            DrawStatistics& statistics) {
  open_.begin(size);
  set_places(ambient_program_, view);
  ambient_program_.set("reach", std::max(8.0F, static_cast<float>(size.height) / 28));
  bind_texture(0, depths);
  nothing_.bind();
  slicer.in_bands(size, [&](int low, int high) {
    const Band band(size, low, high);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ++statistics.draw_calls;
  });
}

void GlFinish::draw_glows(const DrawList& list, const GlView& view, Size size, unsigned depths,
                          DrawStatistics& statistics) {
  std::vector<GlowRow> rows;
  rows.reserve(list.glows.size());
  for (const Glow& glow : list.glows) {
    const auto a = view.relative(glow.a);
    const auto b = view.relative(glow.b);
    float depth = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      depth += view.forward[k] * 0.5F * (a[k] + b[k]);
    }
    rows.push_back({a, b, std::max(view.length(glow.radius), kLeastGlow * view.slope * depth)});
  }
  near_.begin(size);
  set_places(glow_program_, view);
  glow_program_.set("clip", std::span(view.clip));
  glow_program_.set("slope", view.slope);
  glow_program_.set("right", std::span(view.right));
  glow_program_.set("upward", std::span(view.upward));
  glow_program_.set("forward", std::span(view.forward));
  bind_texture(0, depths);
  glows_.stream(std::as_bytes(std::span(rows)));
  glows_reading_.bind();
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);
  glBlendFunc(GL_ONE, GL_ONE);
  glDrawArraysInstanced(GL_TRIANGLES, 0, 36, static_cast<GLsizei>(rows.size()));
  glBlendEquation(GL_FUNC_ADD);
  ++statistics.draw_calls;
}

void GlFinish::draw(const DrawList& list, const GlView& view, Size size, bool relief,
                    GlTarget& target, GlSlicer& slicer, DrawStatistics& statistics) {
  const bool glowing = !list.glows.empty();
  if (!relief && !glowing) {
    return;
  }
  const unsigned depths = target.depths(slicer);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  if (relief) {
    draw_ambient(view, size, depths, slicer, statistics);
  }
  if (glowing) {
    draw_glows(list, view, size, depths, statistics);
  }
  target.resume();
  set_places(finish_program_, view);
  finish_program_.set("open", 2);
  finish_program_.set("near", 3);
  finish_program_.set("darkened", relief ? 1.0F : 0.0F);
  finish_program_.set("glowing", glowing ? 1.0F : 0.0F);
  finish_program_.set("contact", std::span<const float, 4>(parts_of(list.glow_color)));
  bind_texture(0, depths);
  bind_texture(2, relief ? open_.texture() : depths);
  bind_texture(3, glowing ? near_.texture() : depths);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_SRC_ALPHA);
  nothing_.bind();
  slicer.in_bands(size, [&](int low, int high) {
    const Band band(size, low, high);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ++statistics.draw_calls;
  });
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  for (const unsigned unit : {3U, 2U, 0U}) {
    bind_texture(unit, 0);
  }
}

}  // namespace soms::view
