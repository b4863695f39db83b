// All strands in one draw call, as tubes or as thin lines, by the time that is shown.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  type DataTexture,
  DoubleSide,
  GLSL3,
  LineSegments,
  Mesh,
  RawShaderMaterial,
  Vector2,
  Vector3,
  Vector4,
  Sphere,
} from "three";
import type { Label, Print } from "./protocol";
import {
  CORNERS,
  LINE_FRAGMENT,
  LINE_VERTEX,
  MOST_KINDS,
  TRIANGLES,
  TUBE_FRAGMENT,
  TUBE_VERTEX,
} from "./strandshaders";
import { amounts, texels } from "./textures";
import { RAMP, type Palette } from "./theme";

/** Figures of a forecast; see forecast_scales.py. */
export const FIGURES = ["sag", "compliance", "flow", "weld"] as const;
export type Figure = (typeof FIGURES)[number];
export type Mode = "feature" | "time" | "speed" | "slab" | "breach" | Figure;

export function isFigure(mode: Mode): mode is Figure {
  return (FIGURES as readonly string[]).includes(mode);
}

function rgb([r, g, b]: [number, number, number]): Vector3 {
  return new Vector3(r / 255, g / 255, b / 255);
}

/** How many of the first numbers up to a count are below something, which all after them are not. */
function countBelow(count: number, isBelow: (number: number) => boolean): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (isBelow(middle)) low = middle + 1;
    else high = middle;
  }
  return low;
}

export class Strands extends Mesh<BufferGeometry, RawShaderMaterial> {
  count = 0;
  /** Start and end of each strand, s, by twos. */
  when = new Float32Array();
  private speed = new Float32Array();
  private packed = new Uint32Array();
  private totalS = 0;
  private figures: Partial<Record<Figure, Float32Array>> = {};
  /** What strands relax to, as texels, and the strand in which each ends, ascending; null: not known. */
  private relaxed: { packed: Uint32Array; of: Uint32Array } | null = null;
  private relaxes = false;
  private mode: Mode = "feature";
  private untilS = Infinity;
  private slabCount = 1;
  /** So many strands have their corners numbered. */
  private room = 0;
  private readonly lines: LineSegments<BufferGeometry, RawShaderMaterial>;

  constructor() {
    const material = new RawShaderMaterial({
      side: DoubleSide,
      glslVersion: GLSL3,
      vertexShader: TUBE_VERTEX,
      fragmentShader: TUBE_FRAGMENT,
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
    const thin = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: LINE_VERTEX,
      fragmentShader: LINE_FRAGMENT,
      uniforms: material.uniforms,
    });
    this.lines = new LineSegments(new BufferGeometry(), thin);
    for (const drawn of [this, this.lines]) {
      drawn.frustumCulled = false;
      drawn.geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
      drawn.geometry.setDrawRange(0, 0);
      drawn.onBeforeRender = (renderer, _scene, camera) => {
        const uniforms = material.uniforms;
        renderer.getDrawingBufferSize(uniforms.screen!.value as Vector2);
        uniforms.near!.value = (camera as unknown as { near: number }).near;
        drawn.material.uniformsNeedUpdate = true;
      };
    }
    this.add(this.lines);
    this.thin = false;
  }

  /** Whether strands are drawn as thin lines, which slow machines draw faster. */
  get thin(): boolean {
    return this.lines.visible;
  }

  set thin(thin: boolean) {
    this.lines.visible = thin;
    // A mesh whose material is not drawn still draws its children.
    this.material.visible = !thin;
  }

  /** Takes a new print; what is drawn of it stays as it was chosen. */
  take(print: Print, strands: Uint32Array, when: Float32Array, speed: Float32Array): void {
    const uniforms = this.material.uniforms;
    this.count = strands.length / 4;
    this.when = when as Float32Array<ArrayBuffer>;
    this.speed = speed as Float32Array<ArrayBuffer>;
    this.packed = strands as Uint32Array<ArrayBuffer>;
    this.totalS = print.total_s;
    this.figures = {};
    this.relaxed = null;
    this.slabCount = print.slabs_mm.length;
    (uniforms.low!.value as Vector3).fromArray(print.low);
    (uniforms.span!.value as Vector3).fromArray(print.span);
    uniforms.diameterStep!.value = print.diameter_step_mm;
    this.fill();
  }

