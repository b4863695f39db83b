// All strands in one draw call: a strand is one texel, and its quad is found by the vertex's number.
import {
  BufferGeometry,
  Color,
  DataTexture,
  DoubleSide,
  FloatType,
  GLSL3,
  Mesh,
  NearestFilter,
  RawShaderMaterial,
  RedFormat,
  RGBAIntegerFormat,
  UnsignedIntType,
  Vector2,
  Vector3,
  Vector4,
  Sphere,
} from "three";
import type { Label, Print } from "./protocol";
import { RAMP, type Palette } from "./theme";

export type Mode = "feature" | "time" | "speed" | "slab" | "breach";

const WIDTH = 2048;
const MOST_KINDS = 64;
/** The bit of a kind that says that the strand breaks a rule; see drawing.py. */
const BREACH_BIT = 0x80;

const VERTEX = `
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
flat out vec4 axis;                  // start and direction on the screen, pixels
flat out vec4 depth;                 // 1/z and its step, radius and its step
flat out vec3 facing, colour;
vec3 ramped(float value) {
  float place = clamp(value, 0.0, 1.0) * float(${RAMP.length - 1});
  int below = int(min(place, float(${RAMP.length - 2})));
  return mix(ramp[below], ramp[below + 1], place - float(below));
}
void main() {
  int strand = gl_VertexID / 6, corner = gl_VertexID % 6;
  ivec2 texel = ivec2(strand % ${WIDTH}, strand / ${WIDTH});
  uvec4 packed = texelFetch(strands, texel, 0);
  vec3 from = vec3(packed.x & 0xffffu, packed.x >> 16, packed.y & 0xffffu) / 65535.0;
  vec3 to = vec3(packed.y >> 16, packed.z & 0xffffu, packed.z >> 16) / 65535.0;
  uint kindBits = packed.w & 0xffu;
  vec4 kind = kinds[min(kindBits & 0x7fu, ${MOST_KINDS - 1}u)];
  bool broken = (kindBits & ${BREACH_BIT}u) != 0u;
  gl_Position = vec4(2, 2, 2, 1);
  if (kind.a == 0.0 && !(mode == 2 && broken)) return;
  if (float(packed.w >> 16) > slabTop) return;
  vec3 a = (modelViewMatrix * vec4(low + from * span, 1)).xyz;
  vec3 b = (modelViewMatrix * vec4(low + to * span, 1)).xyz;
  if (strand == last) b = mix(a, b, laid);
  float nearest = -near * 1.01;
  if (min(a.z, b.z) > nearest) return;
  if (a.z > nearest) a = mix(b, a, (nearest - b.z) / (a.z - b.z));
  if (b.z > nearest) b = mix(a, b, (nearest - a.z) / (b.z - a.z));
  float focal = projectionMatrix[1][1] * screen.y * 0.5;
  vec2 key = -1.0 / vec2(a.z, b.z);
  float thick = float((packed.w >> 8) & 0xffu) * diameterStep;
  vec2 radius = max(thick * 0.5 * focal * key, 0.6);
  vec2 start = focal * a.xy * key.x, along = focal * b.xy * key.y - start;
  vec3 direction = normalize(b - a + vec3(0, 0, 1e-9));
  axis = vec4(start + screen * 0.5, along);
  depth = vec4(key.x, key.y - key.x, radius.x, radius.y - radius.x);
  facing = normalize(vec3(0, 0, 1) - direction * direction.z + vec3(0, 0, 1e-6));
  if (mode == 0) colour = kind.rgb;
  else if (mode == 1) colour = ramped(texelFetch(values, texel, 0).r);
  else colour = broken ? breach : faint;
  float reach = max(radius.x, radius.y) * 1.35 + 1.0, len = max(length(along), 1e-3);
  vec2 unit = length(along) > 1e-3 ? along / len : vec2(1, 0);
  float u = corner == 0 || corner == 1 || corner == 3 ? -reach : len + reach;
  float v = corner == 0 || corner == 2 || corner == 4 ? -reach : reach;
  gl_Position = vec4(2.0 * (start + u * unit + v * vec2(-unit.y, unit.x)) / screen, 0, 1);
}`;

