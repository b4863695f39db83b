// Places that are marked by dots over everything.
import { BufferAttribute, BufferGeometry, CanvasTexture, Points, PointsMaterial } from "three";
import type { Point } from "./protocol";

const SIZE_PX = 13;

export class Dots extends Points<BufferGeometry, PointsMaterial> {
  constructor(order: number) {
    super(
      new BufferGeometry(),
      new PointsMaterial({ size: SIZE_PX, sizeAttenuation: false, depthTest: false, transparent: true, map: disc() }),
    );
    this.renderOrder = order;
    this.visible = false;
  }

  /** Marks other places, mm. */
  take(places: Point[]): void {
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(new Float32Array(places.flat()), 3));
    this.visible = places.length > 0;
  }
}

function disc(): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const ink = canvas.getContext("2d")!;
  ink.fillStyle = "#fff";
  ink.beginPath();
  ink.arc(32, 32, 26, 0, 2 * Math.PI);
  ink.fill();
  return new CanvasTexture(canvas);
}
