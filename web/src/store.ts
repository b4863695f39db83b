// What the page shows, as signals: components follow them, the scene is told in studio.ts.
import { computed, signal } from "@preact/signals";
import type { Dropped, Field, Forecast, Model, Point, Print, Sent, State, Welcome } from "./protocol";
import type { Mode } from "./strands";

export type Tool = "turn" | "fill" | "erase";

/** A place that one can fly to. */
export interface Spot {
  kind: "breach" | "bare" | "dropped" | "hollow";
  words: string;
  help: string;
  at_mm: Point | null;
}

/** Where the page is: a session's window, a notebook's cell, or a file that only shows. */
export const host = signal<"studio" | "widget" | "page">("studio");
export const welcome = signal<Welcome | null>(null);
export const model = signal<(Model & { triangles: number }) | null>(null);
export const state = signal<State | null>(null);
export const print = signal<Print | null>(null);
export const strandCount = signal(0);
export const rest = signal<{ deviation_mm: number | null; chord_deviation_mm: number | null } | null>(null);
/** The change that the print is of; while it is not the state's, the print is out of date. */
export const printed = signal(-1);
export const failure = signal("");
export const notice = signal("");
/** What is worked on, while it lasts. */
export const progress = signal("");
export const linked = signal(false);
/** Whether the browser can draw; else it shows `still`, the address of a picture. */
export const turns = signal(true);
export const still = signal("");
/** A word about what was just done or refused. */
export const toast = signal<{ words: string; bad: boolean } | null>(null);

export const tool = signal<Tool>("turn");
export const radiusMm = signal(5);
export const spreadDeg = signal(80);
export const showsModel = signal(true);
export const showsWire = signal(true);
export const showsTravels = signal(false);
export const travelCount = signal(0);
/** Whether strands are drawn as they hang, and not as commanded. */
export const relaxes = signal(false);
export const mode = signal<Mode>("feature");
/** What the colour ramp's ends stand for. */
export const range = signal<[number, number]>([0, 0]);
export const hidden = signal<ReadonlySet<string>>(new Set());
/** Time that is shown, s; infinite: all of it. */
export const timeS = signal(Infinity);
export const playing = signal(false);
export const rate = signal(60);
/** The last slab that is shown; infinite: all. */
export const slab = signal(Infinity);
/** The mark whose handles are shown. */
export const selected = signal<number | null>(null);
export const drawer = signal(false);
/** What the print that is shown would do; null: it was not asked for, or is not there yet. */
export const forecast = signal<Forecast | null>(null);
/** What is to be closed before all else goes on. */
export const dialog = signal<"keys" | "send" | null>(null);
/** The file that was sent last. */
export const sending = signal<Sent | null>(null);
export const fields = signal<Field[]>([]);
export const sections = signal<Record<string, string>>({});
/** What was refused at which setting. */
export const refusals = signal<Record<string, string>>({});
export const shownStrands = signal(0);

export const totalS = computed(() => print.value?.total_s ?? 0);
export const outOfDate = computed(
  () => state.value !== null && printed.value !== state.value.revision && failure.value === "",
);

/** A run of less than this, mm², is one of many where a mark's edge meets a slab. */
const HARDLY_SEEN_MM2 = 2;

const REASONS: Record<string, string> = {
  not_covered: "no strand is near",
  mid_air: "would begin in mid-air",
  no_foothold: "nothing to stand on",
  wide_span: "too wide a span",
  wide_roof: "too wide a roof",
  short_run: "too short a run",
  in_the_way: "the head would hit something",
  overhang: "hangs over too far",
  wide_bridge: "too wide a bridge",
  no_room: "no room on the bed",
  unproved: "could not be proven",
  beside_wire: "too near to wire",
  over_hollow: "over something hollow",
};

function reason(name: string): string {
  return REASONS[name] ?? name.replaceAll("_", " ");
}

/** Runs that stay wire, of which those that are hardly seen are one by their reason, at the largest of them. */
function gathered(runs: Dropped[]): (Dropped & { count: number })[] {
  const found: (Dropped & { count: number })[] = [];
  const bits = new Map<string, Dropped & { count: number; largest: number }>();
  for (const run of runs) {
    const bit = bits.get(run.reason);
    if (run.area_mm2 >= HARDLY_SEEN_MM2) found.push({ ...run, count: 1 });
    else if (!bit) bits.set(run.reason, { ...run, count: 1, largest: run.area_mm2 });
    else {
      bit.count++;
      bit.area_mm2 += run.area_mm2;
      if (run.area_mm2 > bit.largest) [bit.largest, bit.place_mm] = [run.area_mm2, run.place_mm];
    }
  }
  return [...found, ...bits.values()];
}

/** All that is wrong or missing, in the order in which one flies through it. */
export const spots = computed<Spot[]>(() => {
  const found = print.value;
  if (!found) return [];
  const area = (mm2: number) => (mm2 >= 100 ? `${(mm2 / 100).toFixed(1)} cm²` : `${mm2 < 1 ? "under 1" : mm2.toFixed(0)} mm²`);
  return [
    ...found.breaches.map(
      ({ rule, words, at_mm }): Spot => ({ kind: "breach", words: `${rule.replaceAll("_", " ")}: ${words}`, help: "", at_mm }),
    ),
    ...(found.figures.unprinted ?? []).map(
      (part): Spot => ({
        kind: "bare",
        words: `${area(part.area_mm2)} bare: ${reason(part.reason)}`,
        help: part.help,
        at_mm: part.place_mm,
      }),
    ),
    ...gathered(found.regions?.dropped ?? []).map(
      ({ count, ...run }): Spot => ({
        kind: "dropped",
        words: `${count > 1 ? `${count} bits, ` : ""}${area(run.area_mm2)} stay wire: ${reason(run.reason)}`,
        help: run.help,
        at_mm: run.place_mm,
      }),
    ),
    ...(found.regions?.hollow ?? []).map(
      (part): Spot => ({
        kind: "hollow",
        words: `${(part.volume_mm3 / 1000).toFixed(1)} cm³ stay hollow, ${part.low_mm.toFixed(0)}–${part.high_mm.toFixed(0)} mm: ${reason(part.reason)}`,
        help: part.help,
        at_mm: null,
      }),
    ),
  ];
});

export function sendingWords({ host, file, start, share, error }: Sent): string {
  if (error) return error;
  if (share === null) return start ? `${file} is at ${host}, which prints it` : `${file} is at ${host}`;
  return share < 1 ? `${file} goes to ${host}: ${Math.floor(100 * share)} %` : `${host} takes ${file}…`;
}

/** Time, or strands where times are not known, as people read them. */
export function instant(amount: number): string {
  return print.value?.timed === false ? Math.round(amount).toLocaleString("en") : clock(amount);
}

export function clock(seconds: number): string {
  const whole = Math.round(seconds);
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor((whole % 3600) / 60)];
  const two = (number: number) => String(number).padStart(2, "0");
  return hours ? `${hours}:${two(minutes)}:${two(whole % 60)}` : `${minutes}:${two(whole % 60)}`;
}