const FRAGMENT = `
precision highp float;
uniform mat4 projectionMatrix;
uniform vec2 screen;
uniform vec3 ground;
uniform vec2 fog;                    // where it begins and how deep it is, mm
flat in vec4 axis, depth;
flat in vec3 facing, colour;
out vec4 pixel;
float at(float key) {                // depth is linear in 1/z
  return 0.5 * (projectionMatrix[3][2] * key - projectionMatrix[2][2]) + 0.5;
}
void main() {
  vec2 offset = gl_FragCoord.xy - axis.xy;
  float t = clamp(dot(offset, axis.zw) / max(dot(axis.zw, axis.zw), 1e-6), 0.0, 1.0);
  float key = depth.x + t * depth.y, radius = depth.z + t * depth.w;
  vec2 away = (offset - t * axis.zw) / radius;
  float rest = 1.0 - dot(away, away);
  if (rest < -0.75) discard;
  float focal = projectionMatrix[1][1] * screen.y * 0.5;
  float bulge = radius / focal * key;   // of one radius, in 1/z
  float far = clamp((1.0 / key - fog.x) / fog.y, 0.0, 1.0);
  if (rest < 0.0) {                     // a halo cuts what lies behind the strand
    gl_FragDepth = at(key - 5.0 * bulge);
    pixel = vec4(ground, 1);
  } else {
    float height = sqrt(rest);
    vec3 normal = vec3(away, 0) + height * (t > 0.0 && t < 1.0 ? facing : vec3(0, 0, 1));
    float lamp = max(dot(normal, vec3(-0.372, 0.558, 0.742)), 0.0);
    float shine = 0.2 * pow(max(dot(normal, vec3(-0.199, 0.299, 0.933)), 0.0), 24.0);
    vec3 bright = colour * (0.55 + 0.55 * lamp) * mix(0.55, 1.0, min(height / 0.6, 1.0)) + shine;
    gl_FragDepth = at(key + bulge * height);
    pixel = vec4(mix(min(bright, 1.0), ground, 0.5 * far), 1);
  }
}`;

function rgb([r, g, b]: [number, number, number]): Vector3 {
  return new Vector3(r / 255, g / 255, b / 255);
}

/** Rows of a texture that holds so many texels. */
function rowsFor(count: number): number {
  return Math.max(Math.ceil(count / WIDTH), 1);
}

