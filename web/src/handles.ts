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
import type { Item, Point, Rows, Shape } from "./protocol";
import { palette } from "./theme";
import type { View } from "./view";

type Solid = Exclude<Shape, { kind: "stroke" }>;

/** A handle is so large on the screen, and caught from so far, pixels. */
const SIZE_PX = 6;
const CATCH_PX = 16;
const AROUND = 64;
/** Sizes and places are set to this, mm. */
const DIGITS = 100;
const LEAST_MM = 0.2;

/** Something to pull at, in the shape's own frame. */
interface Handle {
  at: Vector3;
  /** The line that it moves along; null: the plane that faces the viewer. */
  axis: Vector3 | null;
  pulled: (to: Vector3) => Solid;
}

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

function rounded(number: number): number {
  return Math.round(number * DIGITS) / DIGITS;
}

function point(vector: Vector3): Point {
  return vector.toArray().map(rounded) as Point;
}

function handlesOf(shape: Solid, model: Box3): Handle[] {
  const centre = model.getCenter(new Vector3());
  switch (shape.kind) {
    case "box": {
      const [low, high] = [new Vector3(...shape.low_mm), new Vector3(...shape.high_mm)];
      const middle = low.clone().add(high).multiplyScalar(0.5);
      const faces = ([0, 1, 2] as const).flatMap((axis) =>
        ([0, 1] as const).map((side): Handle => {
          const unit = new Vector3().setComponent(axis, 1);
          const at = middle.clone().setComponent(axis, (side ? high : low).getComponent(axis));
          return {
            at,
            axis: unit,
            pulled: (to) => {
              const [newLow, newHigh] = [low.clone(), high.clone()];
              const place = to.getComponent(axis);
              if (side) newHigh.setComponent(axis, Math.max(place, low.getComponent(axis) + LEAST_MM));
              else newLow.setComponent(axis, Math.min(place, high.getComponent(axis) - LEAST_MM));
              return { kind: "box", low_mm: point(newLow), high_mm: point(newHigh) };
            },
          };
        }),
      );
      const whole: Handle = {
        at: middle,
        axis: null,
        pulled: (to) => {
          const by = to.clone().sub(middle);
          return { kind: "box", low_mm: point(low.clone().add(by)), high_mm: point(high.clone().add(by)) };
        },
      };
      return [...faces, whole];
    }
    case "sphere": {
      const middle = new Vector3(...shape.centre_mm);
      const sizes = [new Vector3(1, 0, 0), new Vector3(0, 0, 1), new Vector3(0, -1, 0)].map(
        (axis): Handle => ({
          at: middle.clone().addScaledVector(axis, shape.radius_mm),
          axis,
          pulled: (to) => ({ ...shape, radius_mm: Math.max(rounded(to.distanceTo(middle)), LEAST_MM) }),
        }),
      );
      return [...sizes, { at: middle, axis: null, pulled: (to) => ({ ...shape, centre_mm: point(to) }) }];
    }
    case "z": {
      const axis = new Vector3(0, 0, 1);
      const low = shape.low_mm ?? model.min.z;
      const high = shape.high_mm ?? model.max.z;
      return [
        {
          at: centre.clone().setZ(low),
          axis,
          pulled: (to) => ({ ...shape, low_mm: rounded(Math.min(to.z, high - LEAST_MM)) }),
        },
        {
          at: centre.clone().setZ(high),
          axis,
          pulled: (to) => ({ ...shape, high_mm: rounded(Math.max(to.z, low + LEAST_MM)) }),
        },
      ];
    }
    case "half": {
      const { normal, foot, reach } = plane(shape, model);
      return [
        { at: foot, axis: normal, pulled: (to) => ({ ...shape, offset_mm: rounded(to.dot(normal)) }) },
        {
          at: foot.clone().addScaledVector(normal, 0.5 * reach),
          axis: null,
          pulled: (to) => {
            const turned = to.clone().sub(foot);
            if (turned.length() < 1e-3) return shape;
            turned.normalize();
            const kept = turned.toArray().map((number) => Math.round(number * 1e4) / 1e4) as Point;
            return { kind: "half", normal: kept, offset_mm: rounded(new Vector3(...kept).normalize().dot(foot)) };
          },
        },
      ];
    }
  }
}

/** A half-space's unit normal, its plane's point nearest to the model's middle, and the model's reach. */
function plane(shape: Extract<Solid, { kind: "half" }>, model: Box3) {
  const normal = new Vector3(...shape.normal).normalize();
  const centre = model.getCenter(new Vector3());
  const foot = centre.clone().addScaledVector(normal, shape.offset_mm - normal.dot(centre));
  return { normal, foot, reach: model.getSize(new Vector3()).length() / 2 };
}

/** Ends of the lines that show a shape, in its own frame. */
function outlineOf(shape: Solid, model: Box3): number[] {
  switch (shape.kind) {
    case "box":
      return boxEdges(new Vector3(...shape.low_mm), new Vector3(...shape.high_mm));
    case "sphere": {
      const middle = new Vector3(...shape.centre_mm);
      const unit = (axis: number) => new Vector3().setComponent(axis, shape.radius_mm);
      return [0, 1, 2].flatMap((axis) => circle(middle, unit(axis), unit((axis + 1) % 3)));
    }
    case "z": {
      const [low, high] = [model.min.clone(), model.max.clone()];
      const wider = 0.06 * high.distanceTo(low);
      low.subScalar(wider).setZ(shape.low_mm ?? model.min.z);
      high.addScalar(wider).setZ(shape.high_mm ?? model.max.z);
      return boxEdges(low, high);
    }
    case "half": {
      const { normal, foot, reach } = plane(shape, model);
      const across = new Vector3(0, 0, 1).cross(normal);
      if (across.length() < 1e-6) across.set(1, 0, 0);
      across.setLength(reach);
      const along = normal.clone().cross(across);
      const corners = [
        [1, 1],
        [-1, 1],
        [-1, -1],
        [1, -1],
      ].map(([u, v]) => foot.clone().addScaledVector(across, u!).addScaledVector(along, v!));
      const edge = corners.flatMap((corner, i) => [...corner.toArray(), ...corners[(i + 1) % 4]!.toArray()]);
      return [...edge, ...foot.toArray(), ...foot.clone().addScaledVector(normal, 0.5 * reach).toArray()];
    }
  }
}

function circle(middle: Vector3, u: Vector3, v: Vector3): number[] {
  const at = (i: number) => {
    const turn = (2 * Math.PI * i) / AROUND;
    return middle.clone().addScaledVector(u, Math.cos(turn)).addScaledVector(v, Math.sin(turn)).toArray();
  };
  return Array.from({ length: AROUND }, (_, i) => [...at(i), ...at(i + 1)]).flat();
}

function boxEdges(low: Vector3, high: Vector3): number[] {
  const corner = (bits: number) =>
    [0, 1, 2].map((axis) => ((bits >> axis) & 1 ? high : low).getComponent(axis));
  const found: number[] = [];
  for (let bits = 0; bits < 8; bits++)
    for (let axis = 0; axis < 3; axis++)
      if (!((bits >> axis) & 1)) found.push(...corner(bits), ...corner(bits | (1 << axis)));
  return found;
}
