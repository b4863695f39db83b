// Ways of the head on which nothing is laid, as thin lines, up to the strand that is shown.
import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";
import type { Palette } from "./theme";

export class Travels extends LineSegments<BufferGeometry, LineBasicMaterial> {
  /** How many strands are laid before each. */
  private after: Uint32Array = new Uint32Array();

  constructor() {
    super(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.7 }));
    this.frustumCulled = false;
  }

  get count(): number {
    return this.after.length;
  }

  /** Takes both ends of each, mm, in order. */
  take(ends: Float32Array, after: Uint32Array): void {
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(ends, 3));
    this.after = after;
  }

  /** Shows those that come before a strand. */
  showUntil(strand: number): void {
    let low = 0;
    let high = this.after.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.after[middle]! <= strand) low = middle + 1;
      else high = middle;
    }
    this.geometry.setDrawRange(0, 2 * low);
  }

  paint(colours: Palette): void {
    this.material.color.copy(colours.faint);
  }
}
