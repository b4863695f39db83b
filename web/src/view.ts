// The scene and the camera; draws only when something changed, and coarser while a slow machine moves.
import {
  PerspectiveCamera,
  Scene,
  Sphere,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Bed } from "./bed";
import { Dots } from "./dots";
import { Head } from "./head";
import { Strands } from "./strands";
import { Surface } from "./surface";
import { darkQuery, palette } from "./theme";
import { Travels } from "./travels";

export const VIEWS = {
  front: [0, -1, 0],
  side: [1, 0, 0],
  top: [0, 0, 1],
  "3D": [0.52, -0.74, 0.42],
} as const;
export type ViewName = keyof typeof VIEWS;

const FIELD_DEG = 28;
/** A frame that takes longer while the view moves makes the next ones coarser, ms. */
const SLOW_MS = 30;
/** Where that is not coarse enough, strands become thin lines. */
const COARSEST = 0.5;
/** After a frame as fast as this they are drawn as they are again, ms. */
const FAST_MS = SLOW_MS / 3;
/** So long after the last motion the picture is drawn as fine as it can be, ms. */
const REST_MS = 160;
const FLIGHT_MS = 420;
/** Samples along a pixel's edge in a picture that rests: strands have no other smoothing. */
const FINE = 2;
/** Where nothing turns by itself, a picture is asked for so long after the last motion, ms. */
const STILL_MS = 300;
/** Larger pictures are drawn with fewer samples. */
const MOST_PIXELS = 16e6;

