// Ties the session, the scene and the page together.
import { batch, effect } from "@preact/signals";
import { Sphere, Vector3 } from "three";
import { Brush } from "./brush";
import { Handles } from "./handles";
import type { Answer, Field, Item, Model, Print, Shape, State, Value, Welcome } from "./protocol";
import * as store from "./store";
import { darkQuery, palette } from "./theme";
import { Refused, Transport } from "./transport";
import { View } from "./view";

const TOAST_MS = 4000;

export class Studio {
  readonly view: View;
  private readonly transport: Transport;
  private readonly brush: Brush;
  private readonly handles: Handles;
  private framed = false;
  private lastMs = 0;
  private spot = -1;
  private toasting = 0;

  constructor(canvas: HTMLCanvasElement, host: HTMLElement) {
    this.view = new View(canvas);
    this.transport = new Transport(
      (answer) => this.take(answer),
      (open) => (store.linked.value = open),
    );
    this.brush = new Brush(this.view, host, async (shape, erase) => this.mark(shape, erase));
    this.handles = new Handles(this.view, host, (number, shape, frame) => {
      void this.edit({ do: "change", number, mark: { shape, erase: this.item(number)?.erase ?? false, frame } });
    });
    this.view.onFrame = (timeMs) => this.advance(timeMs);
    this.follow();
    this.transport.open();
  }

  // ---- What a user does.

  async mark(shape: Shape, erase: boolean): Promise<{ number: number; revision: number }> {
    const { head } = await this.asked({ do: "mark", mark: { shape, erase } });
    return { number: head["number"] as number, revision: head["revision"] as number };
  }

  /** Asks for a change; what is refused is said. */
  async edit(message: Record<string, unknown>): Promise<boolean> {
    try {
      await this.asked(message);
      return true;
    } catch {
      return false;
    }
  }

  /** Adds a shape, and shows its handles. */
  async shape(kind: "box" | "sphere" | "z" | "half"): Promise<void> {
    const box = this.view.surface.body.geometry.boundingBox;
    if (!box) return;
    const centre = box.getCenter(new Vector3());
    const size = box.getSize(new Vector3());
    const round = (vector: Vector3) => vector.toArray().map((number) => Math.round(number * 10) / 10) as [number, number, number];
    const wider = 0.05 * size.length();
    // Each is begun where it covers some of the surface: half of a belt, the front, a belt, the top.
    const low = new Vector3(centre.x, box.min.y - wider, box.min.z + 0.4 * size.z);
    const high = new Vector3(box.max.x + wider, box.max.y + wider, box.min.z + 0.6 * size.z);
    const made: Shape = {
      box: { kind: "box" as const, low_mm: round(low), high_mm: round(high) },
      sphere: {
        kind: "sphere" as const,
        centre_mm: round(new Vector3(centre.x, box.min.y, centre.z)),
        radius_mm: Math.max(Math.round(Math.min(size.x, size.y, size.z) * 3) / 10, 0.5),
      },
      z: {
        kind: "z" as const,
        low_mm: Math.round(box.min.z + 0.4 * size.z),
        high_mm: Math.round(box.min.z + 0.6 * size.z),
      },
      half: { kind: "half" as const, normal: [0, 0, 1] as [number, number, number], offset_mm: Math.round(box.min.z + 0.7 * size.z) },
    }[kind];
    try {
      const { number } = await this.mark(made, store.tool.value === "erase");
      store.selected.value = number;
    } catch {
      // It was said.
    }
  }

  async set(key: string, value: Value): Promise<void> {
    try {
      await this.transport.ask({ do: "set", key, value });
      const { [key]: _, ...others } = store.refusals.value;
      store.refusals.value = others;
    } catch (error) {
      store.refusals.value = { ...store.refusals.value, [key]: (error as Error).message };
    }
  }

