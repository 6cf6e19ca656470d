#include "apps/view/drawing/gl/gl_shadows.h"

#include "apps/view/drawing/gl/gl_shaders.h"

#include <epoxy/gl.h>

#include <span>
#include <utility>

namespace soms::view {

namespace {

constexpr int kSunUnit = 1;  // of textures; 0 is for passes over the picture

/// Columns of `upper` times those of `lower`, where `upper` takes [0, 1] to the clip space.
std::array<float, 16> clip_of(const std::array<float, 16>& place, DepthMode mode) {
  std::array<float, 16> clip = place;
  for (std::size_t column = 0; column < 16; column += 4) {
    const float one = place[column + 3];
    clip[column] = 2 * place[column] - one;
    clip[column + 1] = 2 * place[column + 1] - one;
    if (mode == DepthMode::plain) {
      clip[column + 2] = 2 * place[column + 2] - one;
    }
  }
  return clip;
}

}  // namespace

GlShadows::GlShadows(DepthMode mode)
    : mode_(mode), program_("shadow", shader::kSurfaceVertex, shader::kShadowFragment) {
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_);
  // One texel stands in until shadows are drawn: programs need a map to be complete.
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, 1, 1, 2, 0, GL_DEPTH_COMPONENT,
               GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
}

GlShadows::~GlShadows() {
  glDeleteFramebuffers(1, &frame_);
  glDeleteTextures(1, &texture_);
}

std::vector<GlShadows::Caster> GlShadows::casters_of(const DrawList& list) {
  std::vector<Caster> casters;
  casters.reserve(list.instances.size());
  for (const Instance& instance : list.instances) {
    const DrawMesh& mesh = list.meshes[instance.mesh];
    casters.push_back({mesh.key, mesh.version, instance.pose, pass_of(instance) == Pass::solid});
  }
  return casters;
}

void GlShadows::draw(const DrawList& list, const Camera& camera, const GlView& view, bool drawn,
                     GlSurfaces& surfaces, GlSlicer& slicer, DrawStatistics& statistics) {
  drawn_ = drawn && !list.instances.empty();
  if (!drawn_) {
    return;
  }
  std::vector<Caster> casters = casters_of(list);
  if (casters != casters_ || list.light.toward != toward_) {
    casters_ = std::move(casters);
    toward_ = list.light.toward;
    kept_ = {};
  }
  maps_ = sun_maps(camera, view, list.light, surfaces.bounds(list));
  if (frame_ == 0) {
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, kSunTexels, kSunTexels, 2, 0,
                 GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    glGenFramebuffers(1, &frame_);
    check_device("making the maps of shadows");
  }
  const bool same = maps_[0].radius == maps_[1].radius;
  for (std::size_t layer = 0; layer < (same ? 1U : 2U); ++layer) {
    if (kept_[layer] && same_ball(*kept_[layer], maps_[layer])) {
      maps_[layer] = seen_by(*kept_[layer], view, list.light);
    } else {
      draw_map(layer, list, view, surfaces, slicer, statistics);
    }
  }
  if (same) {
    maps_[1] = maps_[0];
  }
}

void GlShadows::draw_map(std::size_t layer, const DrawList& list, const GlView& view,
                         GlSurfaces& surfaces, GlSlicer& slicer, DrawStatistics& statistics) {
  constexpr double kSpeckTexels = 2;
  const SunMap& map = maps_[layer];
  kept_[layer].reset();  // should the drawing be stopped
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  glViewport(0, 0, kSunTexels, kSunTexels);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_DEPTH_CLAMP);  // what is between the ball and the sun casts, too
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_TRUE);
  glClearDepth(0);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1.5F, -2);
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture_, 0,
                            static_cast<GLint>(layer));
  glClear(GL_DEPTH_BUFFER_BIT);
  const std::array<float, 16> clip = clip_of(map.place, mode_);
  program_.use();
  program_.set("clip", std::span(clip));
  program_.set("lift", 1.0F);
  surfaces.cast(
      list, view, [&](const Box& box) { return casts_into(map, list.light, box); },
      kSpeckTexels * 2 * map.radius / kSunTexels, slicer, statistics);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
  kept_[layer] = map;
}

void GlShadows::light(const GlProgram& program, const GlView& view) const {
  program.set("toward", std::span(view.toward));
  program.set("above", std::span(view.above));
  program.set("ambient", view.ambient);
  program.set("shadows", drawn_ ? 1.0F : 0.0F);
  program.set("sun0", std::span<const float, 16>(maps_[0].place));
  program.set("sun1", std::span<const float, 16>(maps_[1].place));
  program.set("texels", maps_[0].texel, maps_[1].texel);
  program.set("rest", maps_[0].radius == maps_[1].radius ? 0.0F : 1.0F);
  program.set("sun_depths", kSunUnit);
  glActiveTexture(GL_TEXTURE0 + kSunUnit);
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_);
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace soms::view
