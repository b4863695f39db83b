// The programs that draw strands: a strand is one texel, and is found by the vertex's number.
import { RAMP } from "./theme";

/** Texels in a row. */
export const WIDTH = 2048;
export const MOST_KINDS = 64;
/** The bit of a kind that says that the strand breaks a rule; see view_texels.py. */
const BREACH_BIT = 0x80;

/** What both ways have in common: a strand's ends as seen, cut where they come too near, and its colour. */
const COMMON = `
precision highp float;
precision highp int;
precision highp usampler2D;
precision highp sampler2D;
uniform usampler2D strands;
uniform sampler2D values;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec2 screen;
uniform vec3 low, span;
uniform float diameterStep, slabTop, near;
uniform vec4 kinds[${MOST_KINDS}];  // colour, and whether it is shown
uniform vec3 ramp[${RAMP.length}];
uniform vec3 faint, breach;
uniform int mode;                    // 0: by kind, 1: by value, 2: by breach
uniform int last;                    // the strand that is being laid
uniform float laid;                  // how much of it is
flat out vec3 colour;
vec3 ramped(float value) {
  float place = clamp(value, 0.0, 1.0) * float(${RAMP.length - 1});
  int below = int(min(place, float(${RAMP.length - 2})));
  return mix(ramp[below], ramp[below + 1], place - float(below));
}
// Where a strand is; false: it is not shown.
bool found(int strand, out vec3 a, out vec3 b, out float thick) {
  ivec2 texel = ivec2(strand % ${WIDTH}, strand / ${WIDTH});
  uvec4 packed = texelFetch(strands, texel, 0);
  vec3 from = vec3(packed.x & 0xffffu, packed.x >> 16, packed.y & 0xffffu) / 65535.0;
  vec3 to = vec3(packed.y >> 16, packed.z & 0xffffu, packed.z >> 16) / 65535.0;
  uint kindBits = packed.w & 0xffu;
  vec4 kind = kinds[min(kindBits & 0x7fu, ${MOST_KINDS - 1}u)];
  bool broken = (kindBits & ${BREACH_BIT}u) != 0u;
  if (kind.a == 0.0 && !(mode == 2 && broken)) return false;
  if (float(packed.w >> 16) > slabTop) return false;
  a = (modelViewMatrix * vec4(low + from * span, 1)).xyz;
  b = (modelViewMatrix * vec4(low + to * span, 1)).xyz;
  if (strand == last) b = mix(a, b, laid);
  float nearest = -near * 1.01;
  if (min(a.z, b.z) > nearest) return false;
  if (a.z > nearest) a = mix(b, a, (nearest - b.z) / (a.z - b.z));
  if (b.z > nearest) b = mix(a, b, (nearest - a.z) / (b.z - a.z));
  thick = float((packed.w >> 8) & 0xffu) * diameterStep;
  if (mode == 0) colour = kind.rgb;
  else if (mode == 1) {
    float share = texelFetch(values, texel, 0).r;
    colour = share < 0.0 ? faint : ramped(share);
  }
  else colour = broken ? breach : faint;
  return true;
}`;

/** How far a strand and its halo reach from its middle, in its radii: no pixel beyond is asked about. */
const REACH = "#define REACH 1.323";
/** Corners of the quad that each strand is drawn on; its two triangles name them by number. */
export const CORNERS = 4;
export const TRIANGLES = [0, 1, 2, 2, 1, 3] as const;

