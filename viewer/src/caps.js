// SPDX-License-Identifier: Apache-2.0
// Section faces: what a plane cuts of each closed solid is filled with its hatch and outlined. The stencil
// buffer counts, part by part, how often a ray behind the plane leaves the solid and enters it.
import {
  AlwaysStencilFunc,
  BackSide,
  BufferGeometry,
  Color,
  DecrementWrapStencilOp,
  DoubleSide,
  EqualStencilFunc,
  Float32BufferAttribute,
  FrontSide,
  IncrementWrapStencilOp,
  LessDepth,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  NotEqualStencilFunc,
  Quaternion,
  ReplaceStencilOp,
  ShaderMaterial,
  Sphere,
  Vector3,
} from "three";
import { HATCHES, boxOf, hatchesOf, isClosed } from "./hatch.js";
import { cutLines } from "./outlines.js";

/** Parts that are first in this list cover others that overlap them, as a spindle in a gear without bore. */
const ORDER = ["shaft", "element", "bearing", "gear", "carrier", "spring", "body", "housing"];
const SPACING = 9; // of hatch lines [px]
const Z = new Vector3(0, 0, 1);

/** Bits of the stencil buffer: number of surfaces of the current part, and what the faces of others cover. */
const COUNT = 0x7f,
  COVERED = 0x80;

/** Material that counts surfaces in the stencil buffer. @param {boolean} back */
function counter(back) {
  return new MeshBasicMaterial({
    side: back ? BackSide : FrontSide,
    colorWrite: false,
    depthWrite: false,
    depthTest: false,
    stencilWrite: true,
    stencilFunc: AlwaysStencilFunc,
    stencilWriteMask: COUNT,
    stencilZPass: back ? IncrementWrapStencilOp : DecrementWrapStencilOp,
  });
}

