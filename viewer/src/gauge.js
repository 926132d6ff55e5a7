// SPDX-License-Identifier: Apache-2.0
// The gap of both flanks of a mesh, magnified along the lines of action: two plates a flank, as far apart as the
// channels give, times a factor.
import { BoxGeometry, Matrix4, Mesh, MeshLambertMaterial, Vector3 } from "three";
import { STATES } from "./colours.js";

const AWAY = 0.32; // place of a gauge on its line of action, in base pitches from the pitch point
const SIZE = 0.2; // of a plate

export class Gauge {
  /** @param {import("./contacts.js").Contact} contact @param {import("three").Group} root of what is drawn over the solids */
  constructor(contact, root) {
    this.contact = contact;
    this.root = root;
    this.times = 1;
    /** made when they are first requested */
    this.plates = null;
  }

  #make() {
    const box = new BoxGeometry(1, 1, 1);
    this.plates = [1, -1].flatMap((side) =>
      [-1, 1].map((end) => {
        const { colour } = STATES[side];
        const lit = { color: colour, emissive: colour, emissiveIntensity: end > 0 ? 0.5 : 0.15 };
        const mesh = new Mesh(box, new MeshLambertMaterial({ ...lit, transparent: true, opacity: 0.85 }));
        mesh.matrixAutoUpdate = false;
        this.root.add(mesh);
        return { mesh, side, end };
      }),
    );
  }

  /** A factor at which the backlash is a quarter of a base pitch: 1, 2, 5, 10, ... */
  fitting() {
    const both = this.contact.penetration();
    const gap = Math.max(Math.abs(both[1]), Math.abs(both[-1]), 1e-7);
    const wanted = (0.25 * this.contact.contact.base_pitch) / gap;
    const power = 10 ** Math.floor(Math.log10(wanted));
    return Math.max(1, power * (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1));
  }

  /** Places of the plates in the world: front flank before and behind its gap, back flank likewise. */
  shown() {
    return (this.plates ?? [])
      .filter(({ mesh }) => mesh.visible)
      .map(({ mesh }) => new Vector3().setFromMatrixPosition(mesh.matrix).toArray());
  }

  /** @param {boolean} on */
  update(on) {
    if (!on && !this.plates) return;
    if (!this.plates) this.#make();
    const { contact } = this;
    const pitch = contact.contact.base_pitch;
    const frame = contact.frame();
    const both = contact.penetration();
    for (const { mesh, side, end } of this.plates) {
      mesh.visible = on;
      if (!on) continue;
      const normal = contact.normal(side);
      const thick = 0.03 * pitch;
      // plates face each other across the gap; flanks that overlap show plates that have passed each other
      const off = -0.5 * this.times * both[side] + 0.5 * thick;
      AXIS.set(0, 0, 1);
      ACROSS.crossVectors(AXIS, normal);
      PLACE.makeBasis(
        ACROSS.clone().multiplyScalar(SIZE * pitch),
        normal.clone().multiplyScalar(thick),
        AXIS.multiplyScalar(SIZE * pitch),
      );
      // front flanks touch beyond the pitch point in their sense, back flanks in theirs: the gauges stay apart
      PLACE.setPosition(normal.multiplyScalar(AWAY * pitch + end * off));
      mesh.matrix.multiplyMatrices(frame, PLACE);
    }
  }
}

const AXIS = new Vector3();
const ACROSS = new Vector3();
const PLACE = new Matrix4();
