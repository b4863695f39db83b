// The head that lays the strand which is shown, as the certificate knows it.
import {
  BoxGeometry,
  BufferGeometry,
  CylinderGeometry,
  DoubleSide,
  LatheGeometry,
  Mesh,
  MeshBasicMaterial,
  Vector2,
} from "three";
import type { Head as Measures, HeadPart } from "./protocol";
import type { Palette } from "./theme";

const AROUND = 48;
/** All of a head opens upwards; so much of it is drawn above where its parts begin, in block radii. */
const SHOWN = 0.5;

/** The nozzle's cone, the block above it, and what is not round about them. */
export class Head extends Mesh<BufferGeometry, MeshBasicMaterial> {
  constructor() {
    super(
      new BufferGeometry(),
      new MeshBasicMaterial({ transparent: true, opacity: 0.26, side: DoubleSide, depthWrite: false }),
    );
    this.visible = false;
    this.renderOrder = 5;
  }

  take(head: Measures): void {
    const { tip_radius_mm: tip, slant_deg: slant, cone_height_mm: high, block_radius_mm: block } = head;
    const wide = Math.min(tip + high / Math.tan((slant * Math.PI) / 180), block);
    const top = high + SHOWN * block;
    const outline: [number, number][] = [
      [0, 0],
      [tip, 0],
      [wide, high],
      [block, high],
      [block, top],
    ];
    this.geometry.dispose();
    this.geometry = new LatheGeometry(
      outline.map(([r, z]) => new Vector2(r, z)),
      AROUND,
    ).rotateX(Math.PI / 2);
    for (const part of this.children as Mesh[]) part.geometry.dispose();
    this.clear();
    for (const part of head.parts ?? []) {
      const drawn = new Mesh(bodyOf(part, Math.max(top, part.bottom_mm + SHOWN * block)), this.material);
      drawn.renderOrder = this.renderOrder;
      this.add(drawn);
    }
  }

  paint(colours: Palette): void {
    this.material.color.copy(colours.head);
  }
}

/** A part from its bottom up to a height above the tip, mm. */
function bodyOf(part: HeadPart, top: number): BufferGeometry {
  const [tall, middle] = [top - part.bottom_mm, (top + part.bottom_mm) / 2];
  if (part.shape === "cylinder") {
    const [x, y] = part.centre_mm;
    return new CylinderGeometry(part.radius_mm, part.radius_mm, tall, AROUND).rotateX(Math.PI / 2).translate(x, y, middle);
  }
  const [left, right] = part.x_mm;
  const [front, back] = part.y_mm;
  return new BoxGeometry(right - left, back - front, tall)
    .translate((left + right) / 2, (front + back) / 2, middle)
    .rotateZ((part.turn_deg * Math.PI) / 180);
}
