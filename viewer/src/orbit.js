// SPDX-License-Identifier: Apache-2.0
// Orbit, pan and zoom with mouse, pen and touch, with easing. The controls of three.js do not resolve steps
// below a millimetre, whereas meshes are inspected at the scale of micrometres.
import { Matrix4, Quaternion, Vector3 } from "three";

const EASE = 0.07; // time constant [s]
const STEEPEST = Math.PI / 2 - 1e-3;

export class Orbit {
  /**
   * @param {import("three").PerspectiveCamera} camera
   * @param {HTMLElement} element @param {() => void} changed
   * @param {number[]} up
   */
  constructor(camera, element, changed, up) {
    this.camera = camera;
    this.element = element;
    this.changed = changed;
    this.up = new Vector3(...up).normalize();
    // Azimuth and elevation refer to a frame whose y axis points up.
    this.basis = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), this.up);
    this.now = { target: new Vector3(), azimuth: 0.6, elevation: 0.4, distance: 1 };
    this.goal = { target: new Vector3(), azimuth: 0.6, elevation: 0.4, distance: 1 };
    this.nearest = 1e-6;
    this.farthest = 1e6;
    /** Whether the user has set the view; resizing then no longer fits it to the scene. */
    this.chosen = false;
    /** Whether the scene handles an event of the mouse wheel. @type {(event: WheelEvent) => boolean} */
    this.takesWheel = () => true;
    /** Offset of the target to the left of the centre, as a fraction of the width. */
    this.shift = 0;
    /** Offset of the target below the centre, as a fraction of the height. */
    this.drop = 0;
    this.pointers = new Map();
    element.addEventListener("pointerdown", (event) => this.#down(event));
    element.addEventListener("pointermove", (event) => this.#move(event));
    for (const name of ["pointerup", "pointercancel"])
      element.addEventListener(name, (event) => this.#release(event));
    element.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    element.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  /** Size of a pixel at the target [m]. */
  get pixel() {
    return (
      (2 * this.now.distance * Math.tan((this.camera.fov * Math.PI) / 360)) /
      Math.max(this.element.clientHeight, 1)
    );
  }

  /** Direction from the target to the camera. */
  direction(state = this.now) {
    const c = Math.cos(state.elevation);
    return new Vector3(
      c * Math.sin(state.azimuth),
      Math.sin(state.elevation),
      c * Math.cos(state.azimuth),
    ).applyQuaternion(this.basis);
  }

  /**
   * @param {{target?: Vector3, direction?: Vector3, distance?: number}} view
   * @param {boolean} atOnce without easing
   */
  look({ target, direction, distance }, atOnce = false) {
    this.chosen = true;
    if (target) this.goal.target.copy(target);
    if (distance) this.goal.distance = this.#clamped(distance);
    if (direction) {
      const d = direction.clone().normalize().applyQuaternion(this.basis.clone().invert());
      this.goal.elevation = Math.max(
        -STEEPEST,
        Math.min(STEEPEST, Math.asin(Math.max(-1, Math.min(1, d.y)))),
      );
      // For a vertical view the azimuth is undefined; the current one is kept.
      if (Math.hypot(d.x, d.z) > 1e-6) {
        const azimuth = Math.atan2(d.x, d.z);
        this.goal.azimuth = azimuth + 2 * Math.PI * Math.round((this.now.azimuth - azimuth) / (2 * Math.PI));
      }
    }
    if (atOnce) this.settle();
    this.changed();
  }

  settle() {
    this.now.target.copy(this.goal.target);
    for (const key of ["azimuth", "elevation", "distance"]) this.now[key] = this.goal[key];
    this.#place();
  }

  /** One step of easing. @param {number} dt [s] @returns {boolean} whether the camera is still moving */
  step(dt) {
    const share = 1 - Math.exp(-dt / EASE);
    const { now, goal } = this;
    const left =
      now.target.distanceTo(goal.target) / now.distance +
      Math.abs(now.azimuth - goal.azimuth) +
      Math.abs(now.elevation - goal.elevation) +
      Math.abs(Math.log(now.distance / goal.distance));
    if (left < 1e-4) {
      if (left) this.settle();
      return false;
    }
    now.target.lerp(goal.target, share);
    now.azimuth += share * (goal.azimuth - now.azimuth);
    now.elevation += share * (goal.elevation - now.elevation);
    now.distance *= (goal.distance / now.distance) ** share;
    this.#place();
    return true;
  }

  #place() {
    const { camera, now } = this;
    camera.position.copy(now.target).addScaledVector(this.direction(), now.distance);
    // camera.lookAt loses precision when the camera is micrometres from its target.
    MATRIX.lookAt(this.direction(), ORIGIN, this.up);
    camera.quaternion.setFromRotationMatrix(MATRIX);
    camera.updateMatrixWorld(true);
  }

  #clamped(distance) {
    return Math.max(this.nearest, Math.min(this.farthest, distance));
  }

  #down(event) {
    if (event.button > 2) return;
    this.element.setPointerCapture?.(event.pointerId);
    this.pointers.set(event.pointerId, {
      x: event.clientX,
      y: event.clientY,
      pan: event.button !== 0 || event.shiftKey || event.ctrlKey,
    });
  }

  #release(event) {
    this.pointers.delete(event.pointerId);
  }

  get dragging() {
    return this.pointers.size > 0;
  }

  #move(event) {
    const last = this.pointers.get(event.pointerId);
    if (!last) return;
    const others = [...this.pointers.entries()].filter(([id]) => id !== event.pointerId).map(([, p]) => p);
    const dx = event.clientX - last.x,
      dy = event.clientY - last.y;
    if (others.length) {
      const [o] = others;
      const before = Math.hypot(last.x - o.x, last.y - o.y),
        after = Math.hypot(event.clientX - o.x, event.clientY - o.y);
      if (before > 0 && after > 0)
        this.zoom(before / after, (event.clientX + o.x) / 2, (event.clientY + o.y) / 2);
      this.pan(dx / 2, dy / 2);
    } else if (last.pan) this.pan(dx, dy);
    else this.turn(dx, dy);
    last.x = event.clientX;
    last.y = event.clientY;
  }

  turn(dx, dy) {
    this.chosen = true;
    const each = (1.1 * Math.PI) / Math.max(this.element.clientHeight, 1);
    this.goal.azimuth -= each * dx;
    this.goal.elevation = Math.max(-STEEPEST, Math.min(STEEPEST, this.goal.elevation + each * dy));
    this.changed();
  }

  pan(dx, dy) {
    this.chosen = true;
    const pixel = this.pixel;
    this.goal.target.addScaledVector(RIGHT.set(1, 0, 0).applyQuaternion(this.camera.quaternion), -dx * pixel);
    this.goal.target.addScaledVector(RIGHT.set(0, 1, 0).applyQuaternion(this.camera.quaternion), dy * pixel);
    this.changed();
  }

  /**
   * @param {number} factor applied to the distance
   * @param {number} [x] pointer position whose scene point stays in place
   * @param {number} [y]
   */
  zoom(factor, x, y) {
    this.chosen = true;
    const before = this.goal.distance;
    this.goal.distance = this.#clamped(before * factor);
    if (x !== undefined) {
      const box = this.element.getBoundingClientRect();
      const share = ((this.pixel * before) / this.now.distance) * (1 - this.goal.distance / before);
      this.goal.target.addScaledVector(
        RIGHT.set(1, 0, 0).applyQuaternion(this.camera.quaternion),
        (x - box.left - this.middle(x - box.left)) * share,
      );
      this.goal.target.addScaledVector(
        RIGHT.set(0, 1, 0).applyQuaternion(this.camera.quaternion),
        ((0.5 + this.drop) * box.height - (y - box.top)) * share,
      );
    }
    this.changed();
  }

  /** Horizontal centre of the viewport that contains x; results that are compared have one viewport each. */
  middle(x) {
    const width = this.element.clientWidth / (this.pictures ?? 1);
    return (Math.floor(x / width) + 0.5 - this.shift) * width;
  }

  #wheel(event) {
    if (!this.takesWheel(event)) return;
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 33 : 1;
    this.zoom(
      Math.exp(Math.max(-1, Math.min(1, event.deltaY * lines * 0.0015))),
      event.clientX,
      event.clientY,
    );
  }
}

const MATRIX = new Matrix4();
const ORIGIN = new Vector3();
const RIGHT = new Vector3();