function texels(strands: Uint32Array): DataTexture {
  const rows = rowsFor(strands.length / 4);
  const filled = new Uint32Array(WIDTH * rows * 4);
  filled.set(strands);
  const texture = new DataTexture(filled, WIDTH, rows, RGBAIntegerFormat, UnsignedIntType);
  texture.internalFormat = "RGBA32UI";
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

function amounts(shares: Float32Array): DataTexture {
  const rows = rowsFor(shares.length);
  const filled = new Float32Array(WIDTH * rows);
  filled.set(shares);
  const texture = new DataTexture(filled, WIDTH, rows, RedFormat, FloatType);
  texture.internalFormat = "R32F";
  texture.needsUpdate = true;
  return texture;
}

export class Strands extends Mesh<BufferGeometry, RawShaderMaterial> {
  count = 0;
  /** Start and end of each strand, s, by twos. */
  when = new Float32Array();
  private speed = new Float32Array();
  private packed = new Uint32Array();
  private totalS = 0;
  private slabCount = 1;

  constructor() {
    const material = new RawShaderMaterial({
      side: DoubleSide,
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        strands: { value: texels(new Uint32Array()) },
        values: { value: amounts(new Float32Array()) },
        screen: { value: new Vector2() },
        low: { value: new Vector3() },
        span: { value: new Vector3(1, 1, 1) },
        diameterStep: { value: 1 },
        slabTop: { value: Infinity },
        near: { value: 1 },
        kinds: { value: Array.from({ length: MOST_KINDS }, () => new Vector4(0, 0, 0, 0)) },
        ramp: { value: RAMP.map(rgb) },
        faint: { value: new Vector3() },
        breach: { value: new Vector3() },
        ground: { value: new Vector3() },
        fog: { value: new Vector2(0, 1) },
        mode: { value: 0 },
        last: { value: -1 },
        laid: { value: 1 },
      },
    });
    super(new BufferGeometry(), material);
    this.frustumCulled = false;
    this.geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    this.geometry.setDrawRange(0, 0);
    this.onBeforeRender = (renderer, _scene, camera) => {
      const uniforms = this.material.uniforms;
      renderer.getDrawingBufferSize(uniforms.screen!.value as Vector2);
      uniforms.near!.value = (camera as unknown as { near: number }).near;
      this.material.uniformsNeedUpdate = true;
    };
  }

  /** Takes a new print; what is drawn of it stays as it was chosen. */
  take(print: Print, strands: Uint32Array, when: Float32Array, speed: Float32Array): void {
    const uniforms = this.material.uniforms;
    this.count = strands.length / 4;
    this.when = when as Float32Array<ArrayBuffer>;
    this.speed = speed as Float32Array<ArrayBuffer>;
    this.packed = strands as Uint32Array<ArrayBuffer>;
    this.totalS = print.total_s;
    this.slabCount = print.slabs_mm.length;
    (uniforms.strands!.value as DataTexture).dispose();
    uniforms.strands!.value = texels(strands);
    (uniforms.low!.value as Vector3).fromArray(print.low);
    (uniforms.span!.value as Vector3).fromArray(print.span);
    uniforms.diameterStep!.value = print.diameter_step_mm;
  }

  /** Colours each kind, and leaves out those that are switched off. */
  paint(labels: Label[], hidden: ReadonlySet<string>, colours: Palette, dark: boolean): void {
    const uniforms = this.material.uniforms;
    const kinds = uniforms.kinds!.value as Vector4[];
    labels.slice(0, MOST_KINDS).forEach((label, i) => {
      const { x, y, z } = rgb(label.colour);
      const lift = dark ? 0.14 : 0;
      kinds[i]!.set(x + (1 - x) * lift, y + (1 - y) * lift, z + (1 - z) * lift, hidden.has(label.label) ? 0 : 1);
    });
    const plain = (name: string, colour: Color) =>
      (uniforms[name]!.value as Vector3).setFromColor(colour.clone().convertLinearToSRGB());
    plain("faint", colours.faint);
    plain("breach", colours.breach);
    plain("ground", colours.ground);
  }

  /** Chooses what colours tell; returns what the ramp's ends stand for. */
  colourBy(mode: Mode): [number, number] {
    const uniforms = this.material.uniforms;
    uniforms.mode!.value = mode === "feature" ? 0 : mode === "breach" ? 2 : 1;
    if (mode === "feature" || mode === "breach") return [0, 0];
    const [value, low, high] = this.amounts(mode);
    const shares = new Float32Array(this.count);
    for (let i = 0; i < this.count; i++) shares[i] = (value(i) - low) / Math.max(high - low, 1e-9);
    (uniforms.values!.value as DataTexture).dispose();
    uniforms.values!.value = amounts(shares);
    return [low, high];
  }

  private amounts(mode: "time" | "speed" | "slab"): [(i: number) => number, number, number] {
    if (mode === "time") return [(i) => this.when[2 * i + 1]!, 0, this.totalS];
    if (mode === "slab") return [(i) => this.slabOf(i), 0, Math.max(this.slabCount - 1, 1)];
    const sorted = Float32Array.from(this.speed).sort();
    // A few short strands are far slower or faster than all others, and would take the whole ramp.
    const share = (part: number) => sorted[Math.floor(part * (sorted.length - 1))] ?? 0;
    return [(i) => this.speed[i]!, share(0.02), share(0.98)];
  }

  slabOf(strand: number): number {
    return (this.packed[4 * strand + 3] ?? 0) >>> 16;
  }

  /** Shows what is laid by a time, s; returns how many strands that are, the last one begun. */
  showUntil(timeS: number): number {
    const uniforms = this.material.uniforms;
    const begun = this.begunBy(timeS);
    uniforms.last!.value = -1;
    if (begun > 0) {
      const [from, to] = [this.when[2 * begun - 2]!, this.when[2 * begun - 1]!];
      if (timeS < to) {
        uniforms.last!.value = begun - 1;
        uniforms.laid!.value = (timeS - from) / Math.max(to - from, 1e-6);
      }
    }
    this.geometry.setDrawRange(0, 6 * begun);
    return begun;
  }

  /** How many strands are begun before a time, s. */
  begunBy(timeS: number): number {
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.when[2 * middle]! < timeS) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** Where the tip is at a time, s: on a strand, or on the way to the next one. */
  tipAt(timeS: number, into: Vector3): Vector3 | null {
    const begun = this.begunBy(timeS);
    if (begun === 0) return this.count ? this.end(0, 0, into) : null;
    const strand = begun - 1;
    const [from, to] = [this.when[2 * strand]!, this.when[2 * strand + 1]!];
    if (timeS < to || begun === this.count) {
      const share = Math.min((timeS - from) / Math.max(to - from, 1e-6), 1);
      const start = this.end(strand, 0, new Vector3());
      return this.end(strand, 1, into).sub(start).multiplyScalar(share).add(start);
    }
    const share = (timeS - to) / Math.max(this.when[2 * begun]! - to, 1e-6);
    const start = this.end(strand, 1, new Vector3());
    return this.end(begun, 0, into).sub(start).multiplyScalar(share).add(start);
  }

  hideAbove(slab: number): void {
    this.material.uniforms.slabTop!.value = slab;
  }

  fade(from: number, over: number): void {
    (this.material.uniforms.fog!.value as Vector2).set(from, over);
  }

  private end(strand: number, which: 0 | 1, into: Vector3): Vector3 {
    const [x, y, z] = [this.packed[4 * strand]!, this.packed[4 * strand + 1]!, this.packed[4 * strand + 2]!];
    const { low, span } = this.material.uniforms;
    if (which === 0) into.set(x & 0xffff, x >>> 16, y & 0xffff);
    else into.set(y >>> 16, z & 0xffff, z >>> 16);
    return into
      .divideScalar(65535)
      .multiply(span!.value as Vector3)
      .add(low!.value as Vector3);
  }
}
