// Pictures on buttons, drawn for 24 × 24.
import type { JSX } from "preact";

const PATHS: Record<string, string> = {
  turn: "M4 12a8 8 0 0 1 13.7-5.6L20 8.5M20 4v4.5h-4.5M20 12a8 8 0 0 1-13.7 5.6L4 15.5M4 20v-4.5h4.5",
  fill: "M14.5 4.5l5 5L9 20H4v-5zM12 7l5 5",
  erase: "M8 20h12M5.2 14.8l8.6-8.6a2 2 0 0 1 2.8 0l3.2 3.2a2 2 0 0 1 0 2.8L12 20H8.4l-3.2-3.2a1.4 1.4 0 0 1 0-2zM10 10l6 6",
  undo: "M9 14L4 9l5-5M4 9h10a6 6 0 0 1 0 12h-3",
  redo: "M15 14l5-5-5-5M20 9H10a6 6 0 0 0 0 12h3",
  model: "M12 3l8 4.5v9L12 21l-8-4.5v-9zM12 12l8-4.5M12 12v9M12 12L4 7.5",
  wire: "M4 6h16M4 12h16M4 18h16M4 18l4-6 4 6 4-6 4 6M4 12l4-6 4 6 4-6 4 6",
  play: "M7 4.5v15l12-7.5z",
  pause: "M8 5v14M16 5v14",
  panel: "M4 6h16M4 12h16M4 18h16",
  trash: "M5 7h14M10 7V4h4v3M7 7l1 13h8l1-13M10.5 11v5M13.5 11v5",
  eye: "M2.5 12S6 5.5 12 5.5 21.5 12 21.5 12 18 18.5 12 18.5 2.5 12 2.5 12zM12 9.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6",
  hide: "M4 4l16 16M9.5 5.8A9 9 0 0 1 12 5.5c6 0 9.5 6.5 9.5 6.5a15 15 0 0 1-2.6 3.3M6.2 7.4A15 15 0 0 0 2.5 12S6 18.5 12 18.5c1.600 0 3-.4 4.200-1",
  up: "M6 15l6-6 6 6",
  down: "M6 9l6 6 6-6",
  box: "M5 5h14v14H5z",
  sphere: "M12 4a8 8 0 1 0 0 16 8 8 0 0 0 0-16M4 12c3 2.500 13 2.500 16 0",
  z: "M4 8h16M4 16h16M12 10.500v3",
  half: "M3 17L21 7M12 12l-3-5.500M9 6.500l-.3 2.600M9 6.500l2.300 1.200",
  key: "M4 7h16v10H4zM7.500 10.500h.01M11 10.500h.01M14.500 10.500h.01M8 14h8",
  close: "M6 6l12 12M18 6L6 18",
  back: "M5 12a7 7 0 1 0 2.500-5.400L5 9M5 4.500V9h4.500",
  camera: "M4 8h3l1.500-2.500h7L17 8h3v11H4zM12 10.500a3 3 0 1 0 0 6 3 3 0 0 0 0-6",
};

export function Icon({ name }: { name: string }): JSX.Element {
  return (
    <svg viewBox="0 0 24 24" width="18" height="18" aria-hidden="true" class="icon">
      <path d={PATHS[name] ?? ""} />
    </svg>
  );
}
