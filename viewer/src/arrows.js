// SPDX-License-Identifier: Apache-2.0
// Force arrows: up to three components per point of action, each in its own colour, drawn on top of the
// solids.
import {
  BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import { FORCES, STATES, colourOfForce } from "./colours.js";
import { lerp } from "./frames.js";
import { Z } from "./poses.js";

const FEW = 6; // more arrows are smaller, and some are omitted
const SMALLEST = 0.45; // their minimum relative size
const THIN_OUT = 40; // distance of points of action below which only the largest force is shown [px]
const SLIGHT = 0.06; // fraction of the largest force below which components are not shown
const LONGEST = 300; // length on the screen of the largest force, from which arrows no longer grow with the scene [px]
const MOST_BEARINGS = 8; // with more bearings, bearing forces are hidden by default

/** Arrow of unit length along z with a head of unit diameter. */
function arrowShape() {
  const shaft = new CylinderGeometry(0.19, 0.19, 0.72, 12, 1, false).translate(0, 0.36, 0);
  const head = new ConeGeometry(0.5, 0.3, 16, 1, false).translate(0, 0.85, 0);
  const parts = [shaft.toNonIndexed(), head.toNonIndexed()];
  const join = (name) => parts.flatMap((part) => [...part.attributes[name].array]);
  const shape = new BufferGeometry();
  shape.setAttribute("position", new Float32BufferAttribute(join("position"), 3));
  shape.setAttribute("normal", new Float32BufferAttribute(join("normal"), 3));
  return shape.rotateX(Math.PI / 2);
}

/**
 * Force at one instant.
 * @typedef {{name: string, kind: string, unit: string, state: number|null, vectors: Record<string, Vector3>,
 *   at: Vector3, values: Record<string, number>, total: number}} Force
 */

export class Arrows {
  /**
   * @param {any} scene
   * @param {import("three").Group} root group drawn on top of the solids
   * @param {import("./poses.js").Poses} poses
   * @param {Element} element
   * @param {number} radius of the scene [m]
   */
  constructor(scene, root, poses, element, radius) {
    this.arrows = scene.arrows;
    this.poses = poses;
    this.radius = radius;
    this.scale = 1;
    this.kinds = new Set(this.arrows.map((arrow) => arrow.kind));
    // The forces of tooth pairs duplicate those of the meshes, and the arrows of many bearings obscure the
    // parts.
    this.shown = new Set(this.kinds);
    this.shown.delete("pair");
    if (this.arrows.filter((arrow) => arrow.kind === "bearing").length > MOST_BEARINGS)
      this.shown.delete("bearing");
    this.hidden = false;
    /** Whether there are so many arrows that small components, and arrows close to larger ones, are omitted. */
    this.many = this.arrows.filter(({ kind }) => kind !== "pair").length > FEW;
    this.sparse = this.many;
    const shape = arrowShape();
    const ball = new SphereGeometry(0.5, 14, 10);
    const lit = (colour) =>
      new MeshLambertMaterial({ color: colour, emissive: colour, emissiveIntensity: 0.35 });
    const materials = Object.fromEntries(FORCES.map((part) => [part, lit(colourOfForce(element, part))]));
    this.states = Object.fromEntries(
      Object.entries(STATES).map(([state, { colour }]) => [state, lit(colour)]),
    );
    const add = (geometry, material) => {
      const mesh = new Mesh(geometry, material);
      mesh.matrixAutoUpdate = false;
      root.add(mesh);
      return mesh;
    };
    this.drawn = this.arrows.map((arrow) => ({
      parts: Object.fromEntries(
        FORCES.filter((part) => (arrow.components ?? arrow.largest)?.[part]).map((part) => [
          part,
          add(shape, materials[part]),
        ]),
      ),
      ball: arrow.state ? add(ball, this.states[0]) : null,
    }));
    this.largest = this.arrows.map((arrow) =>
      arrow.largest ?? Object.fromEntries(
        FORCES.filter((part) => arrow.components?.[part]).map((part) => [
          part,
          longestRow(arrow.components[part].data),
        ]),
      ),
    );
    // A common scale makes arrow lengths comparable.
    this.size = Math.max(0, ...this.arrows.map((arrow) => arrow.size ?? 0));
  }

  /** Adapt the scale if the forces have become larger. */
  grow() {
    const sum = new Vector3();
    this.arrows.forEach((arrow, k) => {
      if (!arrow.components) return;
      sum.set(0, 0, 0);
      for (const [part, { data }] of Object.entries(arrow.components)) {
        this.largest[k][part] = Math.max(this.largest[k][part] ?? 0, longestRow(data));
        sum.add(SIZE.fromArray(data));
      }
      arrow.size = Math.max(arrow.size ?? 0, sum.length());
      this.size = Math.max(this.size, arrow.size);
    });
  }

  /** Relative size of the arrows, which decreases with their number. */
  get share() {
    if (!this.sparse) return 1;
    const count = this.arrows.filter(({ kind }) => this.shown.has(kind) && kind !== "pair").length;
    return Math.max(SMALLEST, Math.min(1, Math.sqrt(FEW / Math.max(count, 1))));
  }

  /** Length of the arrow of the largest force [m]. */
  get longest() {
    return 0.55 * this.radius * this.scale * this.share;
  }

  /** Forces at the current instant. @returns {Force[]} */
  forces() {
    const { where } = this.poses;
    return this.arrows.map((arrow) => {
      if (arrow.now) return { name: arrow.name, kind: arrow.kind, unit: arrow.unit, ...arrow.now() };
      const frame = arrow.body < 0 ? null : this.poses.still[arrow.body];
      const at = new Vector3(lerp(arrow.at, where, 0), lerp(arrow.at, where, 1), lerp(arrow.at, where, 2));
      if (frame) at.applyMatrix4(frame);
      const vectors = {},
        values = {};
      const sum = new Vector3();
      for (const part of FORCES) {
        const table = arrow.components?.[part];
        if (!table) continue;
        const vector = new Vector3(lerp(table, where, 0), lerp(table, where, 1), lerp(table, where, 2));
        values[part] = vector.length();
        sum.add(vector);
        if (frame) (TURN.extractRotation(frame), vector.applyMatrix4(TURN));
        vectors[part] = vector;
      }
      // Contact states are discrete and are not interpolated: the preceding frame applies.
      const row = arrow.state ? (where.share === 1 ? where.low + 1 : where.low) : 0;
      const byte = arrow.state ? arrow.state.data[arrow.state.count > 1 ? row : 0] : null;
      const state = byte === 255 ? -1 : byte;
      return {
        name: arrow.name,
        kind: arrow.kind,
        unit: arrow.unit ?? "N",
        state,
        vectors,
        values,
        at,
        total: sum.length(),
      };
    });
  }

  /** Tips of the arrows at their maximum length in the current directions; the fitted view includes them. */
  ends() {
    if (this.hidden || !(this.size > 0)) return [];
    return this.forces().flatMap((force, k) =>
      this.shown.has(force.kind)
        ? Object.entries(force.vectors).map(([part, vector]) => {
            const length = (this.longest * (this.largest[k][part] ?? 0)) / this.size;
            return vector
              .clone()
              .setLength(vector.length() ? length : 0)
              .add(force.at);
          })
        : [],
    );
  }

  /**
   * Forces that are shown: without those close to a larger one of the same kind on the screen.
   * @param {(point: Vector3) => {x: number, y: number, removed: boolean}} [onScreen]
   */
  #kept(onScreen) {
    const kept = new Set();
    const places = [];
    const order = this.now.map((_, k) => k).filter((k) => this.shown.has(this.now[k].kind));
    // Sizes over the record, so that arrows do not come and go.
    order.sort((a, b) => (this.arrows[b].size ?? 0) - (this.arrows[a].size ?? 0));
    for (const k of order) {
      const { kind, at } = this.now[k];
      const place = onScreen?.(at);
      if (place?.removed) continue;
      if (place && this.sparse && kind !== "pair") {
        const near = (other) => other.kind === kind && Math.hypot(other.x - place.x, other.y - place.y) < THIN_OUT;
        if (places.some(near)) continue;
        places.push({ ...place, kind });
      }
      kept.add(k);
    }
    return kept;
  }

  /**
   * @param {number} visible size of a pixel in the scene [m]
   * @param {(point: Vector3) => {x: number, y: number, removed: boolean}} [onScreen] position of a point
   *   [px], and whether a section has removed it
   */
  update(visible, onScreen) {
    this.now = this.forces();
    const kept = this.hidden ? new Set() : this.#kept(onScreen);
    const slight = this.sparse ? SLIGHT * this.size : 0;
    const longest = Math.min(this.longest, LONGEST * this.scale * this.share * visible || Infinity);
    /** Length of an arrow per force [m/N], 0 without arrows. */
    this.perForce = kept.size && this.size > 0 ? longest / this.size : 0;
    this.now.forEach((force, k) => {
      const on = kept.has(k);
      const { parts, ball } = this.drawn[k];
      const thick = this.share * Math.min(0.055 * this.radius * Math.sqrt(this.scale), 22 * visible || Infinity);
      for (const [part, mesh] of Object.entries(parts)) {
        const vector = force.vectors[part];
        const length = this.size > 0 ? (longest * vector.length()) / this.size : 0;
        const seen = on && (force.kind === "pair" || (this.largest[k][part] ?? 0) > slight);
        mesh.visible = seen && length > 2 * visible && length > 0;
        if (!mesh.visible) continue;
        const width = Math.min(thick, 0.5 * length);
        DIRECTION.copy(vector).normalize();
        mesh.matrix.compose(
          force.at,
          TURNED.setFromUnitVectors(Z, DIRECTION),
          SIZE.set(width, width, length),
        );
      }
      if (!ball) return;
      ball.visible = on;
      ball.material = this.states[force.state] ?? this.states[0];
      ball.matrix.makeScale(0.6 * thick, 0.6 * thick, 0.6 * thick).setPosition(force.at);
    });
  }
}

const TURN = new Matrix4();
const TURNED = new Quaternion();
const DIRECTION = new Vector3();
const SIZE = new Vector3();

/** Maximum length of the vectors of a table. @param {import("./scene_file.js").Numbers} data */
function longestRow(data) {
  let most = 0;
  for (let k = 0; k < data.length; k += 3)
    most = Math.max(most, Math.hypot(data[k], data[k + 1], data[k + 2]));
  return most;
}
