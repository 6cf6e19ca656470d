#include "apps/view/drawing/gl/gl_ground.h"

#include "apps/view/drawing/gl/gl_shaders.h"

#include <epoxy/gl.h>

#include <array>
#include <span>
#include <string>

namespace soms::view {

namespace {

/// Share of the radius from which on the disc fades.
constexpr float kSolid = 0.45F;

}  // namespace

GlGround::GlGround() : program_("ground", shader::kGroundVertex, shader::kGroundFragment) {
}

void GlGround::draw(const DrawList& list, const GlView& view, const GlShadows& shadows,
                    DrawStatistics& statistics) const {
  if (!list.ground || list.ground->center.z >= view.eye.z) {
    return;
  }
  const Ground& ground = *list.ground;
  const float reach = view.length(ground.radius);
  const GlProgram& program = program_.use(shadows, view);
  program.set("clip", std::span(view.clip));
  program.set("middle", std::span<const float, 3>(view.relative(ground.center)));
  program.set("east", std::span<const float, 3>(std::array<float, 3>{reach, 0, 0}));
  program.set("north", std::span<const float, 3>(std::array<float, 3>{0, reach, 0}));
  program.set("color", std::span<const float, 4>(parts_of(ground.color)));
  program.set("solid", kSolid);
  nothing_.bind();
  glEnable(GL_DEPTH_CLAMP);  // the camera's cut leaves it whole
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisable(GL_DEPTH_CLAMP);
  ++statistics.draw_calls;
}

}  // namespace soms::view
