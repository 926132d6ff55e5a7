// SPDX-License-Identifier: Apache-2.0
// Poses of all bodies at an instant: kinematics of docs/scene_format.md, in double precision.
import { Matrix4, Quaternion, Vector3 } from "three";
import { between, lerp, means } from "./frames.js";

const X = new Vector3(1, 0, 0);
const Z = new Vector3(0, 0, 1);

/** Quaternion of a rotation vector. @param {Quaternion} out */
export function fromRotationVector(out, x, y, z) {
  const angle = Math.hypot(x, y, z);
  if (angle < 1e-300) return out.identity();
  const s = Math.sin(angle / 2) / angle;
  return out.set(s * x, s * y, s * z, Math.cos(angle / 2));
}

export class Poses {
  /** @param {any} scene result of readScene */
  constructor(scene) {
    this.bodies = scene.bodies;
    /** Bodies with gears or shafts. */
    this.shafts = new Set(
      (scene.solids ?? [])
        .filter(({ kind }) => kind === "gear" || kind === "shaft")
        .map(({ blend, body }) => (blend ? blend.bodies[0] : body)),
    );
    this.times = scene.times?.data ?? new Float64Array([0]);
    this.where = { low: 0, share: 0 };
    this.magnification = 1;
    this.world = this.bodies.map(() => new Matrix4());
    /** Frames fixed to the parent that do not spin with the body; arrows refer to them. */
    this.still = this.bodies.map(() => new Matrix4());
    this.rest = this.bodies.map(() => new Matrix4());
    this.means = this.bodies.map((body) => ({
      position: body.position && means(body.position),
      turn: body.turn && means(body.turn),
      spin: body.spin && means(body.spin),
    }));
    this.bodies.forEach((body, k) => {
      const [x, y, z] = body.place ?? [0, 0, 0];
      const axes = new Quaternion(...(body.axes ?? [0, 0, 0, 1])).normalize();
      body.frame = new Matrix4().compose(new Vector3(x, y, z), axes, new Vector3(1, 1, 1));
      this.rest[k].multiplyMatrices(this.#parent(this.rest, k), body.frame);
    });
    this.at(this.times[0]);
  }

  #parent(list, k) {
    const parent = this.bodies[k].parent ?? -1;
    return parent < 0 ? IDENTITY : list[parent];
  }

  /** Frame of a solid: that of its body, or of the first body of a blended solid. @param {any} solid */
  ofSolid(solid) {
    if (solid.between) return this.#between(solid);
    const body = solid.blend ? solid.blend.bodies[0] : solid.body;
    const frame = body < 0 ? IDENTITY : this.world[body];
    if (!solid.place && !solid.axes) return frame;
    solid.seat ??= new Matrix4().compose(
      new Vector3(...(solid.place ?? [0, 0, 0])),
      new Quaternion(...(solid.axes ?? [0, 0, 0, 1])).normalize(),
      ONE,
    );
    solid.placed ??= new Matrix4();
    return solid.placed.multiplyMatrices(frame, solid.seat);
  }