  async export(kind: "gcode" | "project" | "strokes"): Promise<void> {
    const refused = kind === "gcode" ? (store.print.value?.refused ?? "") : "";
    if (refused && !confirm(`${refused}.\n\nExport it all the same?`)) return;
    try {
      const { head, arrays } = await this.asked({ do: "export", kind, ...(kind === "gcode" ? { force: refused !== "" } : {}) });
      const name = head["name"] as string;
      download(name, new Blob([arrays["file"] as Uint8Array<ArrayBuffer>]));
      this.say(`${name} is in your downloads`);
    } catch {
      // It was said.
    }
  }

  async picture(): Promise<void> {
    const blob = await this.view.picture();
    const name = `${(store.welcome.value?.name ?? "print").replace(/\.[^.]+$/, "")}.png`;
    if (blob) download(name, blob);
    this.view.redraw();
  }

  /** Goes to the next breach, bare patch or dropped run. */
  next(): void {
    const spots = store.spots.value.filter((spot) => spot.at_mm);
    if (!spots.length) {
      this.say("nothing is wrong or missing");
      return;
    }
    this.spot = (this.spot + 1) % spots.length;
    this.flyTo(spots[this.spot]!);
  }

  flyTo(spot: store.Spot): void {
    if (spot.at_mm) this.view.flyTo(new Vector3(...spot.at_mm));
    this.say(spot.words, spot.kind === "breach");
  }

  play(): void {
    if (store.totalS.value === 0) return;
    if (!store.playing.value && store.timeS.value >= store.totalS.value) store.timeS.value = 0;
    store.playing.value = !store.playing.value;
  }

  /** Goes by strands along the timeline. */
  step(by: number, slabs: boolean): void {
    const { strands } = this.view;
    if (!strands.count) return;
    store.playing.value = false;
    const shown = strands.begunBy(Math.min(store.timeS.value, store.totalS.value) + 1e-3);
    let to = shown + by;
    if (slabs) {
      const slab = strands.slabOf(Math.min(Math.max(shown - 1, 0), strands.count - 1));
      while (to > 0 && to < strands.count && strands.slabOf(to - 1) === slab) to += by;
    }
    to = Math.min(Math.max(to, 0), strands.count);
    store.timeS.value = to === 0 ? 0 : strands.when[2 * to - 1]!;
  }

  async loadFields(): Promise<void> {
    if (store.fields.value.length) return;
    try {
      const { head } = await this.asked({ do: "schema" });
      batch(() => {
        store.fields.value = head["fields"] as Field[];
        store.sections.value = head["sections"] as Record<string, string>;
      });
    } catch {
      // It was said.
    }
  }

  say(words: string, bad = false): void {
    store.toast.value = { words, bad };
    clearTimeout(this.toasting);
    this.toasting = window.setTimeout(() => (store.toast.value = null), TOAST_MS);
  }

  item(number: number): Item | undefined {
    return store.state.value?.items.find((item) => item.number === number);
  }

  private async asked(message: Record<string, unknown>): Promise<Answer> {
    try {
      return await this.transport.ask(message);
    } catch (error) {
      if (error instanceof Refused) this.say(error.message, true);
      throw error;
    }
  }

  // ---- What the session says.

  private take({ head, arrays }: Answer): void {
    batch(() => {
      switch (head.event) {
        case "welcome":
          store.welcome.value = head as unknown as Welcome;
          document.title = `${store.welcome.value.name} · wireprint studio`;
          break;
        case "model":
          this.takeModel(head as unknown as Model, arrays["vertices"] as Float32Array, arrays["faces"] as Uint32Array);
          break;
        case "state":
          this.takeState(head as unknown as State);
          break;
        case "print":
          this.takePrint(head as unknown as Print, arrays);
          break;
        case "current":
          store.printed.value = head["revision"] as number;
          break;
        case "paint":
          this.view.surface.mark(arrays["corners"] as Float32Array);
          this.brush.answered(store.printed.value);
          break;
        case "rest":
          store.rest.value = head as unknown as NonNullable<typeof store.rest.value>;
          break;
        case "failed":
          store.failure.value = head["words"] as string;
          break;
        case "notice":
          store.notice.value = head["words"] as string;
          break;
      }
    });
    this.view.redraw();
  }

