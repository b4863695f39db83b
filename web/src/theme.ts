// Colours of the scene, by the system's choice of light or dark; the page's own are in studio.css.
import { Color } from "three";

export interface Palette {
  ground: Color;
  model: Color;
  paint: Color;
  erased: Color;
  bed: Color;
  grid: Color;
  head: Color;
  faint: Color;
  breach: Color;
  weak: Color;
  accent: Color;
}

const LIGHT: Palette = {
  ground: new Color(0xf3f4f7),
  model: new Color(0xd9dee6),
  paint: new Color(0xb38ce0),
  erased: new Color(0xf2c7a5),
  bed: new Color(0xffffff),
  grid: new Color(0xd3d8e0),
  head: new Color(0x4b5563),
  faint: new Color(0xb4bac4),
  breach: new Color(0xde1622),
  weak: new Color(0x101010),
  accent: new Color(0x7b4fc4),
};
const DARK: Palette = {
  ground: new Color(0x15181d),
  model: new Color(0x4a515c),
  paint: new Color(0x8d62c9),
  erased: new Color(0x8a6040),
  bed: new Color(0x1b1f25),
  grid: new Color(0x2e343d),
  head: new Color(0xcbd2dc),
  faint: new Color(0x4c535e),
  breach: new Color(0xff4d57),
  weak: new Color(0xf2f2f2),
  accent: new Color(0xb695f0),
};

export const darkQuery = matchMedia("(prefers-color-scheme: dark)");

export function palette(): Palette {
  return darkQuery.matches ? DARK : LIGHT;
}

/** Ramp for amounts, dark to light; viridis (Smith and van der Walt), which colour-blind readers can follow. */
export const RAMP: [number, number, number][] = [
  [68, 1, 84],
  [71, 45, 123],
  [59, 82, 139],
  [44, 114, 142],
  [33, 145, 140],
  [40, 174, 128],
  [94, 201, 98],
  [173, 220, 48],
  [253, 231, 37],
];
