// What the session says and takes: see python/wireprint/window/messages.py, session.py and page.py.
export type Point = [number, number, number];
export type Rows = [number[], number[], number[]];

export type Shape =
  | { kind: "stroke"; points_mm: Point[]; normals: Point[]; radius_mm: number; spread_deg: number }
  | { kind: "box"; low_mm: Point; high_mm: Point }
  | { kind: "sphere"; centre_mm: Point; radius_mm: number }
  | { kind: "half"; normal: Point; offset_mm: number }
  | { kind: "z"; low_mm: number | null; high_mm: number | null };

/** A line in the list of marks; paint comes without its points. */
export interface Item {
  number: number;
  name: string;
  on: boolean;
  erase: boolean;
  shape: Shape | { kind: "stroke"; radius_mm: number } | { kind: "mask" };
  frame: Rows | null;
}

export type Value = string | number | boolean | null;

/** A part of a head that is not round about its nozzle; all of it opens upwards. */
export type HeadPart =
  | { shape: "box"; x_mm: [number, number]; y_mm: [number, number]; bottom_mm: number; turn_deg: number }
  | { shape: "cylinder"; centre_mm: [number, number]; radius_mm: number; bottom_mm: number };

export interface Head {
  tip_radius_mm: number;
  slant_deg: number;
  cone_height_mm: number;
  block_radius_mm: number;
  parts?: HeadPart[];
}

export interface State {
  revision: number;
  items: Item[];
  can_undo: boolean;
  can_redo: boolean;
  printer: string;
  material: string;
  settings: Record<string, Value>;
  automatic: Record<string, number>;
  differs: Record<string, Value>;
  bed: { round: boolean; size_mm: [number, number]; high: number };
  head: Head | null;
}

export interface Label {
  label: string;
  name: string;
  colour: [number, number, number];
  length_mm: number;
}

export interface Unprinted {
  reason: string;
  area_mm2: number;
  place_mm: Point;
  help: string;
}

/** Figures of a print; what a G-code alone does not tell is absent. */
export interface Figures {
  print_time_s?: number;
  filament_g?: number;
  filament_mm?: number;
  filament_cost?: number;
  coverage?: number;
  certified?: boolean;
  whole?: boolean;
  turn_to_fit_deg?: number;
  unprinted?: Unprinted[];
  warnings?: string[];
}

/** A run of a mark that stays wire. */
export interface Dropped {
  reason: string;
  help: string;
  area_mm2: number;
  place_mm: Point;
}

export interface Print {
  figures: Figures;
  regions: null | {
    area_mm2: number;
    filled_mm3: number;
    dropped: Dropped[];
    hollow: { reason: string; help: string; volume_mm3: number; low_mm: number; high_mm: number }[];
  };
  refused: string;
  made_s: number | null;
  labels: Label[];
  /** What labels tell apart, if that is not what strands are for. */
  coloured_by?: string;
  low: Point;
  span: Point;
  diameter_step_mm: number;
  slabs_mm: number[];
  motion: number[][];
  breaches: { rule: string; words: string; at_mm: Point | null }[];
  weak?: Point[];
  total_s: number;
  /** Whether times are known; else each strand counts as a second. */
  timed: boolean;
}

export interface Welcome {
  name: string;
  version: string;
  /** From where it is seen first: azimuth and elevation, degrees. */
  camera?: [number, number];
  /** Size of what is shown, where there is no model to tell. */
  size_mm?: Point;
  /** Whether files can be written beside the model. */
  saves?: boolean;
  /** Names of the hosts that prints can be sent to; what is wrong with their file, and where it is. */
  hosts?: string[];
  hosts_fault?: string;
  hosts_file?: string;
  printers: string[];
  materials: string[];
}

/** What strands would do, by a model: of each figure its name and unit, and the amount that is drawn worst. */
export interface Forecast {
  revision: number;
  error: string;
  trust?: string;
  figures?: Record<string, { name: string; unit: string; most: string }>;
  sentences?: string[];
}

/** A start that has not been agreed to: what a message brings back to agree. */
export interface Asked {
  asks: string;
  file: string;
}

/** A file on its way: the share that went out, null once it is over. */
export interface Sent {
  host: string;
  file: string;
  start: boolean;
  share: number | null;
  error: string;
}

export interface Model {
  name: string;
  size_mm: Point;
  repaired: string[];
  warnings: string[];
  /** Shares of its surface, by what is printed there. */
  shares?: { name: string; amount: string }[];
}

export interface Field {
  key: string;
  section: string;
  name: string;
  unit: string;
  kind: "number" | "integer" | "choice" | "switch" | "text";
  low: number | null;
  high: number | null;
  choices: string[];
  automatic: boolean;
  help: string;
}

export type Arrays = Record<string, Float32Array | Uint32Array | Uint8Array>;

/** One answer or event, taken apart; arrays are views of the bytes that came. */
export interface Answer {
  head: Record<string, unknown> & { event?: string; re?: number; error?: string };
  arrays: Arrays;
}

interface Place {
  type: string;
  shape: number[];
  offset: number;
}

export function decoded(bytes: ArrayBuffer): Answer {
  const length = new DataView(bytes).getUint32(0, true);
  const { arrays: places, ...head } = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length))) as Record<
    string,
    unknown
  > & { arrays: Record<string, Place> };
  const arrays: Arrays = {};
  for (const [name, { type, shape, offset: fromHead }] of Object.entries(places)) {
    const offset = 4 + length + fromHead;
    const count = shape.reduce((product, size) => product * size, 1);
    if (type === "f4") arrays[name] = new Float32Array(bytes, offset, count);
    else if (type === "u4") arrays[name] = new Uint32Array(bytes, offset, count);
    else if (type === "u1") arrays[name] = new Uint8Array(bytes, offset, count);
    else throw new Error(`array ${name} has the unknown type ${type}`);
  }
  return { head, arrays };
}
