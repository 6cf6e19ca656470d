#include "apps/view/drawing/gl/gl_light.h"

#include "apps/view/drawing/gl/gl_shaders.h"
#include "apps/view/drawing/gl/gl_shadows.h"

#include <string>

namespace soms::view {

namespace {

/// The light's text with its switch: the version has to stand first.
std::string without_shadows(std::string head) {
  return head.insert(head.find('\n') + 1, "#define UNSHADOWED\n");
}

}  // namespace

GlLitProgram::GlLitProgram(const char* name, const char* vertex, const char* fragment)
    : shadowed_(name, vertex, std::string(shader::kLightHead) + fragment),
      unshadowed_(name, vertex, without_shadows(shader::kLightHead) + fragment) {
}

const GlProgram& GlLitProgram::use(const GlShadows& shadows, const GlView& view) const {
  const GlProgram& program = shadows.drawn() ? shadowed_ : unshadowed_;
  program.use();
  shadows.light(program, view);
  return program;
}

}  // namespace soms::view
