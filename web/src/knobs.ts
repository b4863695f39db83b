// Where a shape that marks can be pulled at, and what becomes of it.
import { Box3, Vector3 } from "three";
import { planeOf, type Solid } from "./outlines";
import type { Point } from "./protocol";

/** Sizes and places are set to this, mm. */
const DIGITS = 100;
const LEAST_MM = 0.2;

/** Something to pull at, in the shape's own frame. */
export interface Handle {
  at: Vector3;
  /** The line that it moves along; null: the plane that faces the viewer. */
  axis: Vector3 | null;
  pulled: (to: Vector3) => Solid;
}

function rounded(number: number): number {
  return Math.round(number * DIGITS) / DIGITS;
}

function point(vector: Vector3): Point {
  return vector.toArray().map(rounded) as Point;
}

export function handlesOf(shape: Solid, model: Box3): Handle[] {
  switch (shape.kind) {
    case "box":
      return ofBox(shape);
    case "sphere":
      return ofSphere(shape);
    case "z":
      return ofHeights(shape, model);
    case "half":
      return ofHalf(shape, model);
  }
}

type Kind<K extends Solid["kind"]> = Extract<Solid, { kind: K }>;

/** One on each face, and one to move all of it. */
function ofBox(shape: Kind<"box">): Handle[] {
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

function ofSphere(shape: Kind<"sphere">): Handle[] {
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

function ofHeights(shape: Kind<"z">, model: Box3): Handle[] {
  const centre = model.getCenter(new Vector3());
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

/** One to move the plane, and one to turn it. */
function ofHalf(shape: Kind<"half">, model: Box3): Handle[] {
  const { normal, foot, reach } = planeOf(shape, model);
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
