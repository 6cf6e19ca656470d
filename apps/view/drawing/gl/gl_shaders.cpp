#include "apps/view/drawing/gl/gl_shaders.h"

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

// A sky that is brighter above, and a sun. Where shadows are drawn, two maps hold how near to the
// sun the first surface is: one about what is looked at, and a coarser one about the rest.
const char* const kLightHead = R"(#version 330 core
uniform vec3 toward;    // to the sun
uniform vec3 above;
uniform float ambient;
uniform float shadows;  // 1 where they are drawn
uniform mat4 sun0;
uniform mat4 sun1;
uniform vec2 texels;    // their sides in either map
uniform float rest;     // the layer of the other map: 0 where one map holds all
uniform sampler2DArrayShadow sun_depths;
float share_of(vec3 place, float layer) {
  float side = 1.3 / float(textureSize(sun_depths, 0).x);
  float sum = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      sum += texture(sun_depths, vec4(place.xy + vec2(x, y) * side, layer, place.z));
    }
  }
  return sum / 9.0;
}
bool inside(vec3 place) { return all(lessThan(abs(place - 0.5), vec3(0.49))); }
// Share of the sun that is seen. A place is held off its surface by its texel's size, else the
// texel's corner would hide its middle.
float sunlit(vec3 at, vec3 n) {
#ifdef UNSHADOWED
  return 1.0;
#else
  if (shadows < 0.5) {
    return 1.0;
  }
  float slant = sqrt(max(0.0, 1.0 - dot(n, toward) * dot(n, toward)));
  vec3 off = n * (0.3 + 1.5 * slant) + toward * 0.3;
  vec3 nearer = (sun0 * vec4(at + off * texels.x, 1.0)).xyz;
  vec3 farther = (sun1 * vec4(at + off * texels.y, 1.0)).xyz;
  // Farther from the sun than the map's ball, as the ground may be, all of it lies before the place.
  farther.z = clamp(farther.z, 0.0, 1.0);
  // One lookup for both maps: drivers in software take either branch.
  bool is_near = inside(nearer);
  bool is_far = all(lessThan(abs(farther.xy - 0.5), vec2(0.49)));
  return is_near || is_far ? share_of(is_near ? nearer : farther, is_near ? 0.0 : rest) : 1.0;
#endif
}
vec3 light_at(vec3 at, vec3 n) {
  vec3 sky = mix(vec3(0.60, 0.595, 0.59), vec3(0.73, 0.76, 0.81), 0.5 + 0.5 * dot(n, above));
  float direct = dot(n, toward);
  vec3 sun = vec3(0.0);
  if (direct > 0.0) {
    sun = vec3(0.40, 0.37, 0.32) * direct * sunlit(at, n);
  }
  return 2.0 * mix(sun, sky, ambient);
}
)";

const char* const kSurfaceFragment = R"(
in vec3 seen;
in vec4 color;
uniform float flatness;  // 1: the plain color
uniform float shade;     // factor of the color, for edges upon faces
uniform vec4 focus;      // a ball beyond which surfaces are pale; of radius 0: none
out vec4 pixel;
void main() {
  vec3 n = cross(dFdx(seen), dFdy(seen));
  float size = length(n);
  n = size > 0.0 ? n / size : -normalize(seen);
  n = dot(n, seen) > 0.0 ? -n : n;  // both sides of a triangle are lit
  vec3 light = mix(light_at(seen, n), vec3(1.0), flatness);
  // What is far loses color first and contrast later, so slowly that no border is seen.
  float away = focus.w > 0.0 ? log2(max(distance(seen, focus.xyz) / focus.w, 1.0)) : 0.0;
  vec3 near = color.rgb * light * shade;
  vec3 gray = vec3(dot(near, vec3(0.2126, 0.7152, 0.0722)));
  vec3 faded = mix(near, gray, 0.85 * smoothstep(0.3, 3.2, away));
  pixel = vec4(mix(faded, vec3(0.93, 0.94, 0.945), 0.5 * smoothstep(0.0, 3.5, away)), color.a);
}
)";

const char* const kShadowFragment = R"(#version 330 core
void main() {}
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

// The inverse of the distance forward is a linear function of the depth.
const char* const kPlaceHead = R"(#version 330 core
uniform sampler2D depths;
uniform vec2 inverse_depth;  // factor and summand
uniform vec2 slopes;         // half of the picture at distance 1
float inverse_at(ivec2 at) {
  ivec2 last = textureSize(depths, 0) - 1;
  float d = texelFetch(depths, clamp(at, ivec2(0), last), 0).r;
  return d * inverse_depth.x + inverse_depth.y;
}
// Right, up and forward from the eye.
vec3 place(ivec2 at, float inverse) {
  vec2 share = (vec2(at) + 0.5) / vec2(textureSize(depths, 0)) * 2.0 - 1.0;
  return vec3(share * slopes, 1.0) / max(inverse, 1e-9);
}
)";

