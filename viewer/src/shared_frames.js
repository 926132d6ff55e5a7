// SPDX-License-Identifier: Apache-2.0
// Common frames of two results that are compared: the frames of one result, whose name is shown on the page.
import { duration } from "./numbers.js";
import { namesOf } from "./names.js";

/** Mean time between frames; Infinity for fewer than two frames. @param {ArrayLike<number>} times */
const stepOf = (times) => (times.length > 1 ? (times[times.length - 1] - times[0]) / (times.length - 1) : Infinity);

/**
 * Frames for stepping: those of the record with the smaller interval, extended by those of the other record
 * outside its range. The union of both sets of frames would give very uneven steps, down to a nanosecond.
 * @param {any[]} scenes one or two
 * @returns {{times: ArrayLike<number>, whose: string, note: string}} `whose` is empty if the frames are
 *   identical
 */
export function sharedFrames(scenes) {
  const lists = scenes.map((scene) => scene.times?.data ?? []);
  if (lists.length === 1) return { times: lists[0], whose: "", note: "" };
  const steps = lists.map(stepOf);
  const fine = steps[1] < steps[0] ? 1 : 0;
  const [own, other] = [lists[fine], lists[1 - fine]];
  const near = 0.5 * Math.min(...steps);
  const rest = [...other].filter((t) => !own.length || t < own[0] - near || t > own[own.length - 1] + near);
  const times = Float64Array.from([...own, ...rest]).sort();
  const same = own.length === other.length && own.every((t, k) => Math.abs(t - other[k]) < 1e-6 * near);
  if (same || !Number.isFinite(steps[1 - fine])) return { times, whose: "", note: "" };
  const names = namesOf(scenes);
  const [mine, its] = [names[fine], names[1 - fine]];
  const note = `Time steps follow the frames of ${mine}, every ${duration(steps[fine])}; the frames of ${its}, every ${duration(steps[1 - fine])}, are interpolated linearly.`;
  return { times, whose: mine, note };
}
