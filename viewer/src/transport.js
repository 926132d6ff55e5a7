// SPDX-License-Identifier: Apache-2.0
// Time controls: playback, stepping, time, speed, repeated interval, and event marks to jump to.
import { colourOfMark } from "./colours.js";
import { button, choice, el, logSlider } from "./dom.js";
import { nameOfMark } from "./marks_panel.js";
import { duration, instant, speedWords } from "./numbers.js";
import { SLOWEST } from "./player.js";
import { SPARSE } from "./plots.js";

const FINE = 1e6;

export class Transport {
  /**
   * @param {import("./player.js").Player} player
   * @param {any[]} marks of all results
   * @param {{seek: (t: number) => void, toggle: () => void, step: (n: number) => void, speed: (x: number) =>
   *   void, loop: (what: string) => string}} does
   * @param {string} whose result whose frames are used for stepping, if the frames of two results differ
   */
  constructor(player, marks, does, whose = "") {
    this.player = player;
    this.marks = [...marks].sort((a, b) => a.time - b.time);
    this.kinds = [...new Set(this.marks.map((mark) => mark.kind))];
    this.does = does;
    // The smallest frame interval determines the number of digits.
    this.stepLength = Infinity;
    for (let k = 1; k < player.times.length; k++)
      this.stepLength = Math.min(this.stepLength, player.times[k] - player.times[k - 1] || Infinity);
    if (!Number.isFinite(this.stepLength)) this.stepLength = 1;
    const step = whose && `, ${duration(this.stepLength)}, the frame interval of ${whose}`;
    this.play = button("", "Play (space)", does.toggle, { className: "ppv-play" });
    this.range = el("input", {
      type: "range",
      min: "0",
      max: String(FINE),
      step: "1",
      className: "ppv-range",
      title: "Time",
      "aria-label": "Time",
    });
    this.range.addEventListener("input", () => does.seek(this.#time(Number(this.range.value) / FINE)));
    this.strip = el("canvas", {
      className: "ppv-marks",
      role: "img",
      "aria-label": `${this.marks.length} marks`,
    });
    this.tip = el("div", { className: "ppv-tip", hidden: true });
    this.strip.addEventListener("pointermove", (event) => this.#hover(event));
    this.strip.addEventListener("pointerleave", () => (this.tip.hidden = true));
    this.strip.addEventListener("click", (event) => {
      const mark = this.#near(event);
      does.seek(mark ? mark.time : this.#time(this.#share(event)));
    });
    this.read = el("output", { className: "ppv-now", title: "Time" });
    this.speed = logSlider({
      label: "",
      title: "Speed relative to real time (+ and −)",
      least: SLOWEST,
      most: 1,
      value: player.speed,
      show: speedWords,
      changed: does.speed,
    });
    this.loop = choice(
      "repeat",
      [
        ["record", "whole record"],
        ["turn", "one turn"],
        ["cycle", "one mesh cycle"],
      ],
      (what) => {
        const wrong = does.loop(what);
        this.loop.select.value = player.loop;
        this.announce(wrong);
      },
    );
    this.status = el("span", { className: "ppv-status", role: "status" });
    this.jump = this.marks.length
      ? [
          button("⟨", "Previous mark ([)", () => this.toMark(-1)),
          button("⟩", "Next mark (])", () => this.toMark(1)),
        ]
      : [];
    this.row = el(
      "div",
      { className: "ppv-transport" },
      this.play,
      button("|◂", "To the start (Home)", () => does.seek(player.window[0])),
      button("◂", `One frame back (left arrow)${step}`, () => does.step(-1)),
      button("▸", `One frame forward (right arrow)${step}`, () => does.step(1)),
      ...this.jump,
      this.read,
      this.speed.row,
      this.loop.row,
      this.status,
    );
    this.element = el(
      "div",
      { className: "ppv-time" },
      el("div", { className: "ppv-track" }, this.strip, this.range, this.tip),
      this.row,
    );
    if (player.times.length < 2) this.element.classList.add("ppv-still");
  }

  #time(share) {
    return this.player.first + share * (this.player.last - this.player.first);
  }

  #share(event) {
    const box = this.strip.getBoundingClientRect();
    return Math.max(0, Math.min(1, (event.clientX - box.left) / box.width));
  }

  #near(event) {
    const box = this.strip.getBoundingClientRect();
    const t = this.#time(this.#share(event));
    const reach = (6 * (this.player.last - this.player.first)) / Math.max(box.width, 1);
    let best = null;
    for (const mark of this.marks)
      if (Math.abs(mark.time - t) <= reach && (!best || Math.abs(mark.time - t) < Math.abs(best.time - t)))
        best = mark;
    return best;
  }

  #hover(event) {
    const mark = this.#near(event);
    this.tip.hidden = !mark;
    this.strip.style.cursor = "pointer";
    if (!mark) return;
    this.tip.textContent = `${nameOfMark(mark.kind)}${mark.what ? `, ${mark.what}` : ""}, ${instant(mark.time, this.stepLength / 10)}`;
    const box = this.strip.getBoundingClientRect();
    const left = event.clientX - box.left;
    this.tip.style.left = `${Math.max(0, Math.min(box.width - 180, left))}px`;
  }

