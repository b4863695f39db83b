// Keys: what each does, and the list of them.
import * as store from "./store";
import type { Studio } from "./studio";
import type { Viewer } from "./viewer";

const SMALLEST_MM = 0.5;
const LARGEST_MM = 30;

/** What a key does, and whether it changes something. */
const KEYS: [string, string, boolean][] = [
  ["B", "print as layers", true],
  ["E", "print as wire", true],
  ["V", "turn", true],
  ["[ ]", "brush smaller, larger", true],
  ["Alt drag", "turn while painting", true],
  ["1 3 7 5", "front, side, top, 3D", false],
  ["M W", "model, wire", false],
  ["Space", "play", false],
  ["← →", "one strand; with Shift one slab", false],
  ["Ctrl Z", "undo; with Shift redo", true],
  ["N", "next breach, bare patch or dropped run", false],
  ["Ctrl E", "export the G-code", true],
  ["Ctrl S", "save the project", true],
  ["Delete", "delete the chosen mark", true],
  ["Esc", "let go", false],
  ["?", "this list", false],
];

/** The list of keys: all, or those that change nothing. */
export function keysOf(edits: boolean): [string, string][] {
  return KEYS.filter(([, , editing]) => edits || !editing).map(([key, does]) => [key, does]);
}

function larger(factor: number): void {
  const next = Math.round(store.radiusMm.value * factor * 2) / 2;
  const moved = next === store.radiusMm.value ? next + Math.sign(factor - 1) * 0.5 : next;
  store.radiusMm.value = Math.min(Math.max(moved, SMALLEST_MM), LARGEST_MM);
}

/** What has the focus, in a shadow tree, too. */
function focused(event: KeyboardEvent): HTMLElement | null {
  return (event.composedPath()[0] as HTMLElement | undefined) ?? null;
}

/** Whether keys go into what has the focus. */
function isTyping(event: KeyboardEvent): boolean {
  const target = focused(event);
  if (!target) return false;
  if (target instanceof HTMLInputElement) return !["checkbox", "range", "button"].includes(target.type);
  return ["TEXTAREA", "SELECT"].includes(target.tagName);
}

/** Whether a key has a meaning of its own for what has the focus. */
function isTaken(event: KeyboardEvent): boolean {
  const target = focused(event);
  if (!target || target === document.body) return false;
  if (event.key === " ") return ["BUTTON", "SUMMARY", "INPUT"].includes(target.tagName);
  return event.key.startsWith("Arrow") && target instanceof HTMLInputElement && target.type === "range";
}

/** Obeys keys; `studio` is null where nothing can be changed. Returns what ends that. */
export function listen(viewer: Viewer, studio: Studio | null, target: EventTarget): () => void {
  const looks: Record<string, () => void> = {
    "1": () => viewer.view.look("front"),
    "3": () => viewer.view.look("side"),
    "7": () => viewer.view.look("top"),
    "5": () => viewer.view.look("3D"),
    m: () => (store.showsModel.value = !store.showsModel.value),
    w: () => (store.showsWire.value = !store.showsWire.value),
    n: () => viewer.next(),
    " ": () => viewer.play(),
    "?": () => (store.dialog.value = store.dialog.value === null ? "keys" : null),
    escape: () => {
      store.selected.value = null;
      store.dialog.value = null;
      store.drawer.value = false;
    },
  };
  const plain = { ...looks, ...(studio ? editing(studio) : {}) };
  const withControl: Record<string, () => void> = studio
    ? {
        s: () => void studio.export("project"),
        e: () => void studio.export("gcode"),
        y: () => void studio.edit({ do: "redo" }),
      }
    : {};
  const obey = (event: KeyboardEvent) => {
    const key = event.key.toLowerCase();
    const control = event.ctrlKey || event.metaKey;
    let act: (() => void) | undefined;
    if (store.dialog.value !== null && !["?", "escape"].includes(key)) return;
    if (control && key === "z" && studio && !isTyping(event))
      act = () => void studio.edit({ do: event.shiftKey ? "redo" : "undo" });
    else if (control) act = key === "y" && isTyping(event) ? undefined : withControl[key];
    else if (event.altKey || isTaken(event)) return;
    else if (isTyping(event) && key !== "escape") return;
    else if (key === "arrowleft" || key === "arrowright")
      act = () => viewer.step(key === "arrowright" ? 1 : -1, event.shiftKey);
    else act = plain[key];
    if (!act) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  };
  target.addEventListener("keydown", obey as EventListener);
  return () => target.removeEventListener("keydown", obey as EventListener);
}

function editing(studio: Studio): Record<string, () => void> {
  const paints = (tool: "fill" | "erase") => () => {
    if (store.turns.value) store.tool.value = tool;
  };
  return {
    b: paints("fill"),
    e: paints("erase"),
    v: () => (store.tool.value = "turn"),
    "[": () => larger(1 / 1.25),
    "]": () => larger(1.25),
    delete: () => {
      const number = store.selected.value;
      if (number !== null) void studio.edit({ do: "delete", number });
    },
  };
}
