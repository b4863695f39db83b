// The bed with its lines, and the build volume.
import {
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
} from "three";
import type { State } from "./protocol";
import type { Palette } from "./theme";

/** Lines lie so far apart, or a power of ten of that on what is large. */
const LINE_MM = 10;
const MOST_LINES = 100;
const AROUND = 96;

function lines(points: number[]): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  return geometry;
}

/** The bed about its centre, the build volume above it. */
export class Bed extends Group {
  private readonly plate = new Mesh(new BufferGeometry(), new MeshBasicMaterial({ side: DoubleSide }));
  private readonly grid = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  private readonly volume = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ transparent: true, opacity: 0.55 }),
  );
  private known = "";

  constructor() {
    super();
    Object.assign(this.plate.material, { polygonOffset: true, polygonOffsetFactor: 6, polygonOffsetUnits: 24 });
    this.plate.renderOrder = -2;
    this.grid.renderOrder = -1;
    this.add(this.plate, this.grid, this.volume);
  }

  /** Returns whether it is another bed. */
  take({ round, size_mm: [width, depth], high }: State["bed"]): boolean {
    const about = JSON.stringify([round, width, depth, high]);
    if (about === this.known) return false;
    this.known = about;
    for (const part of this.children) (part as Mesh).geometry.dispose();
    const edge = round ? around(width / 2) : corners(width, depth);
    this.plate.geometry = round ? new CircleGeometry(width / 2, AROUND) : new PlaneGeometry(width, depth);
    this.grid.geometry = lines([...grid(round, width, depth), ...ring(edge, 0)]);
    const posts = round ? [] : edge.flatMap(([x, y]) => [x, y, 0, x, y, high]);
    this.volume.geometry = lines([...posts, ...ring(edge, high)]);
    return true;
  }

  paint(colours: Palette): void {
    this.plate.material.color.copy(colours.bed);
    this.grid.material.color.copy(colours.grid);
    this.volume.material.color.copy(colours.grid);
  }
}

type Flat = [number, number];

function around(radius: number): Flat[] {
  return Array.from({ length: AROUND }, (_, i) => {
    const turn = (2 * Math.PI * i) / AROUND;
    return [radius * Math.cos(turn), radius * Math.sin(turn)];
  });
}

function corners(width: number, depth: number): Flat[] {
  const [x, y] = [width / 2, depth / 2];
  return [
    [-x, -y],
    [x, -y],
    [x, y],
    [-x, y],
  ];
}

function ring(edge: Flat[], z: number): number[] {
  return edge.flatMap(([x, y], i) => {
    const [u, v] = edge[(i + 1) % edge.length]!;
    return [x, y, z, u, v, z];
  });
}

function grid(round: boolean, width: number, depth: number): number[] {
  const found: number[] = [];
  const step = LINE_MM * 10 ** Math.max(Math.ceil(Math.log10(Math.max(width, depth) / LINE_MM / MOST_LINES)), 0);
  const along = (half: number, other: number, put: (at: number, reach: number) => void) => {
    for (let at = -Math.floor(half / step) * step; at <= half; at += step)
      put(at, round ? Math.sqrt(Math.max(half * half - at * at, 0)) : other);
  };
  along(width / 2, depth / 2, (x, reach) => found.push(x, -reach, 0, x, reach, 0));
  along(depth / 2, width / 2, (y, reach) => found.push(-reach, y, 0, reach, y, 0));
  return found;
}
