// SPDX-License-Identifier: Apache-2.0
// Playback: current time, speed and repeated interval.
import { between } from "./frames.js";

export const SLOWEST = 1e-4;

/** Rounds to 1, 2 or 5 times a power of ten. @param {number} value */
export function round125(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const head = value / power;
  return power * (head < 1.5 ? 1 : head < 3.5 ? 2 : head < 7.5 ? 5 : 10);
}

export class Player {
  /**
   * @param {ArrayLike<number>} times frames of all results
   * @param {import("./poses.js").Poses|null} poses of the first result
   */
  constructor(times, poses) {
    this.times = times;
    this.poses = poses;
    this.first = times.length ? times[0] : 0;
    this.last = times.length ? times[times.length - 1] : 0;
    this.time = this.first;
    this.playing = false;
    /** Called at the end of the played interval, which is then not repeated. */
    this.atEnd = null;
    this.loop = "record";
    this.window = [this.first, this.last];
    this.body = -1;
    this.speed = this.#pleasant();
  }

  /**
   * Frames of the first result around an instant; the playback frames of compared results may differ.
   * @param {number} t
   */
  #frame(t) {
    return between(this.poses?.times ?? this.times, t);
  }

  /** Initial speed: the fastest body rotates about once in three seconds, or the record lasts ten seconds. */
  #pleasant() {
    const length = this.last - this.first;
    let fastest = 0;
    const ends = [this.#frame(this.first), this.#frame(this.last)];
    this.poses?.bodies.forEach((_, k) => {
      fastest = Math.max(fastest, Math.abs(this.poses.angle(k, ends[1]) - this.poses.angle(k, ends[0])));
    });
    const speed = length > 0 ? (fastest > 1 ? (2 * Math.PI * length) / fastest / 3 : length / 10) : 1;
    return round125(Math.max(SLOWEST, Math.min(1, speed)));
  }

  /** @param {number} t */
  seek(t) {
    this.time = Math.max(this.first, Math.min(this.last, t));
  }

  /** @param {number} dt real time [s] */
  advance(dt) {
    if (!this.playing) return;
    const [a, b] = this.window;
    let t = this.time + dt * this.speed;
    if (t < a) t = a;
    const ended = t > b && this.atEnd;
    if (ended) t = b;
    if (t > b) t = b > a ? a + ((t - a) % (b - a)) : a;
    this.time = t;
    if (ended) this.atEnd();
  }

  /** Step by a number of frames from the current time. @param {number} frames */
  step(frames) {
    this.playing = false;
    const { low, share } = between(this.times, this.time);
    const here = low + share;
    const next = frames > 0 ? Math.floor(here + 1e-9) + frames : Math.ceil(here - 1e-9) + frames;
    this.time = this.times[Math.max(0, Math.min(this.times.length - 1, next))] ?? 0;
  }

  get frame() {
    const { low, share } = between(this.times, this.time);
    return low + share;
  }

  /**
   * Reference body for counting turns: the followed body, otherwise the first gear, otherwise the first
   * rotating body.
   * @param {number} followed
   */
  reference(followed, solids) {
    const turns = (k) =>
      this.poses &&
      Math.abs(
        this.poses.angle(k, this.#frame(this.last)) - this.poses.angle(k, this.#frame(this.first)),
      ) > 0;
    if (followed >= 0 && turns(followed)) return followed;
    const gear = solids.find((solid) => solid.teeth && turns(solid.body));
    return gear ? gear.body : (this.poses?.bodies.findIndex((_, k) => turns(k)) ?? -1);
  }

  /**
   * Repeat the whole record, or one turn or mesh cycle from the current time.
   * @param {"record"|"turn"|"cycle"} loop
   * @param {number} followed body
   * @param {any[]} solids
   * @returns {string} error message, empty if there is none
   */
  repeat(loop, followed, solids) {
    this.loop = "record";
    this.window = [this.first, this.last];
    if (loop === "record") return "";
    const body = this.reference(followed, solids);
    if (body < 0) return "No body of this scene rotates.";
    const teeth = solids.find((solid) => solid.body === body && solid.teeth)?.teeth;
    if (loop === "cycle" && !teeth) return "The followed body is not a gear.";
    const angle = (2 * Math.PI) / (loop === "cycle" ? teeth : 1);
    const at = (t) => this.poses.angle(body, this.#frame(t));
    const swept = Math.abs(at(this.last) - at(this.first));
    if (swept < angle) return "The record is shorter than the repeated interval.";
    // The start is moved back if less than one complete interval remains.
    let a = this.time;
    if (Math.abs(at(this.last) - at(a)) < angle)
      a = this.#when((t) => Math.abs(at(this.last) - at(t)) <= angle, this.first, this.last);
    const b = this.#when((t) => Math.abs(at(t) - at(a)) >= angle, a, this.last);
    this.loop = loop;
    this.body = body;
    this.window = [a, b];
    this.seek(a);
    return "";
  }

  /** First instant of a condition that then remains true, by bisection. */
  #when(holds, low, high) {
    for (let k = 0; k < 60; k++) {
      const middle = (low + high) / 2;
      if (holds(middle)) high = middle;
      else low = middle;
    }
    return high;
  }
}
