// SPDX-License-Identifier: Apache-2.0
// A solid that deforms with several bodies: each point is interpolated between two of them.
import { Matrix4 } from "three";

const GROUND = new Matrix4();
const of = (frames, body) => (body < 0 ? GROUND : frames[body]);

export class Blend {
  /**
   * @param {{bodies: number[], first?: any, second: any, weight: any}} blend
   * @param {import("three").BufferGeometry} geometry its points are moved
   * @param {Uint32Array} source index of the point of the solid for each point of the geometry
   * @param {import("./poses.js").Poses} poses
   */
  constructor(blend, geometry, source, poses) {
    this.blend = blend;
    this.geometry = geometry;
    this.source = source;
    this.poses = poses;
    this.points = geometry.attributes.position.array.slice();
    this.normals = geometry.attributes.normal.array.slice();
    // Transformations at rest from the frame of the first body to that of each body.
    const first = of(poses.rest, blend.bodies[0]);
    this.toBody = blend.bodies.map((body) => of(poses.rest, body).clone().invert().multiply(first));
    this.moved = blend.bodies.map(() => new Matrix4());
    this.drawn = blend.bodies.map(() => new Matrix4());
  }

  /**
   * @param {number} visible smaller displacements are not drawn [m]
   * @param {number} reach maximum distance of a point from the origin [m]
   * @returns {boolean} whether the geometry has changed
   */
  update(visible, reach) {
    const { blend, poses, moved, drawn } = this;
    const inverse = of(poses.world, blend.bodies[0]).clone().invert();
    let change = 0;
    moved.forEach((matrix, k) => {
      matrix.multiplyMatrices(inverse, of(poses.world, blend.bodies[k])).multiply(this.toBody[k]);
      for (let i = 0; i < 16; i++) {
        change = Math.max(change, Math.abs(matrix.elements[i] - drawn[k].elements[i]) * (i < 12 ? reach : 1));
      }
    });
    // Most shafts deflect by less than a pixel; their data are not uploaded again.
    if (change <= visible) return false;
    moved.forEach((matrix, k) => drawn[k].copy(matrix));
    const { position, normal } = this.geometry.attributes;
    const { first, second, weight } = blend;
    for (let k = 0; k < this.source.length; k++) {
      const p = this.source[k];
      const b = second.data[p];
      const w = weight.data[p];
      const m = drawn[first ? first.data[p] : 0].elements;
      const n = drawn[b].elements;
      const x = this.points[3 * k],
        y = this.points[3 * k + 1],
        z = this.points[3 * k + 2];
      const u = this.normals[3 * k],
        v = this.normals[3 * k + 1],
        s = this.normals[3 * k + 2];
      for (let i = 0; i < 3; i++) {
        const r0 = m[i] + w * (n[i] - m[i]),
          r1 = m[4 + i] + w * (n[4 + i] - m[4 + i]),
          r2 = m[8 + i] + w * (n[8 + i] - m[8 + i]);
        position.array[3 * k + i] = r0 * x + r1 * y + r2 * z + m[12 + i] + w * (n[12 + i] - m[12 + i]);
        normal.array[3 * k + i] = r0 * u + r1 * v + r2 * s;
      }
    }
    position.needsUpdate = normal.needsUpdate = true;
    this.geometry.computeBoundingSphere();
    return true;
  }
}
