// SPDX-License-Identifier: Apache-2.0
// Section plane through all solids, normal to x, y, z, the axis of a mesh or any other direction.
import { Plane, Vector3 } from "three";
import { button, choice, el, tick } from "./dom.js";
import { fixed } from "./numbers.js";

const SMALL = 2e-6;
const AXES = { x: new Vector3(1, 0, 0), y: new Vector3(0, 1, 0), z: new Vector3(0, 0, 1) };

export class SectionView {
  /** @param {import("./stage.js").Stage} stage @param {() => void} changed */
  constructor(stage, changed) {
    this.stage = stage;
    this.changed = changed;
    this.on = false;
    this.normal = new Vector3(0, 0, 1);
    /** Direction from which turn and tilt count. */
    this.base = new Vector3(0, 0, 1);
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
      [...Object.keys(AXES).map((name) => [name, name]), ["mesh", "axis of the mesh"], ["free", "other"]],
      (name) => this.along(name),
    );
    for (const name of ["mesh", "free"]) this.#option(name).hidden = true;
    this.place = el("input", {
      type: "range",
      min: "0",
      max: "1000",
      title: "Position of the section plane",
      "aria-label": "Position of the section plane",
    });
    this.place.addEventListener("input", () => this.#moved());
    this.output = el("output", {});
    this.angles = Object.fromEntries(
      ["turn", "tilt"].map((word) => {
        const input = el("input", {
          type: "range",
          min: "-90",
          max: "90",
          value: "0",
          title: `${word[0].toUpperCase()}${word.slice(1)} of the section plane`,
          "aria-label": `${word[0].toUpperCase()}${word.slice(1)} of the section plane`,
        });
        input.addEventListener("input", () => this.#turned());
        return [word, { input, output: el("output", {}) }];
      }),
    );
    this.flip = tick("flip side", false, (on) => {
      this.flipped = on;
      this.update();
      changed();
    });
    this.rows = [
      this.enable.row,
      this.axis.row,
      el("label", { className: "ppv-slider" }, el("span", {}, "position"), this.place, this.output),
      ...Object.entries(this.angles).map(([word, { input, output }]) =>
        el("label", { className: "ppv-slider" }, el("span", {}, word), input, output),
      ),
      el(
        "div",
        { className: "ppv-buttons" },
        button("parallel to the screen", "Section plane parallel to the screen (S)", () => this.facing()),
      ),
      this.flip.row,
    ];
    stage.section = this;
    this.along(axis);
  }

  /** Section normal to a world axis, through the middle. @param {string} name */
  along(name) {
    if (name in AXES) this.#direct(AXES[name], name);
    this.#share(this.#middle());
    this.#face();
  }

  /** Middle as a share of the range; of planes along the shafts, the axis of rotation that is next to it. */
  #middle() {
    const [{ poses, data }] = this.stage.pictures;
    const [low, high] = this.#ends();
    if (Math.abs(this.normal.dot(poses.axis())) > 0.1 || !(high > low)) return 0.5;
    const still = !data.bodies.some(({ gross }) => gross);
    const shares = data.bodies
      .map((body, k) => (this.normal.dot(new Vector3().setFromMatrixPosition(poses.rest[k])) - low) / (high - low))
      .filter((_, k) => !data.bodies[k].part && (data.bodies[k].gross || still))
      .filter((share) => share > 0.05 && share < 0.95);
    return shares.reduce((best, share) => (Math.abs(share - 0.5) < Math.abs(best - 0.5) ? share : best), shares[0] ?? 0.5);
  }

  /** Section parallel to the screen through the target of the camera. */
  facing() {
    const { camera, pictures } = this.stage;
    const world = pictures[0].seen.clone().invert();
    const toward = new Vector3(0, 0, 1).applyQuaternion(camera.quaternion);
    const normal = toward.clone().transformDirection(world);
    this.#direct(normal, "free");
    const target = camera.position.clone().addScaledVector(toward, -camera.distance).applyMatrix4(world);
    const [low, high] = this.#ends();
    this.#share(Math.max(0, Math.min(1, (normal.dot(target) - low) / (high - low || 1))));
    this.#face();
    this.#cut(true);
  }

