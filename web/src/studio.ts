// A viewer that works on what it shows: brush, shapes, settings, files.
import { batch } from "@preact/signals";
import { Box3, Vector3 } from "three";
import { Brush } from "./brush";
import { Handles } from "./handles";
import { Refused, type Linking } from "./link";
import type { Answer, Asked, Field, Forecast, Item, Model, Sent, Shape, State, Value } from "./protocol";
import * as store from "./store";
import { isFigure, type Figure } from "./strands";
import { Viewer, download } from "./viewer";

type Kind = "box" | "sphere" | "z" | "half";
export type FileKind = "gcode" | "project" | "strokes";

export class Studio extends Viewer {
  private readonly brush: Brush;
  private readonly handles: Handles;

  constructor(root: HTMLElement, stage: HTMLElement, linking: Linking) {
    super(root, stage, linking);
    this.brush = new Brush(this.view, stage, async (shape, erase) => this.mark(shape, erase));
    this.handles = new Handles(this.view, stage, (number, shape, frame) => {
      void this.edit({ do: "change", number, mark: { shape, erase: this.item(number)?.erase ?? false, frame } });
    });
    this.follows(() => this.foretell());
    this.follows(() => {
      const number = store.selected.value;
      const item = store.state.value?.items.find((one) => one.number === number);
      this.handles.show(item ?? null);
    });
  }

  /** Has the print that is shown forecast, whenever its colours tell something of that. */
  private foretell(): void {
    if (!isFigure(store.mode.value) || !store.print.value || store.forecast.value || store.outOfDate.value) return;
    void this.edit({ do: "forecast" });
  }

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
  async shape(kind: Kind): Promise<void> {
    const box = this.view.surface.body.geometry.boundingBox;
    if (!box) return;
    try {
      const { number } = await this.mark(beginning(kind, box), store.tool.value === "erase");
      store.selected.value = number;
    } catch {
      // It was said.
    }
  }

  async set(key: string, value: Value): Promise<void> {
    try {
      await this.link.ask({ do: "set", key, value });
      const { [key]: _, ...others } = store.refusals.value;
      store.refusals.value = others;
    } catch (error) {
      store.refusals.value = { ...store.refusals.value, [key]: (error as Error).message };
    }
  }

  async export(kind: FileKind): Promise<void> {
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

  /** Has a file written beside the model; what is there already is only written over if the user says so. */
  async save(kind: FileKind): Promise<void> {
    const refused = kind === "gcode" ? (store.print.value?.refused ?? "") : "";
    if (refused && !confirm(`${refused}.\n\nSave it all the same?`)) return;
    const message = { do: "save", kind, ...(kind === "gcode" ? { force: refused !== "" } : {}) };
    try {
      let { head } = await this.asked(message);
      if (head["exists"]) {
        if (!confirm(`${head["name"] as string} is there already.\n\nWrite over it?`)) return;
        ({ head } = await this.asked({ ...message, over: head["exists"] }));
        // It was changed while the user was asked.
        if (head["exists"]) return this.say(`${head["name"] as string} has just changed, and was left as it is`, true);
      }
      this.say(`${head["name"] as string} is beside the model`);
    } catch {
      // It was said.
    }
  }

  /** Has the G-code sent to a host; returns the start that is to be agreed to first, if there is one. */
  async send(host: string, start: boolean, sure: string | null): Promise<Asked | null> {
    try {
      const { head } = await this.asked({ do: "send", host, start, sure });
      return head["asks"] === null ? null : (head as unknown as Asked);
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      store.sending.value = { host, file: "", start, share: null, error: error.message };
      return null;
    }
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

  item(number: number): Item | undefined {
    return store.state.value?.items.find((item) => item.number === number);
  }

  protected override take(answer: Answer): void {
    super.take(answer);
    if (answer.head.event === "welcome" && store.host.value === "studio")
      document.title = `${store.welcome.value?.name} · wireprint studio`;
    if (answer.head.event === "forecast") this.takeForecast(answer);
    if (answer.head.event === "sending") this.takeSent(answer.head as unknown as Sent);
    if (answer.head.event === "paint") this.brush.answered(store.printed.value);
  }

  private takeForecast({ head, arrays }: Answer): void {
    const forecast = head as unknown as Forecast;
    // It may be of a print that is shown no longer.
    if (forecast.revision !== store.printed.value) return;
    this.view.strands.foretell(arrays as Partial<Record<Figure, Float32Array>>);
    store.forecast.value = forecast;
  }

  private takeSent(sent: Sent): void {
    store.sending.value = sent;
    if (sent.share === null && store.dialog.value !== "send") this.say(store.sendingWords(sent), sent.error !== "");
  }

  protected override takeModel(model: Model, vertices: Float32Array, faces: Uint32Array): void {
    super.takeModel(model, vertices, faces);
    // Once the first picture is there, what the brush will ask for is made ready.
    setTimeout(() => this.view.surface.prepare(), 300);
  }

  protected override takeState(state: State): void {
    super.takeState(state);
    this.brush.kept(new Set(state.items.map((item) => item.number)));
    if (store.selected.value !== null && !this.item(store.selected.value)) store.selected.value = null;
  }
}

/** A shape where it covers some of a model's surface: half of a belt, the front, a belt, the top. */
function beginning(kind: Kind, box: Box3): Shape {
  const centre = box.getCenter(new Vector3());
  const size = box.getSize(new Vector3());
  const round = (vector: Vector3) => vector.toArray().map((number) => Math.round(number * 10) / 10) as [number, number, number];
  const wider = 0.05 * size.length();
  // Each is begun where it covers some of the surface: half of a belt, the front, a belt, the top.
  const low = new Vector3(centre.x, box.min.y - wider, box.min.z + 0.4 * size.z);
  const high = new Vector3(box.max.x + wider, box.max.y + wider, box.min.z + 0.6 * size.z);
  const made: Record<Kind, Shape> = {
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
  };
  return made[kind];
}
