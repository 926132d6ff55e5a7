// SPDX-License-Identifier: Apache-2.0
// Magnified gap between the flanks of a mesh: two plates per flank side on the line of action. Their distance
// is the gap from the channels times the magnification.
import { BoxGeometry, Matrix4, Mesh, MeshLambertMaterial, Vector3 } from "three";
import { STATES } from "./colours.js";

const AWAY = 0.32; // distance of the plates from the pitch point along the line of action, in base pitches
const SIZE = 0.2; // width of a plate, in base pitches

export class Gauge {
  /**
   * @param {import("./contacts.js").Contact} contact
   * @param {import("three").Group} root group drawn on top of the solids
   */
  constructor(contact, root) {
    this.contact = contact;
    this.root = root;
    this.times = 1;
    /** Created at the first use. */
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

  /** Magnification 1, 2, 5, 10, ... at which the larger gap is at most a quarter of the base pitch. */
  fitting() {
    const both = this.contact.penetration();
    const gap = Math.max(Math.abs(both[1]), Math.abs(both[-1]), 1e-7);
    const wanted = (0.25 * this.contact.contact.base_pitch) / gap;
    const power = 10 ** Math.floor(Math.log10(wanted));
    return Math.max(1, power * (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1));
  }

  /** World positions of the visible plates: both plates of the front flank, then those of the back flank. */
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
      // The plates face each other across the gap; with penetration they overlap or have passed each other.
      const off = -0.5 * this.times * both[side] + 0.5 * thick;
      AXIS.set(0, 0, 1);
      ACROSS.crossVectors(AXIS, normal);
      PLACE.makeBasis(
        ACROSS.clone().multiplyScalar(SIZE * pitch),
        normal.clone().multiplyScalar(thick),
        AXIS.multiplyScalar(SIZE * pitch),
      );
      // Plates of front and back flanks lie on different sides of the pitch point and do not overlap.
      PLACE.setPosition(normal.multiplyScalar(AWAY * pitch + end * off));
      mesh.matrix.multiplyMatrices(frame, PLACE);
    }
  }
}

const AXIS = new Vector3();
const ACROSS = new Vector3();
const PLACE = new Matrix4();
