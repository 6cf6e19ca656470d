#include "apps/view/drawing/gl_shaders.h"

namespace soms::view::shader {

const char* const kSurfaceVertex = R"(#version 330 core
layout(location = 0) in vec3 at;
layout(location = 1) in vec4 paint;
layout(location = 2) in vec4 row0;
layout(location = 3) in vec4 row1;
layout(location = 4) in vec4 row2;
layout(location = 5) in vec4 tint;
layout(location = 6) in vec2 use;  // x: 1 for the tint instead of the paint; y: brighter
uniform mat4 clip;
uniform float lift;
out vec3 seen;
out vec4 color;
void main() {
  vec4 p = vec4(at, 1.0);
  seen = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
  vec3 own = mix(paint.rgb, tint.rgb, use.x);
  color = vec4(mix(own, vec3(1.0), use.y), tint.a);
  gl_Position = clip * vec4(seen * lift, 1.0);
}
)";

const char* const kSurfaceFragment = R"(#version 330 core
in vec3 seen;
in vec4 color;
uniform vec3 toward;
uniform float ambient;
uniform float flatness;  // 1: the plain color
uniform float shade;     // factor of the color, for edges upon faces
out vec4 pixel;
void main() {
  vec3 n = cross(dFdx(seen), dFdy(seen));
  float size = length(n);
  n = size > 0.0 ? n / size : -normalize(seen);
  n = dot(n, seen) > 0.0 ? -n : n;  // both sides of a triangle are lit
  float sun = 0.5 + 0.5 * dot(n, toward);
  float light = mix(ambient + (1.0 - ambient) * sun * 1.1, 1.0, flatness);
  pixel = vec4(color.rgb * light * shade, color.a);
}
)";

const char* const kBoxVertex = R"(#version 330 core
layout(location = 0) in vec3 middle;
layout(location = 1) in vec3 reach;
layout(location = 2) in vec4 paint;
uniform mat4 clip;
uniform float lift;
uniform vec4 row0;
uniform vec4 row1;
uniform vec4 row2;
out vec3 seen;
out vec4 color;
const int kCorner[36] = int[36](0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5);
void main() {
  int c = kCorner[gl_VertexID];
  vec3 side = vec3((c & 1) * 2 - 1, (c & 2) - 1, (c & 4) / 2 - 1);
  vec4 p = vec4(middle + side * reach, 1.0);
  seen = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
  color = paint;
  gl_Position = clip * vec4(seen * lift, 1.0);
}
)";

// A stroke is a rectangle of constant width in the picture about a segment that is first cut at the
// nearest w, since beyond it the division by w is meaningless. Its border lies beside the segment
// and must clear a slanted surface that holds the segment, so wide strokes are brought nearer.
const char* const kStrokeHead = R"(#version 330 core
uniform mat4 clip;
uniform float lift;
uniform float nearest;
uniform float slope;  // width of a pixel at distance 1
uniform vec2 half_size;
out vec4 color;
noperspective out float across_pixels;  // from the middle of the stroke
void stroke(vec3 from, vec3 to, int corner, float width) {
  float nearer = lift - 0.75 * width * slope;
  vec4 a = clip * vec4(from * nearer, 1.0);
  vec4 b = clip * vec4(to * nearer, 1.0);
  if (a.w < nearest && b.w < nearest) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  vec4 cut_a = a.w < nearest ? mix(a, b, (nearest - a.w) / (b.w - a.w)) : a;
  vec4 cut_b = b.w < nearest ? mix(b, a, (nearest - b.w) / (a.w - b.w)) : b;
  vec2 along = (cut_b.xy / cut_b.w - cut_a.xy / cut_a.w) * half_size;
  float size = length(along);
  along = size > 1e-6 ? along / size : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  vec4 end = (corner & 2) == 0 ? cut_a : cut_b;
  float out_of = (corner & 2) == 0 ? -0.5 : 0.5;
  float side = (corner & 1) == 0 ? -0.5 : 0.5;
  across_pixels = side * width;
  vec2 shift = (across * side + along * out_of * 0.9) * width / half_size;
  gl_Position = vec4(end.xy + shift * end.w, end.zw);
}
)";

const char* const kLineVertex = R"(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 paint;
layout(location = 3) in float width;
layout(location = 4) in vec4 rim_paint;
layout(location = 5) in float rim_width;
flat out vec4 rim;
flat out float inner;
void main() {
  color = paint;
  rim = rim_paint;
  inner = rim_width > 0.0 ? 0.5 * width : 1e9;
  stroke(from, to, gl_VertexID, width + 2.0 * rim_width);
}
)";

const char* const kLineFragment = R"(#version 330 core
in vec4 color;
noperspective in float across_pixels;
flat in vec4 rim;
flat in float inner;
out vec4 pixel;
void main() { pixel = mix(color, rim, clamp(abs(across_pixels) - inner + 0.5, 0.0, 1.0)); }
)";

const char* const kEdgeVertex = R"(
layout(location = 0) in vec3 middle;
layout(location = 1) in vec3 reach;
layout(location = 2) in vec4 paint;
uniform vec4 row0;
uniform vec4 row1;
uniform vec4 row2;
uniform float width;
uniform float least_alpha;
const int kCorner[6] = int[6](0, 1, 2, 2, 1, 3);
vec3 place(vec3 side) {
  vec4 p = vec4(middle + side * reach, 1.0);
  return vec3(dot(row0, p), dot(row1, p), dot(row2, p));
}
void main() {
  int edge = gl_VertexID / 6;
  int axis = edge / 4;
  vec2 other = vec2((edge & 1) * 2 - 1, (edge & 2) - 1);
  vec3 from = axis == 0 ? vec3(-1.0, other) : axis == 1 ? vec3(other.x, -1.0, other.y)
                                                        : vec3(other, -1.0);
  vec3 to = axis == 0 ? vec3(1.0, other) : axis == 1 ? vec3(other.x, 1.0, other.y)
                                                      : vec3(other, 1.0);
  color = vec4(paint.rgb, max(paint.a, least_alpha));
  stroke(place(from), place(to), kCorner[gl_VertexID % 6], width);
}
)";