  #option(name) {
    return [...this.axis.select.options].find(({ value }) => value === name);
  }

  /** Set the normal; turn and tilt then count from it. @param {Vector3} normal @param {string} name */
  #direct(normal, name) {
    this.normal.copy(normal).normalize();
    this.base.copy(this.normal);
    this.#named(name);
    for (const { input } of Object.values(this.angles)) input.value = "0";
    this.#showAngles();
  }

  #named(name) {
    for (const other of ["mesh", "free"]) this.#option(other).hidden = other !== name;
    this.axis.select.value = name;
  }

  #showAngles() {
    for (const { input, output } of Object.values(this.angles))
      output.textContent = `${input.value.replace("-", "\u2212")}°`;
  }

  /** Rotate the plane about its middle: turn about the vertical on the screen, tilt about the horizontal. */
  #turned() {
    const [turn, tilt] = ["turn", "tilt"].map((word) => (Number(this.angles[word].input.value) * Math.PI) / 180);
    const up = Math.abs(this.base.y) < 0.9 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
    up.addScaledVector(this.base, -up.dot(this.base)).normalize();
    const side = new Vector3().crossVectors(up, this.base);
    const before = this.normal.clone();
    this.normal.copy(this.base).applyAxisAngle(side, tilt).applyAxisAngle(up, turn);
    this.places = this.places.map((at, k) => {
      const { pictures, alike } = this.stage;
      const { low, high } = alike ? this.stage.bounds() : pictures[k].bounds;
      const middle = low.clone().add(high).multiplyScalar(0.5);
      return this.normal.dot(middle.addScaledVector(before, at - before.dot(middle)));
    });
    if (turn || tilt) this.#named("free");
    const [low, high] = this.#ends();
    this.place.value = String((1000 * (this.at - low)) / (high - low || 1));
    this.#showAngles();
    this.#showPlace();
    this.update();
    this.changed();
  }

  /** Move the plane by a share of its range. @param {number} share */
  move(share) {
    this.#share(Math.max(0, Math.min(1, Number(this.place.value) / 1000 + share)));
  }

  /**
   * Section by name or by its normal, at a position along it.
   * @param {string|number[]} normal x, y, z, axis, or components
   * @param {number} [at] [m]
   */
  set(normal, at) {
    const axis = this.stage.pictures[0].poses.axis();
    const wanted = Array.isArray(normal) ? new Vector3(...normal) : (AXES[normal] ?? axis);
    const near = Object.entries(AXES).find(([, each]) => each.dot(wanted) > 1 - 1e-9);
    this.#direct(wanted, near ? near[0] : "free");
    const [low, high] = this.#ends();
    this.#share(at === undefined ? this.#middle() : (at - low) / (high - low || 1));
    this.#face();
    this.#cut(true);
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
    this.#direct(near ? near[1] : normal, near ? near[0] : "mesh");
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
    const { camera, pictures } = this.stage;
    this.face(new Vector3(0, 0, 1).applyQuaternion(camera.quaternion), camera.position, pictures[0].seen);
  }

  /**
   * Remove the half towards a direction; edge-on, the half of a point.
   * @param {Vector3} toward the camera
   * @param {Vector3} [point] in the camera's world
   * @param {import("three").Matrix4} [seen]
   */
  face(toward, point, seen = this.stage.pictures[0].seen) {
    const world = seen.clone().invert();
    const side = this.normal.dot(toward.clone().transformDirection(world));
    if (Math.abs(side) > 1e-3) this.flipped = side < 0;
    else if (point) this.flipped = this.normal.dot(point.clone().applyMatrix4(world)) < this.at;
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

  /** Whether a point is in the half that the section has removed. @param {Vector3} point @param {number} picture */
  removes(point, picture) {
    const above = this.normal.dot(point) - this.places[picture];
    return (this.flipped ? -above : above) > 1e-3 * this.stage.pictures[picture].bounds.whole.radius;
  }

  /** Transform the planes to the camera's world. */
  update() {
    // Clipping keeps the half-space towards which the normal of a plane points.
    const sign = this.flipped ? 1 : -1;
    this.planes.forEach((plane, k) => {
      plane.normal.copy(this.normal).multiplyScalar(sign);
      // Faces of solids in the plane are slightly in front of it, so that they do not flicker.
      plane.constant = -sign * this.places[k] - SMALL * this.stage.pictures[k].bounds.whole.radius;
      plane.applyMatrix4(this.stage.pictures[k].seen);
    });
  }
}
