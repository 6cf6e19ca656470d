#include "apps/view/drawing/gl/gl_shaders.h"

namespace soms::view::shader {

const char* const kBackgroundVertex = R"(#version 330 core
out vec2 at;  // -1 to 1 across the picture
void main() {
  at = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
  gl_Position = vec4(at, 0.0, 1.0);
}
)";

// Most pictures look down, and see a few degrees of sky: most of its colors lie there.
const char* const kBackgroundFragment = R"(#version 330 core
in vec2 at;
uniform vec4 beneath;
uniform vec4 lower;
uniform vec4 upper;
uniform vec2 slopes;
uniform vec3 right;
uniform vec3 upward;
uniform vec3 forward;
uniform vec3 above;
out vec4 pixel;
void main() {
  float height = dot(normalize(forward + right * slopes.x * at.x + upward * slopes.y * at.y), above);
  float sky = 1.0 - exp(-3.5 * max(height, 0.0));
  float haze = 1.0 - exp(9.0 * min(height, 0.0));
  pixel = height > 0.0 ? mix(lower, upper, sky) : mix(lower, beneath, haze);
}
)";

const char* const kGroundVertex = R"(#version 330 core
uniform mat4 clip;
uniform vec3 middle;
uniform vec3 east;   // as long as the disc reaches
uniform vec3 north;
out vec3 seen;
out vec2 at;
void main() {
  at = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  seen = middle + east * at.x + north * at.y;
  gl_Position = clip * vec4(seen, 1.0);
}
)";

const char* const kGroundFragment = R"(
in vec3 seen;
in vec2 at;
uniform vec4 color;
uniform float solid;  // share of the radius from which on it fades
out vec4 pixel;
void main() {
  float opacity = 1.0 - smoothstep(solid, 1.0, length(at));
  opacity *= opacity;
  if (opacity <= 0.004) {
    discard;
  }
  pixel = vec4(color.rgb * light_at(seen, above), opacity);
}
)";

}  // namespace soms::view::shader