  /** @param {string} words */
  announce(words) {
    this.status.textContent = words;
  }

  /** @param {1|-1} way direction */
  toMark(way) {
    const t = this.player.time;
    const least = 1e-9 * (this.player.last - this.player.first);
    const found =
      way > 0
        ? this.marks.find((mark) => mark.time > t + least)
        : this.marks.findLast((mark) => mark.time < t - least);
    if (found) this.does.seek(found.time);
  }

  /** Draw the marks and the repeated interval. */
  draw() {
    const { strip, player } = this;
    const width = strip.clientWidth,
      height = strip.clientHeight;
    if (!width) return;
    const ratio = window.devicePixelRatio || 1;
    strip.width = width * ratio;
    strip.height = height * ratio;
    const pen = strip.getContext("2d");
    pen.scale(ratio, ratio);
    const length = player.last - player.first || 1;
    const x = (t) => ((t - player.first) / length) * width;
    const style = getComputedStyle(this.element);
    if (player.loop !== "record") {
      pen.fillStyle = style.getPropertyValue("--v-accent");
      pen.globalAlpha = 0.35;
      pen.fillRect(
        x(player.window[0]),
        height - 4,
        Math.max(2, x(player.window[1]) - x(player.window[0])),
        4,
      );
      pen.globalAlpha = 1;
    }
    const last = {};
    for (const mark of this.marks) {
      pen.fillStyle = colourOfMark(this.kinds, mark.kind);
      pen.globalAlpha = 0.3;
      if (mark.until > mark.time) pen.fillRect(x(mark.time), 3, x(mark.until) - x(mark.time), height - 9);
      if (x(mark.time) - (last[mark.kind] ?? -9) < SPARSE) continue;
      last[mark.kind] = x(mark.time);
      pen.globalAlpha = 1;
      pen.fillRect(x(mark.time) - 0.75, 1, 1.5, height - 5);
    }
    pen.globalAlpha = 1;
  }

  update() {
    const { player } = this;
    const length = player.last - player.first;
    const share = length > 0 ? (player.time - player.first) / length : 0;
    this.range.value = String(Math.round(share * FINE));
    const text = instant(player.time, player.playing ? this.stepLength : this.stepLength / 10);
    this.range.ariaValueText = text;
    this.read.textContent = text;
    this.read.title = `Time; record length ${duration(length)}`;
    const state = player.playing ? "pause" : "play";
    if (this.play.dataset.state !== state) {
      this.play.dataset.state = state;
      this.play.textContent = player.playing ? "❚❚" : "▶\ufe0e";
      this.play.title = player.playing ? "Pause (space)" : "Play (space)";
      this.play.setAttribute("aria-label", this.play.title);
    }
  }
}
