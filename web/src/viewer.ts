// What every host shows: the scene follows what is told of model and print, and what the page chooses.
import { batch, effect } from "@preact/signals";
import { Box3, Sphere, Vector3 } from "three";
import { Refused, type Link, type Linking } from "./link";
import type { Answer, Model, Print, State, Welcome } from "./protocol";
import * as store from "./store";
import { darkQuery, palette } from "./theme";
import { View } from "./view";

const TOAST_MS = 4000;

export class Viewer {
  readonly view: View;
  protected readonly link: Link;
  private readonly ends: (() => void)[] = [];
  private framed = false;
  private lastMs = 0;
  private spot = -1;
  private toasting = 0;

  /** `root` holds the whole page, `stage` the canvas. */
  constructor(
    protected readonly root: HTMLElement,
    protected readonly stage: HTMLElement,
    linking: Linking,
  ) {
    this.view = new View(stage.querySelector("canvas")!);
    store.turns.value = this.view.turns;
    this.link = linking(
      (answer) => this.take(answer),
      (open) => (store.linked.value = open),
    );
    this.view.onFrame = (timeMs) => this.advance(timeMs);
    this.view.onStill = (azimuthDeg, elevationDeg) => void this.still(azimuthDeg, elevationDeg);
    this.follow();
  }

  /** Begins to be told; what shows it stands by then. */
  open(): void {
    this.link.open();
  }

  close(): void {
    for (const end of this.ends) end();
    this.view.close();
  }

  // ---- What a user does.

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

  say(words: string, bad = false): void {
    store.toast.value = { words, bad };
    clearTimeout(this.toasting);
    this.toasting = window.setTimeout(() => (store.toast.value = null), TOAST_MS);
  }

  /** Sends a message; what is refused is said, and thrown. */
  protected async asked(message: Record<string, unknown>): Promise<Answer> {
    try {
      return await this.link.ask(message);
    } catch (error) {
      if (error instanceof Refused) this.say(error.message, true);
      throw error;
    }
  }

  // ---- What is told.

  protected take({ head, arrays }: Answer): void {
    batch(() => {
      switch (head.event) {
        case "welcome":
          store.welcome.value = head as unknown as Welcome;
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
          break;
        case "rest":
          store.rest.value = head as unknown as NonNullable<typeof store.rest.value>;
          this.view.strands.hang(arrays["relaxed"] as Uint32Array, arrays["relaxed_of"] as Uint32Array);
          break;
        case "failed":
          store.failure.value = head["words"] as string;
          break;
        case "notice":
          store.notice.value = head["words"] as string;
          break;
        case "progress":
          store.progress.value = head["words"] as string;
          break;
      }
    });
    this.view.redraw();
  }

  protected takeModel(model: Model, vertices: Float32Array, faces: Uint32Array): void {
    store.model.value = { ...model, triangles: faces.length / 3 };
    this.view.surface.take(vertices, faces);
    const sphere = this.view.surface.body.geometry.boundingSphere ?? new Sphere();
    this.frame(sphere.center.clone(), sphere.radius);
    this.root.dataset["faces"] = `${faces.length / 3}`;
  }

  protected takeState(state: State): void {
    store.state.value = state;
    if (this.view.bed.take(state.bed)) this.view.paint();
    if (state.head) this.view.head.take(state.head);
  }

  private takePrint(print: Print, arrays: Answer["arrays"]): void {
    const { view } = this;
    const strands = arrays["strands"] as Uint32Array;
    view.strands.take(print, strands, arrays["when"] as Float32Array, arrays["speed"] as Float32Array);
    view.travels.take((arrays["travels"] as Float32Array) ?? new Float32Array(), (arrays["after"] as Uint32Array) ?? new Uint32Array());
    view.surface.place(print.motion);
    view.breaches.take(print.breaches.flatMap(({ at_mm }) => (at_mm ? [at_mm] : [])));
    view.weak.take(print.weak ?? []);
    if (!store.model.value) {
      const box = new Box3(new Vector3(...print.low), new Vector3(...print.low).add(new Vector3(...print.span)));
      const sphere = box.getBoundingSphere(new Sphere());
      this.frame(sphere.center, sphere.radius);
    }
    store.travelCount.value = view.travels.count;
    store.print.value = print;
    store.strandCount.value = strands.length / 4;
    store.failure.value = "";
    store.progress.value = "";
    store.rest.value = null;
    store.forecast.value = null;
    this.spot = -1;
    if (store.slab.value >= print.slabs_mm.length - 1) store.slab.value = Infinity;
    this.root.dataset["drawn"] = `${store.strandCount.value}`;
  }

  private frame(centre: Vector3, radius: number): void {
    this.view.frame(centre, radius);
    const camera = store.welcome.value?.camera;
    if (!this.framed && camera) this.view.lookFrom(...camera);
    else if (!this.framed) this.view.look("3D", false);
    this.framed = true;
  }

  /** Shows a picture where the browser cannot draw. */
  private async still(azimuth_deg: number, elevation_deg: number): Promise<void> {
    if (!store.print.value) return;
    const { clientWidth: width, clientHeight: height } = this.stage;
    try {
      const { arrays } = await this.link.ask({ do: "picture", azimuth_deg, elevation_deg, width, height });
      const before = store.still.value;
      store.still.value = URL.createObjectURL(new Blob([arrays["file"] as Uint8Array<ArrayBuffer>], { type: "image/png" }));
      if (before) URL.revokeObjectURL(before);
    } catch {
      // Nobody draws for a page of a file: it shows the picture that it holds.
    }
  }

  // ---- What the scene follows.

  /** Does something now, and whenever a signal changes that it reads. */
  protected follows(act: () => void): void {
    this.ends.push(effect(act));
  }

  private follow(): void {
    const { view } = this;
    const recolour = () => {
      const labels = store.print.value?.labels ?? [];
      view.strands.paint(labels, store.hidden.value, palette(), darkQuery.matches);
      view.redraw();
    };
    this.follows(recolour);
    darkQuery.addEventListener("change", recolour);
    this.ends.push(() => darkQuery.removeEventListener("change", recolour));
    this.follows(() => {
      // A forecast that comes changes what colours tell.
      const { value: print } = store.print;
      if (store.forecast.value ?? print) store.range.value = view.strands.colourBy(store.mode.value);
      view.redraw();
    });
    this.follows(() => {
      view.strands.relax(store.relaxes.value);
      view.redraw();
    });
    this.follows(() => {
      view.surface.visible = store.showsModel.value;
      view.strands.visible = store.showsWire.value;
      view.travels.visible = store.showsWire.value && store.showsTravels.value;
      view.redraw();
    });
    this.follows(() => {
      const print = store.print.value;
      const slab = store.slab.value;
      view.strands.hideAbove(slab);
      view.surface.hideAbove(print && slab < print.slabs_mm.length - 1 ? print.slabs_mm[slab]! : Infinity);
      view.redraw();
    });
    this.follows(() => {
      const total = store.totalS.value;
      const time = Math.min(store.timeS.value, total);
      store.shownStrands.value = store.print.value ? view.strands.showUntil(time >= total ? Infinity : time) : 0;
      view.travels.showUntil(store.shownStrands.value);
      const tip = time < total ? view.strands.tipAt(time, view.head.position) : null;
      view.head.visible = tip !== null && store.showsWire.value;
      view.redraw();
    });
    this.follows(() => {
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

export function download(name: string, blob: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
