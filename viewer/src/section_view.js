// SPDX-License-Identifier: Apache-2.0
// A plane that cuts all solids, square to x, y or z or to the axis of a mesh.
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
    this.at = 0;
    /** in the world as the camera sees it, which follows the world */
    this.plane = new Plane();
    const [axis] = Object.entries(AXES).reduce((best, each) =>
      Math.abs(each[1].dot(stage.pictures[0].poses.axis())) >
      Math.abs(best[1].dot(stage.pictures[0].poses.axis()))
        ? each
        : best,
    );
    this.enable = tick("cut the solids (s)", false, (on) => this.turn(on));
    this.axis = choice(
      "square to",
      [...Object.keys(AXES).map((name) => [name, name]), ["mesh", "axis of the mesh"]],
      (name) => this.along(name),
    );
    this.axis.select.lastChild.hidden = true;
    this.place = el("input", {
      type: "range",
      min: "0",
      max: "1000",
      title: "Place of the cut",
      "aria-label": "Place of the cut",
    });
    this.place.addEventListener("input", () => this.#moved());
    this.said = el("output", {});
    this.flip = tick("other half", false, (on) => {
      this.flipped = on;
      this.update();
      changed();
    });
    this.rows = [
      this.enable.row,
      this.axis.row,
      el("label", { className: "ppv-slider" }, el("span", {}, "place"), this.place, this.said),
      this.flip.row,
    ];
    this.along(axis);
  }

  /** Square to an axis of the world, through the middle. @param {string} name */
  along(name) {
    if (name in AXES) this.normal.copy(AXES[name]);
    this.axis.select.value = name;
    const [low, high] = this.#ends();
    this.#set((low + high) / 2);
    this.#face();
  }

  /** Square to any direction, through a point. @param {Vector3} point @param {Vector3} normal */
  through(point, normal) {
    const near = Object.entries(AXES).find(([, axis]) => Math.abs(axis.dot(normal)) > 1 - 1e-9);
    this.normal.copy(normal).normalize();
    if (near) this.normal.copy(near[1]);
    this.axis.select.lastChild.hidden = Boolean(near);
    this.axis.select.value = near ? near[0] : "mesh";
    // what is between the camera and the cut goes
    this.flipped = this.normal.dot(normal) < 0;
    this.flip.input.checked = this.flipped;
    this.#set(this.normal.dot(point));
    this.#cut(true);
  }

  /** Least and largest place of the solids along the normal. */
  #ends() {
    const { low, high } = this.stage.bounds();
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
    const [low, high] = this.#ends();
    this.at = low + (Number(this.place.value) / 1000) * (high - low);
    this.#say();
    this.update();
    this.changed();
  }

  #set(at) {
    const [low, high] = this.#ends();
    this.at = at;
    this.place.value = String((1000 * (at - low)) / (high - low || 1));
    this.#say();
    this.update();
    this.changed();
  }

  /** The place, as finely as the size of the scene makes sense. */
  #say() {
    const text = fixed(1000 * Math.max(...this.#ends().map(Math.abs)))(this.at * 1000);
    this.said.textContent = `${Number(text) === 0 ? "0" : text} mm`;
  }

  /** The half on the camera's side goes, so that the cut looks at the camera. */
  #face() {
    const camera = this.stage.camera.position.clone().applyMatrix4(this.stage.seen.clone().invert());
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
    for (const { solids, flanks } of this.stage.pictures)
      for (const part of [solids, flanks]) part.cut(on ? [this.plane] : []);
    this.update();
    this.changed();
  }

  /** The plane where the camera sees the world. */
  update() {
    // what is kept lies on the side to which the normal of the plane points
    const sign = this.flipped ? 1 : -1;
    this.plane.normal.copy(this.normal).multiplyScalar(sign);
    this.plane.constant = -sign * this.at;
    this.plane.applyMatrix4(this.stage.seen);
  }
}
