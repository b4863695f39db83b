// The model's surface: what is marked on it, and the strokes whose answer is not there yet.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  DoubleSide,
  FloatType,
  GLSL3,
  Group,
  Matrix4,
  Mesh,
  NearestFilter,
  Raycaster,
  RawShaderMaterial,
  RGBAFormat,
  Vector2,
  Vector3,
} from "three";
import { acceleratedRaycast, MeshBVH } from "three-mesh-bvh";
import type { Shape } from "./protocol";
import type { Palette } from "./theme";

/** Points of strokes that can be shown before they are answered. */
const MOST_POINTS = 2048;

const VERTEX = `
precision highp float;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
in vec3 position;
out vec3 own, placed, seen;
void main() {
  own = position;
  placed = (modelMatrix * vec4(position, 1)).xyz;
  seen = (viewMatrix * vec4(placed, 1)).xyz;
  gl_Position = projectionMatrix * vec4(seen, 1);
}`;

const FRAGMENT = `
precision highp float;
precision highp sampler2D;
uniform vec3 base, bare, paint, erased, ground;
uniform vec2 fog;
uniform float top;                   // nothing is shown above, mm
uniform sampler2D strokes;           // two rows: place and radius; normal, and what begins here
uniform int points;
uniform float agreement;             // least cosine between normals that agree
in vec3 own, placed, seen;
out vec4 pixel;
// What the strokes leave here: 0 nothing, 1 paint, 2 erased; the last that covers wins. The distance to
// a polyline and the agreement of normals are those of wireprint.regions.stroke.
int covered(vec3 normal) {
  int found = 0, begun = 0;
  for (int i = 0; i < points; i++) {
    vec4 to = texelFetch(strokes, ivec2(i, 0), 0), facing = texelFetch(strokes, ivec2(i, 1), 0);
    bool begins = facing.w > 0.5;
    if (begins) begun = facing.w > 1.5 ? 2 : 1;
    vec4 from = begins ? to : texelFetch(strokes, ivec2(i - 1, 0), 0);
    vec3 was = begins ? facing.xyz : texelFetch(strokes, ivec2(i - 1, 1), 0).xyz;
    vec3 run = to.xyz - from.xyz, offset = own - from.xyz;
    float along = clamp(dot(offset, run) / max(dot(run, run), 1e-12), 0.0, 1.0);
    vec3 away = offset - along * run;
    if (dot(away, away) > to.w * to.w) continue;
    if (dot(normalize(mix(was, facing.xyz, along) + vec3(0, 0, 1e-9)), normal) >= agreement) found = begun;
  }
  return found;
}
void main() {
  if (placed.z > top) discard;
  vec3 flatOwn = normalize(cross(dFdx(own), dFdy(own)));
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  if (normal.z < 0.0) { normal = -normal; }
  vec3 outward = gl_FrontFacing ? flatOwn : -flatOwn;
  vec3 colour = base;
  int stroke = points > 0 ? covered(outward) : 0;
  if (stroke == 1) colour = paint;
  if (stroke == 2) colour = mix(bare, erased, 0.6);
  float lamp = max(dot(normal, vec3(-0.372, 0.558, 0.742)), 0.0);
  float sky = 0.5 + 0.5 * normal.y;
  vec3 lit = colour * (0.58 + 0.16 * sky + 0.32 * lamp);
  if (!gl_FrontFacing) lit = mix(lit * 0.72, ground, 0.15);
  float far = clamp((-seen.z - fog.x) / fog.y, 0.0, 1.0);
  pixel = vec4(mix(min(lit, 1.0), ground, 0.35 * far), 1);
}`;

export interface Hit {
  /** In the model's own frame, mm. */
  point: Vector3;
  normal: Vector3;
  /** In the scene. */
  placed: Vector3;
  facing: Vector3;
}

export type Stroke = Extract<Shape, { kind: "stroke" }>;

/** A stroke that is shown before the print answers it. */
export interface Pending {
  shape: Stroke;
  erase: boolean;
}

function material(strokes: DataTexture): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    polygonOffset: true,
    uniforms: {
      base: { value: new Vector3() },
      bare: { value: new Vector3() },
      paint: { value: new Vector3() },
      erased: { value: new Vector3() },
      ground: { value: new Vector3() },
      fog: { value: new Vector2(0, 1) },
      top: { value: Infinity },
      strokes: { value: strokes },
      points: { value: 0 },
      agreement: { value: 0 },
    },
  });
}

/** The model where it is printed: its group takes the model's own frame there. */
export class Surface extends Group {
  readonly body: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly paintwork: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly strokes: DataTexture;
  private readonly texels = new Float32Array(MOST_POINTS * 2 * 4);
  private tree: MeshBVH | null = null;
  private readonly caster = new Raycaster();