export class View {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(FIELD_DEG, 1, 1, 1000);
  readonly controls: OrbitControls;
  readonly bed = new Bed();
  readonly head = new Head();
  readonly strands = new Strands();
  readonly surface = new Surface();
  readonly travels = new Travels();
  readonly breaches = new Dots(10);
  readonly weak = new Dots(9);
  onFrame: (timeMs: number) => boolean = () => false;
  /** Without WebGL: called with azimuth and elevation, degrees, once the view rests. */
  onStill: (azimuthDeg: number, elevationDeg: number) => void = () => undefined;
  /** Frames drawn so far, and how long the last ones took in motion. */
  readonly drawn = { frames: 0, motionMs: 0 };
  /** Null where the browser has no WebGL 2. */
  private readonly renderer: WebGLRenderer | null;
  private readonly sphere = new Sphere(new Vector3(0, 0, 40), 80);
  private flight: { from: [Vector3, Vector3]; to: [Vector3, Vector3]; begin: number } | null = null;
  private coarse = 1;
  private lined = false;
  private asked = 0;
  private askedMs = 0;
  private movedMs = 0;
  private resting = 0;
  private stilling = 0;

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = hasWebGl() ? new WebGLRenderer({ canvas, antialias: false, powerPreference: "high-performance" }) : null;
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.screenSpacePanning = true;
    this.controls.zoomToCursor = true;
    this.controls.minDistance = 2;
    this.controls.addEventListener("change", () => this.stir());
    this.scene.add(this.bed, this.surface, this.strands, this.travels, this.head, this.weak, this.breaches);
    new ResizeObserver(() => this.resize()).observe(canvas);
    darkQuery.addEventListener("change", () => this.paint());
    this.paint();
    this.look("3D", false);
  }

  /** Colours everything for light or dark; strands are coloured by those who know their labels. */
  paint(): void {
    const colours = palette();
    this.renderer?.setClearColor(colours.ground);
    this.bed.paint(colours);
    this.head.paint(colours);
    this.surface.paint(colours);
    this.travels.paint(colours);
    this.breaches.material.color.copy(colours.breach);
    this.weak.material.color.copy(colours.weak);
    this.redraw();
  }

  /** Whether it draws by itself, and not by pictures that it asks for. */
  get turns(): boolean {
    return this.renderer !== null;
  }

  /** Takes in what shall fill the picture. */
  frame(centre: Vector3, radius: number): void {
    this.sphere.set(centre, Math.max(radius, 1));
  }

  look(name: ViewName, flies = true): void {
    const [x, y, z] = VIEWS[name];
    const away = new Vector3(x, y, z).normalize();
    // Straight from above, "up" has no direction: a hair to the front gives it one.
    if (name === "top") away.set(0, -1e-4, 1).normalize();
    this.fly(this.sphere.center.clone(), away, this.distance(), flies);
  }

  /** Looks from an azimuth (0: the front) and an elevation, degrees. */
  lookFrom(azimuthDeg: number, elevationDeg: number): void {
    const [azimuth, elevation] = [(azimuthDeg * Math.PI) / 180, (Math.min(elevationDeg, 89.99) * Math.PI) / 180];
    const away = new Vector3(
      Math.sin(azimuth) * Math.cos(elevation),
      -Math.cos(azimuth) * Math.cos(elevation),
      Math.sin(elevation),
    );
    this.fly(this.sphere.center.clone(), away, this.distance(), false);
  }

  /** Turns the view to a place on the print, from the side that it is seen from already. */
  flyTo(place: Vector3): void {
    const away = this.camera.position.clone().sub(this.controls.target).normalize();
    this.fly(place, away, Math.max(this.distance() * 0.32, 20));
  }

  /** Where a place of the window is in the scene's terms, −1 to 1. */
  place(clientX: number, clientY: number): Vector2 {
    const box = this.canvas.getBoundingClientRect();
    return new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
  }

  /** How many mm a pixel of the window is at a place. */
  mmPerPixel(place: Vector3): number {
    const far = place.clone().sub(this.camera.position).dot(this.camera.getWorldDirection(new Vector3()));
    return (2 * far * Math.tan((FIELD_DEG * Math.PI) / 360)) / this.canvas.clientHeight;
  }

  redraw(): void {
    if (this.asked) return;
    this.askedMs = performance.now();
    this.asked = requestAnimationFrame((timeMs) => this.tick(timeMs));
  }

  /** A picture of the scene as it is, PNG. */
  picture(): Promise<Blob | null> {
    this.strands.thin = false;
    this.draw(FINE);
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }

  private distance(): number {
    const narrow = Math.min(this.camera.aspect, 1);
    return (this.sphere.radius * 1.08) / Math.sin(Math.atan(Math.tan((FIELD_DEG * Math.PI) / 360) * narrow));
  }

  private fly(target: Vector3, away: Vector3, distance: number, flies = true): void {
    const position = target.clone().addScaledVector(away, distance);
    if (!flies || matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.flight = null;
      this.camera.position.copy(position);
      this.controls.target.copy(target);
      this.controls.update();
    } else {
      const from: [Vector3, Vector3] = [this.camera.position.clone(), this.controls.target.clone()];
      this.flight = { from, to: [position, target], begin: performance.now() };
    }
    this.redraw();
  }

  /** Redraws as something moves: as finely as keeps up with the hand, and finely once it rests. */
  stir(): void {
    this.movedMs = performance.now();
    this.redraw();
  }

  /** Ends what it holds. */
  close(): void {
    cancelAnimationFrame(this.asked);
    this.asked = -1;
    this.controls.dispose();
    this.renderer?.dispose();
    this.renderer?.forceContextLoss();
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    const before = this.distance();
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    // What a wide window shows from side to side, a narrow one shows from farther away.
    const { position } = this.camera;
    position.sub(this.controls.target).multiplyScalar(this.distance() / before).add(this.controls.target);
    this.redraw();
  }

  private tick(timeMs: number): void {
    this.asked = 0;
    this.advanceFlight(timeMs);
    const playing = this.onFrame(timeMs);
    const moving = playing || this.flight !== null || timeMs - this.movedMs < REST_MS;
    if (!this.renderer) this.rest();
    else {
      if (moving) this.pace();
      this.strands.thin = moving && this.lined;
      this.draw(moving ? this.coarse : FINE);
    }
    if (playing || this.flight) this.redraw();
    else if (moving) {
      clearTimeout(this.resting);
      this.resting = window.setTimeout(() => this.redraw(), REST_MS);
    }
  }

  /** Draws coarser, then in lines, if a frame that was asked for came late; finer if they come at once. */
  private pace(): void {
    const took = performance.now() - this.askedMs;
    this.drawn.motionMs = took;
    if (took > SLOW_MS) {
      if (this.coarse === COARSEST) this.lined = true;
      this.coarse = Math.max(this.coarse / 2, COARSEST);
    } else if (took < FAST_MS) {
      if (this.lined) this.lined = false;
      else this.coarse = Math.min(this.coarse * 1.1, FINE);
    }
  }

  /** Asks for a picture from where it is looked from now, once that rests. */
  private rest(): void {
    clearTimeout(this.stilling);
    this.stilling = window.setTimeout(() => {
      const [x, y, z] = this.camera.position.clone().sub(this.controls.target).normalize().toArray();
      const degrees = 180 / Math.PI;
      this.onStill(Math.atan2(x, -y) * degrees, Math.asin(z) * degrees);
    }, STILL_MS);
  }

  private draw(scale: number): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height || !this.renderer) return;
    const most = Math.sqrt(MOST_PIXELS / (width * height));
    const ratio = Math.min(scale > 1 ? Math.max(devicePixelRatio, scale) : devicePixelRatio * scale, most);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    const size = this.renderer.getSize(new Vector2());
    if (size.x !== width || size.y !== height) this.renderer.setSize(width, height, false);
    const far = this.camera.position.distanceTo(this.sphere.center);
    const reach = Math.max(this.sphere.radius, 300);
    this.camera.near = Math.max((far - reach) * 0.9, far * 0.02, 0.2);
    this.camera.far = far + 3 * reach;
    this.camera.updateProjectionMatrix();
    for (const part of [this.strands, this.surface]) part.fade(far - 0.2 * this.sphere.radius, 2 * this.sphere.radius);
    this.renderer.render(this.scene, this.camera);
    this.drawn.frames += 1;
  }

  private advanceFlight(timeMs: number): void {
    if (!this.flight) return;
    const share = Math.min(Math.max((timeMs - this.flight.begin) / FLIGHT_MS, 0), 1);
    const eased = share * share * (3 - 2 * share);
    const [position, target] = this.flight.to;
    const [fromPosition, fromTarget] = this.flight.from;
    this.controls.target.lerpVectors(fromTarget, target, eased);
    // About the target rather than straight through it.
    const from = fromPosition.clone().sub(fromTarget);
    const to = position.clone().sub(target);
    const away = from.clone().lerp(to, eased);
    away.setLength(from.length() + (to.length() - from.length()) * eased);
    this.camera.position.copy(this.controls.target).add(away);
    if (share === 1) this.flight = null;
    this.controls.update();
  }
}

function hasWebGl(): boolean {
  const probe = document.createElement("canvas").getContext("webgl2");
  probe?.getExtension("WEBGL_lose_context")?.loseContext();
  return probe !== null;
}