// Surfaces about a place hide part of its sky: the steeper they rise from its plane and the nearer,
// the more.
const char* const kAmbientFragment = R"(
uniform float reach;  // in pixels
out float open;
const int kSamples = 13;
const mat2 kTurn = mat2(-0.7485107, 0.6631227, -0.6631227, -0.7485107);  // by 5 / 13 of a circle
vec3 step_from(ivec2 at, vec3 here, ivec2 to) {
  float a = inverse_at(at + to);
  float b = inverse_at(at - to);
  vec3 ahead = place(at + to, a) - here;
  vec3 back = here - place(at - to, b);
  return a > 0.0 && (b <= 0.0 || abs(ahead.z) < abs(back.z)) ? ahead : back;
}
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float inverse = inverse_at(at);
  open = 1.0;
  if (inverse <= 1e-9) {
    return;
  }
  vec3 here = place(at, inverse);
  vec3 n = normalize(cross(step_from(at, here, ivec2(1, 0)), step_from(at, here, ivec2(0, 1))));
  n = dot(n, here) > 0.0 ? -n : n;
  float radius = reach * 2.0 * slopes.y / float(textureSize(depths, 0).y) * here.z;
  float square = radius * radius;
  float turn = float((at.x & 3) * 4 + (at.y & 3)) * (6.2831853 / 16.0);
  vec2 direction = vec2(cos(turn), sin(turn));
  float sum = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    float share = (float(k) + 0.5) / float(kSamples);
    ivec2 there = at + ivec2(round(direction * (share * reach + 1.0)));
    direction = kTurn * direction;
    there = clamp(there, ivec2(0), textureSize(depths, 0) - 1);
    vec3 to = place(there, inverse_at(there)) - here;
    float vv = dot(to, to);
    float height = dot(to, n) * inversesqrt(max(vv, 1e-12 * square));
    sum += max(0.0, 1.0 - vv / square) * max(0.0, height - 0.12);
  }
  open = max(0.0, 1.0 - 2.4 * sum / float(kSamples));
}
)";

const char* const kGlowVertex = R"(#version 330 core
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in float radius;
uniform mat4 clip;
uniform float slope;  // width of a pixel at distance 1
flat out vec3 start;
flat out vec3 end;
flat out float reach;
const int kCorner[36] = int[36](0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5);
void main() {
  int c = kCorner[gl_VertexID];
  vec3 side = vec3((c & 1) * 2 - 1, (c & 2) - 1, (c & 4) / 2 - 1);
  vec3 middle = 0.5 * (from + to);
  // From afar it still is some pixels wide.
  reach = max(radius, 5.0 * slope * length(middle));
  vec3 along = to - from;
  float size = length(along);
  along = size > 0.0 ? along / size : vec3(1.0, 0.0, 0.0);
  vec3 across = normalize(abs(along.z) < 0.9 ? cross(along, vec3(0.0, 0.0, 1.0))
                                             : cross(along, vec3(1.0, 0.0, 0.0)));
  start = from;
  end = to;
  vec3 corner = middle + along * side.x * (0.5 * size + reach) + across * side.y * reach +
                cross(along, across) * side.z * reach;
  gl_Position = clip * vec4(corner, 1.0);
}
)";

const char* const kGlowFragment = R"(
flat in vec3 start;
flat in vec3 end;
flat in float reach;
uniform vec3 right;
uniform vec3 upward;
uniform vec3 forward;
out float near;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float inverse = inverse_at(at);
  if (inverse <= 1e-9) {
    discard;
  }
  vec3 p = place(at, inverse);
  vec3 here = right * p.x + upward * p.y + forward * p.z;
  vec3 along = end - start;
  float square = dot(along, along);
  float t = square > 0.0 ? clamp(dot(here - start, along) / square, 0.0, 1.0) : 0.0;
  near = 1.0 - distance(here, start + t * along) / reach;
  if (near <= 0.0) {
    discard;
  }
}
)";

const char* const kFinishFragment = R"(#version 330 core
uniform sampler2D depths;
uniform sampler2D open;
uniform sampler2D near;
uniform vec2 inverse_depth;
uniform float darkened;  // 1 where the sky is hidden by what is near
uniform float glowing;   // 1 where contacts are colored
uniform vec4 contact;
out vec4 pixel;
float inverse_at(ivec2 at) {
  ivec2 last = textureSize(depths, 0) - 1;
  return texelFetch(depths, clamp(at, ivec2(0), last), 0).r * inverse_depth.x + inverse_depth.y;
}
// The mean of the 16 turns of the samples, of places about as far.
float opened(ivec2 at) {
  float here = inverse_at(at);
  ivec2 last = textureSize(open, 0) - 1;
  float sum = 0.0;
  float weight = 0.0;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 there = clamp(at + ivec2(x, y), ivec2(0), last);
      float w = abs(inverse_at(there) - here) < 0.03 * here ? 1.0 : 0.001;
      sum += w * texelFetch(open, there, 0).r;
      weight += w;
    }
  }
  return sum / weight;
}
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  if (inverse_at(at) <= 1e-9) {
    discard;
  }
  float light = darkened > 0.5 ? mix(0.35, 1.0, opened(at)) : 1.0;
  float share = glowing > 0.5 ? texelFetch(near, at, 0).r : 0.0;
  share = 0.85 * share * (1.6 - 0.6 * share);
  // Added to what is there times the opacity: see the blend function.
  pixel = vec4(contact.rgb * light * share, light * (1.0 - share));
}
)";

}  // namespace soms::view::shader