  constructor() {
    super();
    this.matrixAutoUpdate = false;
    this.strokes = new DataTexture(this.texels, MOST_POINTS, 2, RGBAFormat, FloatType);
    this.strokes.internalFormat = "RGBA32F";
    this.strokes.minFilter = this.strokes.magFilter = NearestFilter;
    this.body = new Mesh(new BufferGeometry(), material(this.strokes));
    this.paintwork = new Mesh(new BufferGeometry(), material(this.strokes));
    // Strands lie on the surface, and paint on the model: each is drawn a little nearer.
    Object.assign(this.body.material, { polygonOffsetFactor: 2, polygonOffsetUnits: 4 });
    Object.assign(this.paintwork.material, { polygonOffsetFactor: 1, polygonOffsetUnits: 2 });
    this.body.raycast = acceleratedRaycast;
    this.add(this.body, this.paintwork);
  }

  /** Takes a new model; its tree is built when the pointer first asks for it. */
  take(vertices: Float32Array, faces: Uint32Array): void {
    this.body.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(vertices, 3));
    geometry.setIndex(new BufferAttribute(faces, 1));
    geometry.computeBoundingSphere();
    geometry.computeBoundingBox();
    this.body.geometry = geometry;
    this.tree = null;
    this.mark(new Float32Array());
  }

  /** Builds the tree while nobody waits for it. */
  prepare(): void {
    if (this.tree || !this.body.geometry.index) return;
    // The tree sorts triangles; the geometry keeps its own order.
    this.tree = new MeshBVH(this.body.geometry, { indirect: true });
    this.body.geometry.boundsTree = this.tree;
  }

  place(rows: number[][]): void {
    this.matrix.copy(new Matrix4().set(...(rows.flat() as Parameters<Matrix4["set"]>)));
    this.matrixWorldNeedsUpdate = true;
  }

  /** Takes the triangles that are marked. */
  mark(corners: Float32Array): void {
    this.paintwork.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    this.paintwork.geometry = geometry;
    this.paintwork.visible = corners.length > 0;
  }

  paint(colours: Palette): void {
    for (const mesh of [this.body, this.paintwork]) {
      const uniforms = mesh.material.uniforms;
      const plain = (name: string, colour: Color) =>
        (uniforms[name]!.value as Vector3).setFromColor(colour.clone().convertLinearToSRGB());
      plain("base", mesh === this.body ? colours.model : colours.paint);
      plain("bare", colours.model);
      plain("paint", colours.paint);
      plain("erased", colours.erased);
      plain("ground", colours.ground);
    }
  }

  hideAbove(topMm: number): void {
    for (const mesh of [this.body, this.paintwork]) mesh.material.uniforms.top!.value = topMm;
  }

  fade(from: number, over: number): void {
    for (const mesh of [this.body, this.paintwork]) (mesh.material.uniforms.fog!.value as Vector2).set(from, over);
  }

  /** What of the model is under a place on the screen (−1 to 1), and which way it faces. */
  pick(place: Vector2, camera: Parameters<Raycaster["setFromCamera"]>[1]): Hit | null {
    this.prepare();
    if (!this.tree) return null;
    this.caster.setFromCamera(place, camera);
    const top = this.body.material.uniforms.top!.value as number;
    // What the slab slider hides is not met either.
    this.caster.firstHitOnly = top === Infinity;
    const found = this.caster.intersectObject(this.body, false).find((hit) => hit.point.z <= top);
    if (!found?.face) return null;
    const normal = found.face.normal.clone();
    return {
      point: this.worldToLocal(found.point.clone()),
      normal,
      placed: found.point.clone(),
      facing: normal.clone().transformDirection(this.matrixWorld),
    };
  }

  /** Shows strokes at once, over what is marked. */
  preview(strokes: readonly Pending[]): void {
    let count = 0;
    for (const { shape, erase } of strokes) {
      shape.points_mm.forEach((point, i) => {
        if (count === MOST_POINTS) return;
        const begins = i > 0 ? 0 : erase ? 2 : 1;
        this.texels.set([...point, shape.radius_mm], 4 * count);
        this.texels.set([...(shape.normals[i] ?? shape.normals[0]!), begins], 4 * (MOST_POINTS + count));
        count += 1;
      });
    }
    this.strokes.needsUpdate = true;
    const spread = strokes.at(-1)?.shape.spread_deg ?? 0;
    for (const mesh of [this.body, this.paintwork]) {
      mesh.material.uniforms.points!.value = count;
      mesh.material.uniforms.agreement!.value = Math.cos((spread * Math.PI) / 180);
    }
  }
}