  /** Frame of a solid stretched between two bodies, with the third axis from end to end. */
  #between(solid) {
    const { bodies, ends } = solid.between;
    const [a, b] = bodies.map((body, k) =>
      new Vector3(...ends[k]).applyMatrix4(body < 0 ? IDENTITY : this.world[body]),
    );
    const along = b.clone().sub(a);
    const length = along.length() || 1e-12;
    const z = along.clone().divideScalar(length);
    // The axis of the first body most perpendicular to the solid keeps it from rotating about its own axis.
    const frame = bodies[0] < 0 ? IDENTITY : this.world[bodies[0]];
    const across = [0, 1, 2]
      .map((k) => new Vector3().setFromMatrixColumn(frame, k))
      .reduce((best, axis) => (Math.abs(axis.dot(z)) < Math.abs(best.dot(z)) - 0.2 ? axis : best));
    const x = across.addScaledVector(z, -across.dot(z)).normalize();
    const y = new Vector3().crossVectors(z, x);
    solid.placed ??= new Matrix4();
    return solid.placed.makeBasis(x, y, along.lengthSq() ? along : z.multiplyScalar(length)).setPosition(a);
  }

  /** Angle prescribed by the kinematics [rad]. */
  #gross({ gross, ratio = 1 }, where) {
    return gross ? ratio * lerp(gross, where) : 0;
  }

  /**
   * Angle of a body about its third axis, including whole turns [rad].
   * @param {number} k
   * @param {{low: number, share: number}} where
   */
  angle(k, where = this.where) {
    const { spin } = this.bodies[k];
    return this.#gross(this.bodies[k], where) + (spin ? lerp(spin, where) : 0);
  }

  /** @param {number} t */
  at(t) {
    this.mode = null;
    this.where = between(this.times, t);
    const { where, magnification: m } = this;
    // Deviations from the mean are magnified.
    const large = (table, mean, column) => {
      const x = lerp(table, where, column);
      return m === 1 ? x : mean[column] + m * (x - mean[column]);
    };
    this.bodies.forEach((body, k) => {
      this.still[k].multiplyMatrices(this.#parent(this.world, k), body.frame);
      SHIFT.set(0, 0, 0);
      const mean = this.means[k];
      if (body.position)
        SHIFT.set(
          large(body.position, mean.position, 0),
          large(body.position, mean.position, 1),
          large(body.position, mean.position, 2),
        );
      if (body.travel)
        SHIFT.set(
          SHIFT.x + lerp(body.travel, where, 0),
          SHIFT.y + lerp(body.travel, where, 1),
          SHIFT.z + lerp(body.travel, where, 2),
        );
      if (body.quaternion) {
        ROTATION.set(
          ...[0, 1, 2, 3].map(
            (c) => body.quaternion.data[c + (body.quaternion.count > 1 ? 4 * where.low : 0)],
          ),
        );
        if (body.quaternion.count > 1 && where.share) {
          NEXT.set(...[4, 5, 6, 7].map((c) => body.quaternion.data[c + 4 * where.low]));
          ROTATION.slerp(NEXT, where.share);
        }
        ROTATION.normalize();
      } else {
        ROTATION.identity();
        if (body.turn)
          fromRotationVector(
            ROTATION,
            large(body.turn, mean.turn, 0),
            large(body.turn, mean.turn, 1),
            large(body.turn, mean.turn, 2),
          );
      }
      const angle = this.#gross(body, where) + (body.spin ? large(body.spin, mean.spin, 0) : 0);
      if (angle) ROTATION.multiply(NEXT.setFromAxisAngle(Z, angle));
      LOCAL.compose(SHIFT, ROTATION, ONE);
      this.world[k].multiplyMatrices(this.still[k], LOCAL);
    });
    return this;
  }

  /**
   * Poses at rest, displaced by a mode at a given phase.
   * @param {any} mode
   * @param {number} phase [rad]
   * @param {number} amplitude
   */
  ofMode(mode, phase, amplitude) {
    const c = amplitude * Math.cos(phase),
      s = -amplitude * Math.sin(phase);
    this.mode = { shape: mode, cosine: c, sine: s };
    const part = (table, k, column) =>
      table ? c * table.data[6 * k + column] + s * table.data[6 * k + 3 + column] : 0;
    this.bodies.forEach((_, k) => {
      fromRotationVector(ROTATION, part(mode.turn, k, 0), part(mode.turn, k, 1), part(mode.turn, k, 2));
      const rest = this.rest[k];
      LOCAL.makeRotationFromQuaternion(ROTATION);
      this.world[k].multiplyMatrices(LOCAL, rest);
      const e = this.world[k].elements;
      for (let i = 0; i < 3; i++) e[12 + i] = rest.elements[12 + i] + part(mode.position, k, i);
      this.still[k].copy(this.world[k]);
    });
    return this;
  }

  /** Mean direction of the axes of rotation, in the world. */
  axis() {
    const sum = new Vector3();
    // Oscillating links are used only if no body rotates continuously.
    const round = this.bodies.some((body) => body.gross);
    const moves = round || this.bodies.some((body) => body.spin);
    this.bodies.forEach((body, k) => {
      // At rest, gears and shafts show the axes.
      if (moves ? !body.gross && (round || !body.spin) : !this.shafts.has(k)) return;
      const z = new Vector3().setFromMatrixColumn(this.rest[k], 2);
      sum.addScaledVector(z, sum.dot(z) < 0 ? -1 : 1);
    });
    return sum.length() > 1e-9 ? sum.normalize() : Z.clone();
  }
}

const IDENTITY = new Matrix4();
const LOCAL = new Matrix4();
const SHIFT = new Vector3();
const ONE = new Vector3(1, 1, 1);
const ROTATION = new Quaternion();
const NEXT = new Quaternion();
export { X, Z };
