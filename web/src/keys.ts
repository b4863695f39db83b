// Keys: what each does, and the list of them.
import * as store from "./store";
import type { Studio } from "./studio";

const SMALLEST_MM = 0.5;
const LARGEST_MM = 30;

/** Shown in the list of keys. */
export const KEYS: [string, string][] = [
  ["B", "print as layers"],
  ["E", "print as wire"],
  ["V", "turn"],
  ["[ ]", "brush smaller, larger"],
  ["Alt drag", "turn while painting"],
  ["1 3 7 5", "front, side, top, 3D"],
  ["M W", "model, wire"],
  ["Space", "play"],
  ["← →", "one strand; with Shift one slab"],
  ["Ctrl Z", "undo; with Shift redo"],
  ["N", "next breach, bare patch or dropped run"],
  ["Ctrl E", "export the G-code"],
  ["Ctrl S", "save the project"],
  ["Delete", "delete the chosen mark"],
  ["Esc", "let go"],
  ["?", "this list"],
];

function larger(factor: number): void {
  const next = Math.round(store.radiusMm.value * factor * 2) / 2;
  const moved = next === store.radiusMm.value ? next + Math.sign(factor - 1) * 0.5 : next;
  store.radiusMm.value = Math.min(Math.max(moved, SMALLEST_MM), LARGEST_MM);
}

/** Whether keys go into what has the focus. */
function isTyping(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement | null;
  if (!target) return false;
  if (target instanceof HTMLInputElement) return !["checkbox", "range", "button"].includes(target.type);
  return ["TEXTAREA", "SELECT"].includes(target.tagName);
}

/** Whether a key has a meaning of its own for what has the focus. */
function isTaken(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement | null;
  if (!target || target === document.body) return false;
  if (event.key === " ") return ["BUTTON", "SUMMARY", "INPUT"].includes(target.tagName);
  return event.key.startsWith("Arrow") && target instanceof HTMLInputElement && target.type === "range";
}

export function listen(studio: Studio): void {
  const plain: Record<string, () => void> = {
    b: () => (store.tool.value = "fill"),
    e: () => (store.tool.value = "erase"),
    v: () => (store.tool.value = "turn"),
    "[": () => larger(1 / 1.25),
    "]": () => larger(1.25),
    "1": () => studio.view.look("front"),
    "3": () => studio.view.look("side"),
    "7": () => studio.view.look("top"),
    "5": () => studio.view.look("3D"),
    m: () => (store.showsModel.value = !store.showsModel.value),
    w: () => (store.showsWire.value = !store.showsWire.value),
    n: () => studio.next(),
    " ": () => studio.play(),
    "?": () => (store.helps.value = !store.helps.value),
    delete: () => {
      const number = store.selected.value;
      if (number !== null) void studio.edit({ do: "delete", number });
    },
    escape: () => {
      store.selected.value = null;
      store.helps.value = false;
      store.drawer.value = false;
    },
  };
  const withControl: Record<string, () => void> = {
    s: () => void studio.export("project"),
    e: () => void studio.export("gcode"),
    y: () => void studio.edit({ do: "redo" }),
  };
  addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    const control = event.ctrlKey || event.metaKey;
    let act: (() => void) | undefined;
    if (control && key === "z" && !isTyping(event)) act = () => void studio.edit({ do: event.shiftKey ? "redo" : "undo" });
    else if (control) act = key === "y" && isTyping(event) ? undefined : withControl[key];
    else if (event.altKey || isTaken(event)) return;
    else if (isTyping(event) && key !== "escape") return;
    else if (key === "arrowleft" || key === "arrowright")
      act = () => studio.step(key === "arrowright" ? 1 : -1, event.shiftKey);
    else act = plain[key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}
