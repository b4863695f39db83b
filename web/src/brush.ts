// The brush: a drag over the model becomes a stroke, which is shown at once and sent when it ends.
import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineLoop, Vector3 } from "three";
import type { Point } from "./protocol";
import * as store from "./store";
import type { Hit, Pending, Stroke } from "./surface";
import { palette } from "./theme";
import type { View } from "./view";

/** Points of a stroke lie so far apart, as a share of the brush's radius. */
const STEP = 0.25;
/** Where the surface jumps by more radii than this between two of them, another stroke begins. */
const JUMP = 3;
/** Most points of a stroke; the preview's texture holds more. */
const MOST_POINTS = 1500;
/** Coordinates are sent to this, mm. */
const DIGITS = 1e4;
const AROUND = 64;

interface Sent extends Pending {
  /** The mark's number and the change that it came with, once the session took it. */
  number: number | null;
  revision: number | null;
}

export class Brush {
  private sent: Sent[] = [];
  private stroke: { shape: Stroke; erase: boolean } | null = null;
  private finished: { shape: Stroke; erase: boolean }[] = [];
  private pointer = -1;
  private last: { x: number; y: number; hit: Hit | null } | null = null;
  private readonly ring: LineLoop<BufferGeometry, LineBasicMaterial>;

  constructor(
    private readonly view: View,
    private readonly host: HTMLElement,
    private readonly send: (shape: Stroke, erase: boolean) => Promise<{ number: number; revision: number }>,
  ) {
    const circle = new Float32Array(AROUND * 3);
    for (let i = 0; i < AROUND; i++)
      circle.set([Math.cos((2 * Math.PI * i) / AROUND), Math.sin((2 * Math.PI * i) / AROUND), 0], 3 * i);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(circle, 3));
    this.ring = new LineLoop(geometry, new LineBasicMaterial({ depthTest: false }));
    this.ring.visible = false;
    this.ring.renderOrder = 11;
    view.scene.add(this.ring);
    host.addEventListener("pointerdown", (event) => this.down(event), { capture: true });
    host.addEventListener("pointermove", (event) => this.move(event), { capture: true });
    for (const name of ["pointerup", "pointercancel"] as const)
      host.addEventListener(name, (event) => this.up(event, name === "pointercancel"), { capture: true });
    host.addEventListener("pointerleave", () => this.hover(null));
    store.tool.subscribe(() => this.hover(null));
    store.radiusMm.subscribe((radius) => {
      this.ring.scale.setScalar(radius);
      view.stir();
    });
  }

  /** Forgets the strokes that a print, or the list of marks, has answered. */
  answered(revision: number): void {
    this.sent = this.sent.filter((one) => one.revision === null || one.revision > revision);
    this.show();
  }

  /** Forgets the strokes that were undone. */
  kept(numbers: ReadonlySet<number>): void {
    this.sent = this.sent.filter((one) => one.number === null || numbers.has(one.number));
    this.show();
  }

  private down(event: PointerEvent): void {
    if (this.pointer >= 0) {
      // A second finger means to zoom or move, not to paint.
      this.abandon();
      return;
    }
    const paints = store.tool.value !== "turn" && event.button === 0 && !event.altKey && event.isPrimary;
    if (!paints || event.target !== this.host.querySelector("canvas")) return;
    const hit = this.pick(event);
    if (!hit) return;
    event.stopPropagation();
    this.pointer = event.pointerId;
    this.host.setPointerCapture(event.pointerId);
    this.begin(hit);
    this.last = { x: event.clientX, y: event.clientY, hit };
    this.show();
  }

  private move(event: PointerEvent): void {
    if (this.pointer < 0) {
      const looks = store.tool.value !== "turn" && event.buttons === 0 && event.pointerType !== "touch";
      if (looks) this.hover(this.pick(event));
      return;
    }
    if (event.pointerId !== this.pointer) return;
    event.stopPropagation();
    // All places that the pointer was at, not only the last before this frame.
    const passed = event.getCoalescedEvents?.() ?? [];
    for (const one of passed.length ? passed : [event]) this.reach(one.clientX, one.clientY);
    this.show();
  }

  private up(event: PointerEvent, cancelled: boolean): void {
    if (event.pointerId !== this.pointer) return;
    event.stopPropagation();
    this.pointer = -1;
    if (cancelled) this.abandon();
    else this.end();
  }

  /** Goes on to a place of the window, over the surface between. */
  private reach(x: number, y: number): void {
    const last = this.last!;
    const radiusPx = this.radius / this.view.mmPerPixel((last.hit ?? this.onScreen()).placed);
    const steps = Math.min(Math.ceil(Math.hypot(x - last.x, y - last.y) / Math.max(radiusPx * STEP, 1.5)), 200);
    const from = { x: last.x, y: last.y };
    for (let i = 1; i <= steps; i++) {
      const [u, v] = [from.x + ((x - from.x) * i) / steps, from.y + ((y - from.y) * i) / steps];
      this.extend(this.view.surface.pick(this.view.place(u, v), this.view.camera));
    }
    Object.assign(last, { x, y });
  }

  private extend(hit: Hit | null): void {
    this.last!.hit = hit;
    this.hover(hit);
    if (!hit) {
      this.finish();
      return;
    }
    const before = this.stroke?.shape.points_mm.at(-1);
    const far = before ? hit.point.distanceTo(new Vector3(...before)) : Infinity;
    if (!this.stroke || far > JUMP * this.radius || this.stroke.shape.points_mm.length >= MOST_POINTS) {
      this.finish();
      this.begin(hit);
    } else if (far >= STEP * this.radius) {
      this.stroke.shape.points_mm.push(rounded(hit.point));
      this.stroke.shape.normals.push(rounded(hit.normal));
    }
  }

  private begin(hit: Hit): void {
    const shape: Stroke = {
      kind: "stroke",
      points_mm: [rounded(hit.point)],
      normals: [rounded(hit.normal)],
      radius_mm: this.radius,
      spread_deg: store.spreadDeg.value,
    };
    this.stroke = { shape, erase: store.tool.value === "erase" };
    this.hover(hit);
  }

  private finish(): void {
    if (this.stroke) this.finished.push(this.stroke);
    this.stroke = null;
  }

  private end(): void {
    this.finish();
    const strokes = this.finished;
    this.finished = [];
    this.last = null;
    for (const { shape, erase } of strokes) {
      const one: Sent = { shape, erase, number: null, revision: null };
      this.sent.push(one);
      this.send(shape, erase).then(
        ({ number, revision }) => {
          Object.assign(one, { number, revision });
          this.answered(store.printed.value);
        },
        () => {
          this.sent = this.sent.filter((other) => other !== one);
          this.show();
        },
      );
    }
    this.show();
  }

  private abandon(): void {
    this.pointer = -1;
    this.stroke = this.last = null;
    this.finished = [];
    this.hover(null);
    this.show();
  }

  private show(): void {
    this.view.surface.preview([...this.sent, ...this.finished, ...(this.stroke ? [this.stroke] : [])]);
    this.view.stir();
  }

  /** Draws the brush where it would paint. */
  private hover(hit: Hit | null): void {
    this.ring.visible = hit !== null;
    if (hit) {
      this.ring.position.copy(hit.placed);
      this.ring.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), hit.facing);
      this.ring.material.color.copy(store.tool.value === "erase" ? palette().breach : palette().accent);
    }
    this.view.stir();
  }

  private pick(event: PointerEvent): Hit | null {
    return this.view.surface.pick(this.view.place(event.clientX, event.clientY), this.view.camera);
  }

  private onScreen(): { placed: Vector3 } {
    return { placed: this.view.controls.target };
  }

  private get radius(): number {
    return store.radiusMm.value;
  }
}

function rounded(vector: Vector3): Point {
  return vector.toArray().map((number) => Math.round(number * DIGITS) / DIGITS) as Point;
}
