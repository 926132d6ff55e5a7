// SPDX-License-Identifier: Apache-2.0
// Section plane through all solids, normal to x, y, z or the axis of a mesh.
import { Plane, Vector3 } from "three";
import { choice, el, tick } from "./dom.js";
import { fixed } from "./numbers.js";

const AXES = { x: new Vector3(1, 0, 0), y: new Vector3(0, 1, 0), z: new Vector3(0, 0, 1) };

export class SectionView {
  /** @param {import("./stage.js").Stage} stage @param {() => void} changed */
  constructor(stage, changed) {
    this.stage = stage;
    this.changed = changed;
    this.on = false;
    this.normal = new Vector3(0, 0, 1);
    this.flipped = false;
    /** Position along the normal in each viewport. */
    this.places = stage.pictures.map(() => 0);
    /** Section planes in the camera's world, which moves with a followed body. */
    this.planes = stage.pictures.map(() => new Plane());
    const [axis] = Object.entries(AXES).reduce((best, each) =>
      Math.abs(each[1].dot(stage.pictures[0].poses.axis())) >
      Math.abs(best[1].dot(stage.pictures[0].poses.axis()))
        ? each
        : best,
    );
    this.enable = tick("section (s)", false, (on) => this.turn(on));
    this.axis = choice(
      "normal to",
      [...Object.keys(AXES).map((name) => [name, name]), ["mesh", "axis of the mesh"]],
      (name) => this.along(name),
    );
    this.axis.select.lastChild.hidden = true;
    this.place = el("input", {
      type: "range",
      min: "0",
      max: "1000",
      title: "Position of the section plane",
      "aria-label": "Position of the section plane",
    });
    this.place.addEventListener("input", () => this.#moved());
    this.output = el("output", {});
    this.flip = tick("flip side", false, (on) => {
      this.flipped = on;
      this.update();
      changed();
    });
    this.rows = [
      this.enable.row,
      this.axis.row,
      el("label", { className: "ppv-slider" }, el("span", {}, "position"), this.place, this.output),
      this.flip.row,
    ];
    this.along(axis);
  }

  /** Section normal to a world axis, through the centre. @param {string} name */
  along(name) {
    if (name in AXES) this.normal.copy(AXES[name]);
    this.axis.select.value = name;
    this.#share(0.5);
    this.#face();
  }

  get at() {
    return this.places[0];
  }

  /**
   * Section with a given normal through a point of each viewport. Viewports without a point use the same
   * relative position.
   * @param {(Vector3|null)[]} points
   * @param {Vector3} normal
   */
  through(points, normal) {
    const near = Object.entries(AXES).find(([, axis]) => Math.abs(axis.dot(normal)) > 1 - 1e-9);
    this.normal.copy(normal).normalize();
    if (near) this.normal.copy(near[1]);
    this.axis.select.lastChild.hidden = Boolean(near);
    this.axis.select.value = near ? near[0] : "mesh";
    // The half between the camera and the section is removed.
    this.flipped = this.normal.dot(normal) < 0;
    this.flip.input.checked = this.flipped;
    const known = points.findIndex(Boolean);
    const [low, high] = this.#ends(known);
    this.#share((this.normal.dot(points[known]) - low) / (high - low || 1));
    points.forEach((point, k) => point && (this.places[k] = this.normal.dot(point)));
    this.#showPlace();
    this.#cut(true);
  }

  /** Range of positions of the solids along the normal. @param {number} [picture] */
  #ends(picture = 0) {
    const { alike, pictures } = this.stage;
    const { low, high } = alike ? this.stage.bounds() : pictures[picture].bounds;
    let least = Infinity,
      most = -Infinity;
    for (let k = 0; k < 8; k++) {
      const corner = new Vector3(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z).dot(
        this.normal,
      );
      least = Math.min(least, corner);
      most = Math.max(most, corner);
    }
    return [least, most];
  }

  #moved() {
    this.#share(Number(this.place.value) / 1000);
  }

  /** Set the same relative position in all viewports. @param {number} share */
  #share(share) {
    this.places = this.places.map((_, k) => {
      const [low, high] = this.#ends(k);
      return low + share * (high - low);
    });
    this.place.value = String(1000 * share);
    this.#showPlace();
    this.update();
    this.changed();
  }

  /** Show the position with a resolution suited to the size of the scene. */
  #showPlace() {
    const text = fixed(1000 * Math.max(...this.#ends().map(Math.abs)))(this.at * 1000);
    this.output.textContent = `${Number(text) === 0 ? "0" : text} mm`;
  }

  /** Remove the half on the camera side, so that the section faces the camera. */
  #face() {
    const camera = this.stage.camera.position.clone().applyMatrix4(this.stage.pictures[0].seen.clone().invert());
    this.flipped = this.normal.dot(camera) < this.at;
    this.flip.input.checked = this.flipped;
    this.update();
  }

  /** @param {boolean} on */
  turn(on) {
    if (on) this.#face();
    this.#cut(on);
  }

  /** @param {boolean} on */
  #cut(on) {
    this.on = on;
    this.enable.input.checked = on;
    this.stage.pictures.forEach(({ solids, flanks }, k) => {
      for (const part of [solids, flanks]) part.cut(on ? [this.planes[k]] : []);
    });
    this.update();
    this.changed();
  }

  /** Transform the planes to the camera's world. */
  update() {
    // Clipping keeps the half-space towards which the normal of a plane points.
    const sign = this.flipped ? 1 : -1;
    this.planes.forEach((plane, k) => {
      plane.normal.copy(this.normal).multiplyScalar(sign);
      plane.constant = -sign * this.places[k];
      plane.applyMatrix4(this.stage.pictures[k].seen);
    });
  }
}