  /** Takes what the strands of this print relax to. */
  hang(packed: Uint32Array, of: Uint32Array): void {
    this.relaxed = { packed, of };
    this.fill();
  }

  /** Draws strands as they hang, where that is known, or as commanded. */
  relax(relaxes: boolean): void {
    this.relaxes = relaxes;
    this.fill();
  }

  /** Fills the textures with what is drawn, up to the time that is shown. */
  private fill(): void {
    const uniforms = this.material.uniforms;
    (uniforms.strands!.value as DataTexture).dispose();
    const packed = this.drawn?.packed ?? this.packed;
    uniforms.strands!.value = texels(packed);
    this.reserve(packed.length / 4);
    this.colourBy(this.mode);
    this.showUntil(this.untilS);
  }

  /** Numbers the corners of at least so many strands: corners that two triangles share are placed once. */
  private reserve(count: number): void {
    if (count <= this.room) return;
    this.room = Math.max(count, 2 * this.room);
    const numbers = new Uint32Array(TRIANGLES.length * this.room);
    for (let i = 0; i < numbers.length; i++)
      numbers[i] = CORNERS * Math.floor(i / TRIANGLES.length) + TRIANGLES[i % TRIANGLES.length]!;
    // What is drawn of it follows; the buffer that it replaces is let go.
    this.geometry.dispose();
    this.geometry.setIndex(new BufferAttribute(numbers, 1));
  }

  /** What is drawn in place of the strands. */
  private get drawn(): { packed: Uint32Array; of: Uint32Array } | null {
    return this.relaxes ? this.relaxed : null;
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
    this.mode = mode;
    const uniforms = this.material.uniforms;
    uniforms.mode!.value = mode === "feature" ? 0 : mode === "breach" ? 2 : 1;
    if (mode === "feature" || mode === "breach") return [0, 0];
    if (isFigure(mode)) {
      this.setShares(this.figures[mode] ?? new Float32Array(this.count).fill(-1));
      return [0, 1];
    }
    const [value, low, high] = this.amounts(mode);
    const shares = new Float32Array(this.count);
    for (let i = 0; i < this.count; i++) shares[i] = Math.max((value(i) - low) / Math.max(high - low, 1e-9), 0);
    this.setShares(shares);
    return [low, high];
  }

  /** Takes what the strands would do: shares by figure, below 0 where there is none. */
  foretell(figures: Partial<Record<Figure, Float32Array>>): void {
    this.figures = figures;
  }

  private setShares(shares: Float32Array): void {
    const uniforms = this.material.uniforms;
    (uniforms.values!.value as DataTexture).dispose();
    const of = this.drawn?.of;
    uniforms.values!.value = amounts(of ? Float32Array.from(of, (strand) => shares[strand] ?? -1) : shares);
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
    this.untilS = timeS;
    const uniforms = this.material.uniforms;
    const begun = this.begunBy(timeS);
    uniforms.last!.value = -1;
    if (begun > 0) {
      const [from, to] = [this.when[2 * begun - 2]!, this.when[2 * begun - 1]!];
      if (timeS < to) {
        const piece = this.drawnOf(begun) - 1;
        // Of a chord that ends in a later strand nothing is drawn yet.
        const isDrawn = (this.drawn?.of[piece] ?? begun - 1) === begun - 1;
        uniforms.last!.value = isDrawn ? piece : -1;
        uniforms.laid!.value = (timeS - from) / Math.max(to - from, 1e-6);
      }
    }
    const drawn = this.drawnOf(begun);
    this.geometry.setDrawRange(0, TRIANGLES.length * drawn);
    this.lines.geometry.setDrawRange(0, 2 * drawn);
    return begun;
  }

  /** How many pieces are drawn where so many strands are begun. */
  private drawnOf(begun: number): number {
    const of = this.drawn?.of;
    return of ? countBelow(of.length, (i) => of[i]! < begun) : begun;
  }

  /** How many strands are begun before a time, s. */
  begunBy(timeS: number): number {
    return countBelow(this.count, (i) => this.when[2 * i]! < timeS);
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
