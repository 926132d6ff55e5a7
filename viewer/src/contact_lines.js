// SPDX-License-Identifier: Apache-2.0
// Contact lines as thin rods, coloured by load; spheres at their ends distinguish front and back flanks.
import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  Vector3,
} from "three";
import { STATES } from "./colours.js";
import { litColour } from "./load_colours.js";

const AROUND = 6; // vertices around a rod
const MOST = 24; // maximum number of lines drawn per mesh

export class ContactLines {
  /**
   * @param {import("./contacts.js").Contact} contact
   * @param {import("three").Group} root group drawn on top of the solids
   */
  constructor(contact, root) {
    this.contact = contact;
    this.stations = contact.contact.flanks[0].loads?.shape[2] ?? 2;
    const corners = MOST * this.stations * AROUND;
    const geometry = new BufferGeometry();
    for (const name of ["position", "color"])
      geometry.setAttribute(
        name,
        new BufferAttribute(new Float32Array(3 * corners), 3).setUsage(DynamicDrawUsage),
      );
    const index = [];
    for (let line = 0; line < MOST; line++)
      for (let s = 0; s < this.stations - 1; s++)
        for (let k = 0; k < AROUND; k++) {
          const a = (line * this.stations + s) * AROUND + k,
            b = (line * this.stations + s) * AROUND + ((k + 1) % AROUND);
          index.push(a, b, a + AROUND, b, b + AROUND, a + AROUND);
        }
    geometry.setIndex(index);
    this.rods = new Mesh(geometry, new MeshBasicMaterial({ vertexColors: true }));
    this.rods.frustumCulled = false;
    root.add(this.rods);
    const ball = new SphereGeometry(1, 12, 8);
    this.paints = Object.fromEntries(
      [1, -1].map((side) => [side, new MeshBasicMaterial({ color: STATES[side].colour })]),
    );
    this.plain = Object.fromEntries([1, -1].map((side) => [side, this.paints[side].color.toArray()]));
    this.balls = Array.from({ length: 2 * MOST }, () => {
      const mesh = new Mesh(ball, this.paints[1]);
      mesh.visible = false;
      root.add(mesh);
      return mesh;
    });
  }

  /**
   * @param {import("./contacts.js").Line[]} lines
   * @param {boolean} on
   * @param {number} visible size of a pixel in the scene [m]
   * @param {number} greatest upper end of the colour scale
   * @param {any} shade quantity shown by the colours
   */
  update(lines, on, visible, greatest, shade) {
    // Unloaded lines are shown only on the side with the smaller gap.
    const both = this.contact.penetration();
    const nearer = both[1] >= both[-1] ? 1 : -1;
    const drawn = on ? lines.filter((line) => line.force || line.side === nearer).slice(0, MOST) : [];
    this.rods.visible = drawn.length > 0;
    this.balls.forEach((ball) => (ball.visible = false));
    const { position, color } = this.rods.geometry.attributes;
    const loaded = Boolean(this.contact.contact.flanks[0].loads);
    const thick = Math.min(2.6 * visible || Infinity, 0.07 * this.contact.contact.base_pitch);
    drawn.forEach((line, n) => {
      // A mesh law without tooth pairs gives the flank in contact, but not the load of each pair.
      const carries = loaded ? line.force !== 0 : both[line.side] > 0;
      const radius = carries ? thick : 0.4 * thick;
      ALONG.subVectors(line.to, line.from);
      ACROSS.set(0, 0, 1).cross(ALONG);
      if (ACROSS.lengthSq() < 1e-12 * ALONG.lengthSq()) ACROSS.set(1, 0, 0).cross(ALONG);
      ACROSS.normalize();
      THIRD.crossVectors(ALONG, ACROSS).normalize();
      for (let s = 0; s < this.stations; s++) {
        const load = loaded && greatest > 0 ? litColour(shade(line, s) / greatest) : this.plain[line.side];
        const colour = carries ? load : NONE;
        POINT.copy(line.at(s / (this.stations - 1)));
        for (let k = 0; k < AROUND; k++) {
          const angle = (2 * Math.PI * k) / AROUND;
          const at = (n * this.stations + s) * AROUND + k;
          position.setXYZ(
            at,
            POINT.x + radius * (Math.cos(angle) * ACROSS.x + Math.sin(angle) * THIRD.x),
            POINT.y + radius * (Math.cos(angle) * ACROSS.y + Math.sin(angle) * THIRD.y),
            POINT.z + radius * (Math.cos(angle) * ACROSS.z + Math.sin(angle) * THIRD.z),
          );
          color.setXYZ(at, ...colour);
        }
      }
      if (!carries) return;
      for (const [k, point] of [line.from, line.to].entries()) {
        const ball = this.balls[2 * n + k];
        ball.visible = true;
        ball.material = this.paints[line.side];
        ball.position.copy(point);
        ball.scale.setScalar(1.9 * thick);
      }
    });
    position.needsUpdate = color.needsUpdate = true;
    this.rods.geometry.setDrawRange(0, drawn.length * (this.stations - 1) * AROUND * 6);
  }
}

const ALONG = new Vector3();
const ACROSS = new Vector3();
const THIRD = new Vector3();
const POINT = new Vector3();
const NONE = [0.29, 0.31, 0.36];
