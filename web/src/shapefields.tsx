// The numbers of a shape: what its handles set, by keyboard.
import type { JSX } from "preact";
import type { Item, Point, Shape } from "./protocol";
import type { Studio } from "./studio";

type Solid = Exclude<Shape, { kind: "stroke" }>;

interface Number_ {
  name: string;
  value: number | null;
  set: (value: number | null) => Solid;
}

function with_(point: Point, axis: number, value: number | null): Point {
  return point.map((old, i) => (i === axis ? (value ?? 0) : old)) as Point;
}

const AXES = ["x", "y", "z"];

function numbersOf(shape: Solid): Number_[] {
  switch (shape.kind) {
    case "box":
      return (["low_mm", "high_mm"] as const).flatMap((end) =>
        AXES.map((axis, i) => ({
          name: `${end === "low_mm" ? "from" : "to"} ${axis}`,
          value: shape[end][i]!,
          set: (value: number | null) => ({ ...shape, [end]: with_(shape[end], i, value) }),
        })),
      );
    case "sphere":
      return [
        ...AXES.map((axis, i) => ({
          name: axis,
          value: shape.centre_mm[i]!,
          set: (value: number | null) => ({ ...shape, centre_mm: with_(shape.centre_mm, i, value) }),
        })),
        { name: "radius", value: shape.radius_mm, set: (value) => ({ ...shape, radius_mm: value ?? 1 }) },
      ];
    case "z":
      return [
        { name: "from", value: shape.low_mm, set: (low_mm) => ({ ...shape, low_mm }) },
        { name: "to", value: shape.high_mm, set: (high_mm) => ({ ...shape, high_mm }) },
      ];
    case "half":
      return [
        ...AXES.map((axis, i) => ({
          name: `towards ${axis}`,
          value: shape.normal[i]!,
          set: (value: number | null) => ({ ...shape, normal: with_(shape.normal, i, value) }),
        })),
        { name: "from", value: shape.offset_mm, set: (value) => ({ ...shape, offset_mm: value ?? 0 }) },
      ];
  }
}

export function ShapeFields({ item, studio }: { item: Item; studio: Studio }): JSX.Element {
  const { number, frame, erase, shape } = item;
  const send = (changed: Shape, erases = erase) =>
    void studio.edit({ do: "change", number, mark: { shape: changed, erase: erases, frame } });
  if (shape.kind === "stroke" || shape.kind === "mask")
    return <p class="quiet">{shape.kind === "stroke" ? `a stroke of ${shape.radius_mm} mm radius` : "painted in the model's file"}</p>;
  const solid = shape as Solid;
  return (
    <div class="numbers">
      {numbersOf(solid).map(({ name, value, set }) => (
        <label key={name}>
          <span>{name}</span>
          <input
            type="number"
            step="any"
            value={value ?? ""}
            placeholder="open"
            onChange={(event) => {
              const to = event.currentTarget.value === "" ? null : event.currentTarget.valueAsNumber;
              send(set(to));
            }}
          />
        </label>
      ))}
      <label class="wide">
        <input type="checkbox" checked={erase} onChange={() => send(solid, !erase)} />
        <span>print as wire</span>
      </label>
    </div>
  );
}
