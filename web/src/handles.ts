// Shapes that mark: their outline, and the handles by which they are moved and sized.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Plane,
  Ray,
  Raycaster,
  SphereGeometry,
  Vector3,
} from "three";
import { handlesOf, type Handle } from "./knobs";
import { outlineOf, type Solid } from "./outlines";
import type { Item, Rows } from "./protocol";
import { palette } from "./theme";
import type { View } from "./view";

/** A handle is so large on the screen, and caught from so far, pixels. */
const SIZE_PX = 6;
const CATCH_PX = 16;

export class Handles {
  private readonly group = new Group();
  private readonly outline = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ depthTest: false }));
  private readonly knobs = new Group();
  private readonly caster = new Raycaster();
  private item: Item | null = null;
  private shape: Solid | null = null;
  private handles: Handle[] = [];
  private held: { index: number; pointer: number } | null = null;

  constructor(
    private readonly view: View,
    private readonly host: HTMLElement,
    private readonly changed: (number: number, shape: Solid, frame: Rows | null) => void,
  ) {
    this.group.matrixAutoUpdate = false;
    this.outline.renderOrder = 12;
    this.outline.frustumCulled = false;
    this.group.add(this.outline, this.knobs);
    view.scene.add(this.group);
    view.scene.onBeforeRender = () => this.fit();
    host.addEventListener("pointerdown", (event) => this.down(event), { capture: true });
    host.addEventListener("pointermove", (event) => this.move(event), { capture: true });
    for (const name of ["pointerup", "pointercancel"] as const)
      host.addEventListener(name, (event) => this.up(event), { capture: true });
  }

  /** Shows the handles of a mark; those of paint do not exist. */
  show(item: Item | null): void {
    if (this.held) return;
    this.item = item;
    const kind = item?.shape.kind;
    this.shape = item && kind !== "stroke" && kind !== "mask" ? (item.shape as Solid) : null;
    this.draw();
  }

  private draw(): void {
    this.group.visible = this.shape !== null;
    if (this.shape && this.item) {
      this.group.matrix.copy(this.view.surface.matrix).multiply(matrixOf(this.item.frame));
      this.group.updateMatrixWorld(true);
      const box = this.view.surface.body.geometry.boundingBox ?? new Box3(new Vector3(), new Vector3(1, 1, 1));
      const own = box.clone().applyMatrix4(matrixOf(this.item.frame).invert());
      this.handles = handlesOf(this.shape, own);
      this.outline.geometry.dispose();
      this.outline.geometry = new BufferGeometry();
      const lines = new Float32Array(outlineOf(this.shape, own));
      this.outline.geometry.setAttribute("position", new BufferAttribute(lines, 3));
      const colour = this.item.erase ? palette().breach : palette().accent;
      this.outline.material.color.copy(colour);
      this.setKnobs(colour);
    }
    this.view.stir();
  }

  private setKnobs(colour: Color): void {
    while (this.knobs.children.length < this.handles.length) {
      const knob = new Mesh(new SphereGeometry(1, 20, 14), new MeshBasicMaterial({ depthTest: false }));
      knob.renderOrder = 13;
      this.knobs.add(knob);
    }
    this.knobs.children.forEach((child, i) => {
      const knob = child as Mesh<SphereGeometry, MeshBasicMaterial>;
      const handle = this.handles[i];
      knob.visible = handle !== undefined;
      if (!handle) return;
      knob.position.copy(handle.at);
      knob.material.color.copy(colour);
    });
    this.fit();
  }

  /** Keeps knobs as large on the screen as they are. */
  private fit(): void {
    if (!this.group.visible) return;
    const stretch = this.group.matrix.getMaxScaleOnAxis();
    for (const knob of this.knobs.children) {
      const size = (SIZE_PX * this.view.mmPerPixel(this.placed(knob.position))) / stretch;
      knob.scale.setScalar(Math.max(size, 1e-6));
      knob.updateMatrixWorld(true);
    }
  }

  private placed(own: Vector3): Vector3 {
    return own.clone().applyMatrix4(this.group.matrix);
  }

  private down(event: PointerEvent): void {
    if (!this.shape || event.button !== 0 || event.target !== this.host.querySelector("canvas")) return;
    const index = this.nearest(event);
    if (index < 0) return;
    event.stopImmediatePropagation();
    this.host.setPointerCapture(event.pointerId);
    this.held = { index, pointer: event.pointerId };
  }

  private move(event: PointerEvent): void {
    if (!this.held || event.pointerId !== this.held.pointer) return;
    event.stopImmediatePropagation();
    const handle = this.handles[this.held.index]!;
    const to = this.pull(handle, event);
    if (!to) return;
    this.shape = handle.pulled(to);
    this.draw();
  }

  private up(event: PointerEvent): void {
    if (!this.held || event.pointerId !== this.held.pointer) return;
    event.stopImmediatePropagation();
    this.held = null;
    if (this.item && this.shape) this.changed(this.item.number, this.shape, this.item.frame);
  }

  /** The handle under the pointer; −1: none. */
  private nearest(event: PointerEvent): number {
    const box = this.host.querySelector("canvas")!.getBoundingClientRect();
    let [found, least] = [-1, CATCH_PX];
    this.handles.forEach((handle, i) => {
      const seen = this.placed(handle.at).project(this.view.camera);
      const x = box.left + ((seen.x + 1) / 2) * box.width;
      const y = box.top + ((1 - seen.y) / 2) * box.height;
      const away = Math.hypot(event.clientX - x, event.clientY - y);
      if (away < least) [found, least] = [i, away];
    });
    return found;
  }

  /** Where a handle is pulled to, in the shape's own frame. */
  private pull(handle: Handle, event: PointerEvent): Vector3 | null {
    this.caster.setFromCamera(this.view.place(event.clientX, event.clientY), this.view.camera);
    const inverse = this.group.matrix.clone().invert();
    const ray = this.caster.ray.clone().applyMatrix4(inverse);
    if (handle.axis) return alongAxis(ray, handle.at, handle.axis);
    const toward = this.view.camera.getWorldDirection(new Vector3()).transformDirection(inverse);
    return ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(toward, handle.at), new Vector3());
  }
}

/** The place on a line that is nearest to a ray. */
function alongAxis(ray: Ray, at: Vector3, axis: Vector3): Vector3 | null {
  const unit = axis.clone().normalize();
  const between = at.clone().sub(ray.origin);
  const cosine = unit.dot(ray.direction);
  const narrow = 1 - cosine * cosine;
  if (narrow < 1e-4) return null;
  const along = (cosine * ray.direction.dot(between) - unit.dot(between)) / narrow;
  return at.clone().addScaledVector(unit, along);
}

function matrixOf(rows: Rows | null): Matrix4 {
  if (!rows) return new Matrix4();
  return new Matrix4().set(...([...rows.flat(), 0, 0, 0, 1] as Parameters<Matrix4["set"]>));
}
