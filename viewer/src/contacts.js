// SPDX-License-Identifier: Apache-2.0
// Contact lines of a mesh at an instant, straight lines in the plane of action, and the loads on them.
import { Matrix4, Quaternion, Vector3 } from "three";
import { alongPairs, place as placed } from "./cones.js";
import { lerp } from "./frames.js";

/**
 * A contact line: end points in the world, pair and flank side, force along the base tangent, loads along the
 * line. `ends`: positions of the end points on path of contact and face width.
 * @typedef {{pair: number, slot: number, side: number, from: Vector3, to: Vector3, at: (share: number) =>
 *   Vector3, force: number, loads: Float64Array, centre: Vector3, ray: number, ends: [number, number][]}}
 *   Line
 */

const modulo = (a, n) => ((a % n) + n) % n;

/**
 * Tooth pairs whose contact lines lie on the face at a given travel, and the part of the width that they
 * cover.
 * @param {any} contact
 * @param {any} flank
 * @param {number} travel
 */
export function reached(contact, flank, travel) {
  const slope = flank.side * Math.tan(contact.base_helix);
  const [low, high] = contact.width,
    [start, end] = contact.path,
    pitch = contact.base_pitch;
  const ends = [slope * low, slope * high];
  const found = [];
  const first = Math.ceil((travel + Math.min(...ends) - end) / pitch);
  const last = Math.floor((travel + Math.max(...ends) - start) / pitch);
  for (let pair = first; pair <= last; pair++) {
    const place = travel - pair * pitch;
    const limits = slope ? [(start - place) / slope, (end - place) / slope] : [low, high];
    if (!slope && (place < start || place > end)) continue;
    const from = Math.max(low, Math.min(...limits)),
      to = Math.min(high, Math.max(...limits));
    if (to >= from) found.push({ pair, place, slope, from, to });
  }
  return found;
}

export class Contact {
  /** @param {any} contact entry of the scene @param {import("./poses.js").Poses} poses */
  constructor(contact, poses) {
    this.contact = contact;
    this.poses = poses;
    this.name = contact.name;
    this.greatest = Math.max(0, ...contact.flanks.map((flank) => most(flank.loads)));
    this.pairs = Math.max(0, ...contact.flanks.map((flank) => flank.forces?.width ?? 0));
    this.matrix = new Matrix4();
  }

  /** Mesh frame in the world at the current instant: x towards gear 2, y tangential, z axial. */
  frame() {
    const { contact, poses } = this;
    const { where } = poses;
    TURN.set(...[0, 1, 2, 3].map((c) => lerp(contact.axes, where, c))).normalize();
    POINT.set(...[0, 1, 2].map((c) => lerp(contact.at, where, c)));
    return this.matrix.compose(POINT, TURN, ONE);
  }

  /** Direction of the line of action for one flank side, in the mesh frame. @param {number} side */
  normal(side) {
    const alpha = lerp(this.contact.pressure_angle, this.poses.where);
    return new Vector3(Math.sin(alpha), side * Math.cos(alpha), 0);
  }

  /** Contact lines of all tooth pairs on the face. @returns {Line[]} */
  lines() {
    const frame = this.frame();
    return this.contact.flanks.flatMap((flank) => {
      const travel = lerp(flank.travel, this.poses.where);
      const normal = this.normal(flank.side);
      const point = (x, z) => placed(this.contact.cone, normal, x, z).applyMatrix4(frame);
      return reached(this.contact, flank, travel).map(({ pair, place, slope, from, to }) => {
        const { force, loads } = this.#carried(flank, pair);
        const weight = loads.reduce((sum, load) => sum + load, 0);
        const middle = weight
          ? loads.reduce((sum, load, k) => sum + (load * k) / (loads.length - 1), 0) / weight
          : 0.5;
        const at = (share) => {
          const z = from + share * (to - from);
          return point(place + slope * z, z);
        };
        return {
          pair,
          side: flank.side,
          slot: modulo(pair, Math.max(1, this.pairs)),
          from: at(0),
          to: at(1),
          at,
          centre: at(middle),
          ray: place + slope * (from + middle * (to - from)),
          force,
          loads,
          ends: [from, to].map((z) => [place + slope * z, z]),
        };
      });
    });
  }

  /**
   * Interpolated force and loads of a tooth pair. They are zero in a frame where another pair occupies its
   * column.
   */
  #carried(flank, pair) {
    const loads = new Float64Array(flank.loads ? flank.loads.shape[2] : 2);
    let force = 0;
    if (!flank.loads) return { force, loads };
    const slot = modulo(pair, flank.forces.width);
    const { low, share } = this.poses.where;
    const rows = share ? [low, low + 1] : [low];
    rows.forEach((row, k) => {
      const weight = k ? share : 1 - share;
      const travel = flank.travel.data[row];
      if (!reached(this.contact, flank, travel).some((one) => one.pair === pair)) return;
      force += weight * flank.forces.data[row * flank.forces.width + slot];
      const at = row * flank.loads.width + slot * loads.length;
      for (let s = 0; s < loads.length; s++) loads[s] += weight * flank.loads.data[at + s];
    });
    return { force, loads };
  }

  /** Penetration of front and back flanks, negative for a gap [m]. */
  penetration() {
    const { penetration } = this.contact;
    return { 1: lerp(penetration, this.poses.where, 0), "-1": lerp(penetration, this.poses.where, 1) };
  }

  /** Forces of the tooth pairs in the form of arrows. @param {Line[]} lines */
  pairForces(lines) {
    const frame = this.matrix;
    const alpha = lerp(this.contact.pressure_angle, this.poses.where);
    const tangent = Math.tan(this.contact.base_helix);
    const { cone } = this.contact;
    const parts = (force, ray) =>
      cone
        ? alongPairs(cone, alpha, tangent, force, ray)
        : {
            circumferential: new Vector3(0, force * Math.cos(alpha), 0),
            radial: new Vector3(Math.abs(force) * Math.sin(alpha), 0, 0),
            axial: new Vector3(0, 0, -force * tangent),
          };
    return Array.from({ length: this.pairs }, (_, slot) => {
      const line = lines.find((one) => one.slot === slot && one.force);
      const vectors = parts(line?.force ?? 0, line?.ray ?? 0);
      const values = {};
      for (const [part, vector] of Object.entries(vectors)) {
        values[part] = vector.length();
        vector.transformDirection(frame).setLength(values[part]);
      }
      const total = Math.hypot(...Object.values(values));
      const at = line ? line.centre : new Vector3().setFromMatrixPosition(frame);
      return { state: line ? line.side : 0, vectors, values, at, total };
    });
  }
}

/** Maximum of a table. @param {any} table */
function most(table) {
  let found = 0;
  for (const x of table?.data ?? []) if (x > found) found = x;
  return found;
}

const TURN = new Quaternion();
const POINT = new Vector3();
const ONE = new Vector3(1, 1, 1);