/** A quad for each strand. */
export const TUBE_VERTEX = `${REACH}
${COMMON}
flat out vec4 axis;                  // start and direction on the screen, pixels
flat out vec4 depth;                 // 1/z and its step, radius and its step
flat out vec3 facing;
flat out vec2 inverse;               // of the length's square and of the focal length, pixels
void main() {
  int corner = gl_VertexID % ${CORNERS};
  vec3 a, b;
  float thick;
  gl_Position = vec4(2, 2, 2, 1);
  if (!found(gl_VertexID / ${CORNERS}, a, b, thick)) return;
  float focal = projectionMatrix[1][1] * screen.y * 0.5;
  vec2 key = -1.0 / vec2(a.z, b.z);
  vec2 radius = max(thick * 0.5 * focal * key, 0.6);
  vec2 start = focal * a.xy * key.x, along = focal * b.xy * key.y - start;
  vec3 direction = normalize(b - a + vec3(0, 0, 1e-9));
  axis = vec4(start + screen * 0.5, along);
  depth = vec4(key.x, key.y - key.x, radius.x, radius.y - radius.x);
  inverse = vec2(1.0 / max(dot(along, along), 1e-6), 1.0 / focal);
  facing = normalize(vec3(0, 0, 1) - direction * direction.z + vec3(0, 0, 1e-6));
  float reach = max(radius.x, radius.y) * REACH + 0.01, len = max(length(along), 1e-3);
  vec2 unit = length(along) > 1e-3 ? along / len : vec2(1, 0);
  float u = corner < 2 ? -reach : len + reach;
  float v = corner % 2 == 0 ? -reach : reach;
  gl_Position = vec4(2.0 * (start + u * unit + v * vec2(-unit.y, unit.x)) / screen, 0, 1);
}`;

/** Solves the capsule on its quad. */
export const TUBE_FRAGMENT = `${REACH}
precision highp float;
uniform mat4 projectionMatrix;
uniform vec3 ground;
uniform vec2 fog;                    // where it begins and how deep it is, mm
flat in vec4 axis, depth;
flat in vec3 facing, colour;
flat in vec2 inverse;
out vec4 pixel;
float at(float key) {                // depth is linear in 1/z
  return 0.5 * (projectionMatrix[3][2] * key - projectionMatrix[2][2]) + 0.5;
}
// A power of 24: software draws it faster by products.
float glint(float x) {
  x *= x * x;
  x *= x;
  x *= x;
  return x * x;
}
void main() {
  vec2 offset = gl_FragCoord.xy - axis.xy;
  float t = clamp(dot(offset, axis.zw) * inverse.x, 0.0, 1.0);
  float key = depth.x + t * depth.y, radius = depth.z + t * depth.w;
  vec2 away = (offset - t * axis.zw) / radius;
  float rest = 1.0 - dot(away, away);
  if (rest < 1.0 - REACH * REACH) discard;
  float bulge = radius * inverse.y * key;   // of one radius, in 1/z
  if (rest < 0.0) {                     // a halo cuts what lies behind the strand
    gl_FragDepth = at(key - 5.0 * bulge);
    pixel = vec4(ground, 1);
  } else {
    float height = sqrt(rest);
    vec3 normal = vec3(away, 0) + height * (t > 0.0 && t < 1.0 ? facing : vec3(0, 0, 1));
    float lamp = max(dot(normal, vec3(-0.372, 0.558, 0.742)), 0.0);
    float shine = 0.2 * glint(max(dot(normal, vec3(-0.199, 0.299, 0.933)), 0.0));
    vec3 bright = colour * (0.55 + 0.55 * lamp) * mix(0.55, 1.0, min(height / 0.6, 1.0)) + shine;
    float far = clamp((1.0 / key - fog.x) / fog.y, 0.0, 1.0);
    gl_FragDepth = at(key + bulge * height);
    pixel = vec4(mix(min(bright, 1.0), ground, 0.5 * far), 1);
  }
}`;

/** A line of one pixel for each strand: while the view turns on a slow machine. */
export const LINE_VERTEX = `${COMMON}
out float far;
void main() {
  vec3 a, b;
  float thick;
  gl_Position = vec4(2, 2, 2, 1);
  if (!found(gl_VertexID / 2, a, b, thick)) return;
  vec3 end = gl_VertexID % 2 == 0 ? a : b;
  far = -end.z;
  gl_Position = projectionMatrix * vec4(end, 1);
}`;

export const LINE_FRAGMENT = `
precision highp float;
uniform vec3 ground;
uniform vec2 fog;
flat in vec3 colour;
in float far;
out vec4 pixel;
void main() {
  pixel = vec4(mix(colour * 0.9, ground, 0.5 * clamp((far - fog.x) / fog.y, 0.0, 1.0)), 1);
}`;
