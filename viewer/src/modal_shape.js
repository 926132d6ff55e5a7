// SPDX-License-Identifier: Apache-2.0
// A solid that deforms in modal coordinates: each of its points moves with a node of its body.
import { lerp, means } from "./frames.js";

export class ModalShape {
  /**
   * @param {any} solid with modal data
   * @param {import("three").BufferGeometry} geometry its points are moved
   * @param {Uint32Array} source index of the point of the solid for each point of the geometry
   * @param {import("./poses.js").Poses} poses
   */
  constructor(solid, geometry, source, poses) {
    this.name = solid.name;
    this.geometry = geometry;
    this.poses = poses;
    const { shapes, node, coordinates } = solid.modal;
    this.shapes = shapes.data;
    this.count = shapes.shape[0];
    this.nodes = shapes.shape[1];
    this.node = Uint32Array.from(source, (point) => node.data[point]);
    this.points = geometry.attributes.position.array.slice();
    this.coordinates = coordinates;
    this.mean = coordinates && means(coordinates);
    this.drawn = new Float64Array(this.count);
    this.moved = new Float64Array(3 * this.nodes);
  }

  /** Current modal coordinates with magnified vibrations. */
  #now() {
    const { mode, magnification: m, where } = this.poses;
    return this.drawn.map((_, k) => {
      if (mode) {
        const table = mode.shape.modal?.[this.name];
        return table ? mode.cosine * table.data[2 * k] + mode.sine * table.data[2 * k + 1] : 0;
      }
      if (!this.coordinates) return 0;
      const x = lerp(this.coordinates, where, k);
      return m === 1 ? x : this.mean[k] + m * (x - this.mean[k]);
    });
  }

  /**
   * Maximum nodal displacement in a mode, real and imaginary parts of all components combined.
   * @param {any} mode
   */
  largest(mode) {
    const table = mode.modal?.[this.name];
    let most = 0;
    for (let node = 0; table && node < this.nodes; node++) {
      let sum = 0;
      for (let i = 0; i < 6; i++) {
        let way = 0;
        for (let k = 0; k < this.count; k++)
          way += table.data[2 * k + (i % 2)] * this.shapes[3 * (this.nodes * k + node) + (i >> 1)];
        sum += way * way;
      }
      most = Math.max(most, Math.sqrt(sum));
    }
    return most;
  }

  /** @returns {boolean} whether the geometry has changed */
  update() {
    const now = this.#now();
    if (now.every((x, k) => x === this.drawn[k])) return false;
    this.drawn = now;
    this.moved.fill(0);
    for (let k = 0; k < this.count; k++) {
      const first = 3 * this.nodes * k;
      for (let i = 0; i < this.moved.length; i++) this.moved[i] += now[k] * this.shapes[first + i];
    }
    const { position } = this.geometry.attributes;
    for (let p = 0; p < this.node.length; p++)
      for (let i = 0; i < 3; i++)
        position.array[3 * p + i] = this.points[3 * p + i] + this.moved[3 * this.node[p] + i];
    position.needsUpdate = true;
    this.geometry.computeBoundingSphere();
    return true;
  }
}
