// SPDX-License-Identifier: Apache-2.0
// Animation of mode shapes about the position at rest, with adjustable amplitude.
import { button, el, logSlider } from "./dom.js";
import { number } from "./numbers.js";

const PERIOD = 1.6; // duration of one cycle on the screen [s], independent of the frequency
const WIDTH = 0.06; // maximum displacement at amplitude 1, relative to the radius of the scene

export class Modes {
  /**
   * @param {any[]} modes of the first result
   * @param {import("./stage.js").Stage} stage
   * @param {() => void} changed
   */
  constructor(modes, stage, changed) {
    this.modes = modes;
    this.changed = changed;
    this.stage = stage;
    this.number = -1;
    this.phase = 0;
    this.amplitude = 1;
    this.unit = modes.map((mode) => this.#unit(mode));
    this.buttons = modes.map((mode, k) =>
      button("", `Animate ${mode.name}`, () => this.choose(this.number === k ? -1 : k), {
        "aria-pressed": "false",
      }),
    );
    this.buttons.forEach((each, k) =>
      each.append(...this.#lines(modes[k]).map((line) => el("span", {}, line))),
    );
    this.stop = button("stop animation", "Stop the animation of the mode", () => this.choose(-1));
    this.stop.hidden = true;
    const slider = logSlider({
      label: "amplitude",
      title: "Amplitude of the mode shape",
      least: 0.05,
      most: 20,
      value: 1,
      show: (x) => `× ${number(x, 2)}`,
      changed: (x) => {
        this.amplitude = x;
        this.changed();
      },
    });
    this.rows = [el("div", { className: "ppv-modes" }, ...this.buttons), slider.row, this.stop];
  }

  #facts({ frequency, damping }) {
    const fades = damping == null ? "" : `, damping ${number(100 * damping, 2)} %${damping < 0 ? ", unstable" : ""}`;
    return `${number(frequency, 4)} Hz${fades}`;
  }

  /** First line: number, frequency and damping; second line: description of the mode. */
  #lines(mode) {
    const [, number, name] = /^(\d+: )?(.*)$/s.exec(mode.name);
    return [(number ?? "") + this.#facts(mode), name];
  }

  /**
   * Factor that scales the maximum displacement of a mode to WIDTH; the amplitude of a mode shape is
   * arbitrary.
   */
  #unit(mode) {
    const { solids, bounds } = this.stage.pictures[0];
    let largest = 0;
    const size = (table, k) => {
      let sum = 0;
      for (let i = 0; i < 6; i++) sum += table ? table.data[6 * k + i] ** 2 : 0;
      return Math.sqrt(sum);
    };
    this.stage.pictures[0].data.bodies.forEach((_, k) => {
      const reach = solids.reachOf(k);
      largest = Math.max(
        largest,
        size(mode.position, k) + size(mode.turn, k) * (reach || 0.1 * bounds.radius),
      );
    });
    for (const { modal } of solids.parts) largest = Math.max(largest, modal?.largest(mode) ?? 0);
    return largest > 0 ? (WIDTH * bounds.radius) / largest : 0;
  }

  get active() {
    return this.number >= 0;
  }

  get words() {
    return this.active ? `${this.modes[this.number].name}, ${this.#facts(this.modes[this.number])}` : "";
  }

  /** @param {number} k -1 none */
  choose(k) {
    this.number = k;
    this.phase = 0;
    this.buttons.forEach((each, n) => each.setAttribute("aria-pressed", String(n === k)));
    this.stop.hidden = k < 0;
    this.changed();
  }

  /** @param {number} dt [s] */
  advance(dt) {
    if (this.active) this.phase = (this.phase + (2 * Math.PI * dt) / PERIOD) % (2 * Math.PI);
  }

  /** @param {{poses: import("./poses.js").Poses}} picture */
  pose({ poses }) {
    poses.ofMode(this.modes[this.number], this.phase, this.amplitude * this.unit[this.number]);
  }
}