const char* const kStrokeFragment = R"(#version 330 core
in vec4 color;
out vec4 pixel;
void main() { pixel = color; }
)";

const char* const kPointVertex = R"(#version 330 core
layout(location = 0) in vec3 at;
layout(location = 1) in vec4 paint;
layout(location = 2) in float diameter;
layout(location = 3) in vec4 rim_paint;
uniform mat4 clip;
uniform float lift;
uniform float slope;
uniform vec2 half_size;
out vec4 color;
out vec2 offset;  // in pixels from the middle
flat out float radius;
flat out vec3 rim;
void main() {
  vec4 p = clip * vec4(at * (lift - 0.5 * diameter * slope), 1.0);
  vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  radius = 0.5 * diameter;
  offset = corner * (radius + 1.0);
  color = paint;
  rim = rim_paint.rgb;
  gl_Position = vec4(p.xy + offset / half_size * p.w, p.zw);
}
)";

const char* const kPointFragment = R"(#version 330 core
in vec4 color;
in vec2 offset;
flat in float radius;
flat in vec3 rim;
out vec4 pixel;
void main() {
  float inside = radius - length(offset);
  float cover = clamp(inside + 0.5, 0.0, 1.0);
  if (cover <= 0.0) {
    discard;
  }
  // A rim sets large points off from any ground.
  float share = radius > 3.0 ? clamp(1.7 - inside, 0.0, 1.0) : 0.0;
  pixel = vec4(mix(color.rgb, rim, share), color.a * cover);
}
)";

const char* const kLetterVertex = R"(#version 330 core
layout(location = 0) in vec2 from;  // in pixels from the middle of the picture, y up
layout(location = 1) in vec2 to;
layout(location = 2) in vec4 paint;
layout(location = 3) in float width;
uniform vec2 half_size;
out vec4 color;
out vec2 at;
flat out vec4 ends;
flat out float radius;
void main() {
  vec2 along = to - from;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  radius = 0.5 * width;
  float reach = radius + 1.0;
  float side = (gl_VertexID & 1) == 0 ? -reach : reach;
  at = (gl_VertexID & 2) == 0 ? from - along * reach : to + along * reach;
  at += across * side;
  color = paint;
  ends = vec4(from, to);
  gl_Position = vec4(at / half_size, 0.0, 1.0);
}
)";

// Round at both ends, so that strokes of a letter join.
const char* const kLetterFragment = R"(#version 330 core
in vec4 color;
in vec2 at;
flat in vec4 ends;
flat in float radius;
out vec4 pixel;
void main() {
  vec2 line = ends.zw - ends.xy;
  float square = dot(line, line);
  float t = square > 0.0 ? clamp(dot(at - ends.xy, line) / square, 0.0, 1.0) : 0.0;
  float cover = clamp(radius + 0.5 - distance(at, ends.xy + t * line), 0.0, 1.0);
  if (cover <= 0.0) {
    discard;
  }
  pixel = vec4(color.rgb, color.a * cover);
}
)";

const char* const kBackgroundVertex = R"(#version 330 core
uniform vec4 lower;
uniform vec4 upper;
out vec4 color;
void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
  color = mix(lower, upper, corner.y * 0.5 + 0.5);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

const char* const kBackgroundFragment = kStrokeFragment;

// The inverse of the distance is a linear function of the place in the picture on any plane, and is
// affine in the depth, so its second differences are 0 but at creases and steps: whatever the slant
// of a surface, only these are darkened.
const char* const kReliefFragment = R"(#version 330 core
uniform sampler2D depths;
uniform float reversed;
uniform float reach;  // in pixels
out vec4 pixel;
ivec2 last;
float inverse_distance(ivec2 at) {
  float d = texelFetch(depths, clamp(at, ivec2(0), last), 0).r;
  return reversed > 0.5 ? d : 1.0 - d;
}
void main() {
  last = textureSize(depths, 0) - 1;
  ivec2 here = ivec2(gl_FragCoord.xy);
  float middle = inverse_distance(here);
  if (middle <= 0.0) {
    discard;
  }
  float dark = 0.0;
  for (int ring = 1; ring <= 2; ++ring) {
    float r = ring == 1 ? max(1.0, 0.4 * reach) : reach;
    ivec2 x = ivec2(int(r + 0.5), 0);
    ivec2 d = ivec2(int(0.7 * r + 0.5));
    ivec2 e = ivec2(d.x, -d.y);
    float sum = 0.0;
    sum += max(0.0, inverse_distance(here + x) + inverse_distance(here - x) - 2.0 * middle);
    sum += max(0.0, inverse_distance(here + x.yx) + inverse_distance(here - x.yx) - 2.0 * middle);
    sum += max(0.0, inverse_distance(here + d) + inverse_distance(here - d) - 2.0 * middle);
    sum += max(0.0, inverse_distance(here + e) + inverse_distance(here - e) - 2.0 * middle);
    dark += sum / middle;
  }
  // A step of a tenth of the distance counts almost whole.
  float shade = 1.0 - 0.4 * (1.0 - exp(-dark * 12.0));
  pixel = vec4(vec3(shade), 1.0);
}
)";

}  // namespace soms::view::shader