  private takeModel(model: Model, vertices: Float32Array, faces: Uint32Array): void {
    store.model.value = { ...model, triangles: faces.length / 3 };
    this.view.surface.take(vertices, faces);
    const sphere = this.view.surface.body.geometry.boundingSphere ?? new Sphere();
    this.view.frame(sphere.center.clone(), sphere.radius);
    if (!this.framed) this.view.look("3D", false);
    this.framed = true;
    // Once the first picture is there, what the brush will ask for is made ready.
    setTimeout(() => this.view.surface.prepare(), 300);
  }

  private takeState(state: State): void {
    store.state.value = state;
    this.brush.kept(new Set(state.items.map((item) => item.number)));
    if (this.view.bed.take(state.bed)) this.view.paint();
    this.view.head.take(state.head);
    if (store.selected.value !== null && !this.item(store.selected.value)) store.selected.value = null;
  }

  private takePrint(print: Print, arrays: Answer["arrays"]): void {
    const strands = arrays["strands"] as Uint32Array;
    this.view.strands.take(print, strands, arrays["when"] as Float32Array, arrays["speed"] as Float32Array);
    this.view.surface.place(print.motion);
    this.view.mark(print.breaches.flatMap(({ at_mm }) => (at_mm ? [at_mm] : [])));
    store.print.value = print;
    store.strandCount.value = strands.length / 4;
    store.failure.value = "";
    store.rest.value = null;
    this.spot = -1;
    if (store.slab.value >= print.slabs_mm.length - 1) store.slab.value = Infinity;
    document.body.dataset["drawn"] = `${store.strandCount.value}`;
  }

  // ---- What the scene follows.

  private follow(): void {
    const { view } = this;
    const recolour = () => {
      const labels = store.print.value?.labels ?? [];
      view.strands.paint(labels, store.hidden.value, palette(), darkQuery.matches);
      view.redraw();
    };
    effect(recolour);
    darkQuery.addEventListener("change", recolour);
    effect(() => {
      if (store.print.value) store.range.value = view.strands.colourBy(store.mode.value);
      view.redraw();
    });
    effect(() => {
      view.surface.visible = store.showsModel.value;
      view.strands.visible = store.showsWire.value;
      view.redraw();
    });
    effect(() => {
      const print = store.print.value;
      const slab = store.slab.value;
      view.strands.hideAbove(slab);
      view.surface.hideAbove(print && slab < print.slabs_mm.length - 1 ? print.slabs_mm[slab]! : Infinity);
      view.redraw();
    });
    effect(() => {
      const total = store.totalS.value;
      const time = Math.min(store.timeS.value, total);
      store.shownStrands.value = store.print.value ? view.strands.showUntil(time >= total ? Infinity : time) : 0;
      const tip = time < total ? view.strands.tipAt(time, view.head.position) : null;
      view.head.visible = tip !== null && store.showsWire.value;
      view.redraw();
    });
    effect(() => {
      const number = store.selected.value;
      const item = store.state.value?.items.find((one) => one.number === number);
      this.handles.show(item ?? null);
    });
    effect(() => {
      if (store.playing.value) {
        this.lastMs = 0;
        view.redraw();
      }
    });
  }

  /** Plays on; returns whether it goes on. */
  private advance(timeMs: number): boolean {
    if (!store.playing.value) return false;
    const passed = this.lastMs ? Math.min(timeMs - this.lastMs, 250) / 1000 : 0;
    this.lastMs = timeMs;
    const time = store.timeS.value + passed * store.rate.value;
    batch(() => {
      store.timeS.value = time;
      if (time >= store.totalS.value) {
        store.timeS.value = Infinity;
        store.playing.value = false;
      }
    });
    return store.playing.value;
  }
}

function download(name: string, blob: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