function hatchMaterial() {
  return new ShaderMaterial({
    uniforms: {
      paint: { value: new Color() },
      line: { value: new Color() },
      across: { value: new Vector3() },
      phase: { value: 0 },
      opacity: { value: 1 },
    },
    vertexShader: `varying vec2 at;
      void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
    fragmentShader: `varying vec2 at;
      uniform vec3 paint, line, across;
      uniform float phase, opacity;
      void main() {
        float s = dot(at, across.xy) + phase;
        float wide = max(length(vec2(dFdx(s), dFdy(s))), 1e-9);
        float inked = 1.0 - smoothstep(0.35, 1.15, abs(fract(s) - 0.5) / wide);
        gl_FragColor = vec4(mix(paint, line, inked * min(1.0, 0.25 / wide)), opacity);
        #include <colorspace_fragment>
      }`,
    side: DoubleSide,
    depthFunc: LessDepth,
    stencilWrite: true,
    stencilFunc: NotEqualStencilFunc,
    stencilFuncMask: COUNT,
    stencilRef: COVERED,
    stencilZPass: ReplaceStencilOp,
    stencilZFail: ReplaceStencilOp,
  });
}

export class Caps {
  /** @param {import("./solids.js").Solids} solids @param {any} bounds of the scene */
  constructor(solids, bounds) {
    this.solids = solids;
    this.whole = bounds.whole;
    const square = new BufferGeometry();
    square.setAttribute("position", new Float32BufferAttribute([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 3));
    square.setIndex([0, 1, 2, 0, 2, 3]);
    // Single solids and copies have materials of their own, because each change of use costs time.
    this.counters = [false, true].map(() => [counter(true), counter(false)]);
    this.face = new Mesh(square, hatchMaterial());
    
    this.face.matrixAutoUpdate = false;
    this.face.frustumCulled = false;
    this.lines = new LineSegments(
      new BufferGeometry(),
      new LineBasicMaterial({ stencilWrite: true, stencilFunc: EqualStencilFunc, stencilFuncMask: COVERED }),
    );
    this.lines.matrixAutoUpdate = false;
    this.lines.frustumCulled = false;
  }

  /** What is cut: parts, or whole batches; hatches are chosen when they are first needed. */
  #members() {
    const { parts, batches, poses } = this.solids;
    if (this.members) return this.members;
    const one = (part) => ({
      part,
      objects: part.repeated?.meshes ?? [part.mesh],
      colour: new Color(part.colour),
      kind: part.solid.kind,
      shows: () => this.solids.shows(part),
      clear: part.solid.see_through,
    });
    const all = (batch) => ({
      batch,
      objects: [batch],
      colour: new Color("#9aa5b1"),
      kind: "body",
      shows: () => true,
      clear: false,
    });
    const found = batches.length
      ? batches.map(all)
      : parts.filter((part) => isClosed(part.geometry)).map(one);
    const hatches = batches.length ? found.map(() => 0) : hatchesOf(found.map(({ part }) => boxOf(part, poses.ofSolid(part.solid))));
    found.forEach((member, k) => (member.hatch = HATCHES[hatches[k]]));
    const rank = ({ kind }) => (ORDER.indexOf(kind) + ORDER.length) % ORDER.length;
    return (this.members = found.sort((a, b) => rank(a) - rank(b)));
  }

  /** Hatches of the cut parts by name. */
  state() {
    return Object.fromEntries((this.shown ?? []).map(({ part, hatch }) => [part?.solid.name ?? "", hatch]));
  }

  /**
   * @param {import("three").WebGLRenderer} renderer
   * @param {import("./camera.js").Camera} camera
   * @param {import("three").Plane} plane in the camera's world; the side that its normal points to is kept
   * @param {Matrix4} seen from the scene to the camera's world
   * @param {number} pixel size at the target [m]
   * @param {{left: number, width: number, height: number}} view viewport [px]
   */
  render(renderer, camera, plane, seen, pixel, view) {
    for (const material of this.counters.flat()) material.clippingPlanes = [plane];
    const spacing = 2 ** Math.round(Math.log2(SPACING * pixel));
    this.#place(plane, seen, spacing);
    this.shown = [];
    for (const member of this.#members()) {
      if (!member.shows() || !this.#cuts(member, plane)) continue;
      const lines = member.batch ? [] : this.#outline(member, plane);
      if (!member.batch && !lines.length) continue;
      this.shown.push(member);
      if (lines.length && !this.#within(renderer, camera, lines, view)) continue;
      this.#draw(renderer, camera, lines, member, plane, pixel);
      this.#count(renderer, camera, member);
      this.#hatch(member, spacing);
      renderer.render(this.face, camera);
    }
    renderer.setScissor(view.left, 0, view.width, view.height);
    if (this.shown.length) renderer.clearStencil();
  }

  /**
   * Restrict drawing to the rectangle around the outline of a face.
   * @returns {boolean} whether it is in the view
   */
  #within(renderer, camera, lines, { left, width, height }) {
    VIEW.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const e = VIEW.elements;
    let [low, high, bottom, top] = [1, -1, 1, -1];
    for (let k = 0; k < lines.length; k += 3) {
      const x = lines[k],
        y = lines[k + 1],
        z = lines[k + 2];
      const w = e[3] * x + e[7] * y + e[11] * z + e[15];
      if (w <= 0) {
        // Behind the camera: the whole view.
        [low, high, bottom, top] = [-1, 1, -1, 1];
        break;
      }
      const u = (e[0] * x + e[4] * y + e[8] * z + e[12]) / w,
        v = (e[1] * x + e[5] * y + e[9] * z + e[13]) / w;
      low = Math.min(low, u);
      high = Math.max(high, u);
      bottom = Math.min(bottom, v);
      top = Math.max(top, v);
    }
    const edge = (value, size, round) => Math.max(0, Math.min(size, round(((value + 1) / 2) * size)));
    const x = edge(low, width, Math.floor),
      y = edge(bottom, height, Math.floor);
    const wide = edge(high, width, Math.ceil) - x,
      tall = edge(top, height, Math.ceil) - y;
    if (wide <= 0 || tall <= 0) return false;
    renderer.setScissor(left + x, y, wide, tall);
    return true;
  }

  /** One face for all parts: overlapping ones then have the same depth, and the first one stays. */
  #place(plane, seen, spacing) {
    const centre = plane.projectPoint(this.whole.centre.clone().applyMatrix4(seen), new Vector3());
    TURN.setFromUnitVectors(Z, plane.normal);
    const { radius } = this.whole;
    const half = 1.5 * radius;
    this.face.matrix.compose(centre, TURN, ONE.set(half, half, 1));
    this.face.matrixWorldNeedsUpdate = true;
    this.half = half;
    // Lines are fixed to the origin of the world, so that the hatch does not move with the view.
    this.x = centre.dot(new Vector3(1, 0, 0).applyQuaternion(TURN)) / spacing;
    this.y = centre.dot(new Vector3(0, 1, 0).applyQuaternion(TURN)) / spacing;
  }

  #hatch({ colour, hatch, clear }, spacing) {
    const { uniforms } = this.face.material;
    const each = spacing * hatch.spacing;
    // Lines across this direction: the angle is that of the lines.
    const [x, y] = [-Math.sin(hatch.angle), Math.cos(hatch.angle)];
    uniforms.across.value.set((x * this.half) / each, (y * this.half) / each, 0);
    const phase = (x * this.x + y * this.y) / hatch.spacing;
    uniforms.phase.value = phase - Math.floor(phase);
    uniforms.paint.value.copy(colour);
    uniforms.line.value.copy(colour).multiplyScalar(0.3);
    uniforms.opacity.value = clear ? 0.75 : 1;
    this.face.material.transparent = Boolean(clear);
  }

  #cuts({ part, batch }, plane) {
    if (batch) return true;
    SPHERE.copy(part.geometry.boundingSphere).applyMatrix4(part.mesh.matrixWorld);
    return part.blend || part.modal || Math.abs(plane.distanceToPoint(SPHERE.center)) <= SPHERE.radius;
  }

  #count(renderer, camera, { objects, batch }) {
    const own = objects.map(({ material }) => material);
    for (const material of this.counters[Number(Boolean(objects[0].isInstancedMesh))]) {
      const used = batch ? batch.adapted(material) : material;
      for (const object of objects) object.material = used;
      for (const object of objects) if (object.visible) renderer.render(object, camera);
    }
    objects.forEach((object, k) => (object.material = own[k]));
  }

  /** @param {any} member @param {import("three").Plane} plane */
  #outline({ part }, plane) {
    const out = [];
    if (!part.repeated) {
      if (part.blend || part.modal) part.geometry.computeBoundingSphere();
      cutLines(part.geometry, part.mesh.matrixWorld, plane, out);
      return out;
    }
    for (const { turns, levels } of part.repeated.pieces)
      for (const { geometry, shown } of levels)
        for (const k of shown)
          cutLines(geometry, PLACED.makeRotationZ(turns[k]).premultiply(part.mesh.matrixWorld), plane, out);
    return out;
  }

  #draw(renderer, camera, lines, { colour }, plane, pixel) {
    if (!lines.length) return;
    const { geometry } = this.lines;
    // Relative to a point of the plane, in single precision; slightly in front of the face.
    const [x, y, z] = lines;
    const points = new Float32Array(lines.length);
    for (let k = 0; k < lines.length; k += 3) {
      points[k] = lines[k] - x;
      points[k + 1] = lines[k + 1] - y;
      points[k + 2] = lines[k + 2] - z;
    }
    geometry.dispose();
    geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
    this.lines.matrix.setPosition(new Vector3(x, y, z).addScaledVector(plane.normal, -0.7 * pixel));
    this.lines.matrixWorldNeedsUpdate = true;
    this.lines.material.color.copy(colour).multiplyScalar(0.16);
    renderer.render(this.lines, camera);
  }
}

const TURN = new Quaternion();
const ONE = new Vector3();
const PLACED = new Matrix4();
const VIEW = new Matrix4();
const SPHERE = new Sphere();
