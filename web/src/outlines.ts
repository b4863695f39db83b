// The lines that show a shape which marks.
import { Box3, Vector3 } from "three";
import type { Shape } from "./protocol";

/** A shape that is no paint. */
export type Solid = Exclude<Shape, { kind: "stroke" }>;

const AROUND = 64;

/** A half-space's unit normal, its plane's point nearest to the model's middle, and the model's reach. */
export function planeOf(shape: Extract<Solid, { kind: "half" }>, model: Box3) {
  const normal = new Vector3(...shape.normal).normalize();
  const centre = model.getCenter(new Vector3());
  const foot = centre.clone().addScaledVector(normal, shape.offset_mm - normal.dot(centre));
  return { normal, foot, reach: model.getSize(new Vector3()).length() / 2 };
}

/** Ends of the lines that show a shape, in its own frame. */
export function outlineOf(shape: Solid, model: Box3): number[] {
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
      const { normal, foot, reach } = planeOf(shape, model);
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
