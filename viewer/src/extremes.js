// SPDX-License-Identifier: Apache-2.0
// The points of a surface that reach farthest, in directions spread evenly: what a view has to hold.
import { Vector3 } from "three";

/** Half a turn of the golden section: directions along such a spiral are spread evenly. */
const GOLDEN = Math.PI * (3 - Math.sqrt(5));

/** @param {number} count @returns {Vector3[]} */
export function directions(count) {
  return Array.from({ length: count }, (_, k) => {
    const z = 1 - (2 * k + 1) / count,
      r = Math.sqrt(1 - z * z);
    return new Vector3(r * Math.cos(GOLDEN * k), r * Math.sin(GOLDEN * k), z);
  });
}

/**
 * Every n-th point would miss the rim of a ring where n suits its teeth; these do not.
 * @param {import("three").BufferAttribute} points @param {Vector3[]} ways @returns {Vector3[]} one a direction, none twice
 */
export function extremes(points, ways) {
  const { array, count } = points;
  const found = new Set();
  for (const { x, y, z } of count ? ways : []) {
    let best = 0,
      most = -Infinity;
    for (let k = 0; k < count; k++) {
      const reach = x * array[3 * k] + y * array[3 * k + 1] + z * array[3 * k + 2];
      if (reach > most) [best, most] = [k, reach];
    }
    found.add(best);
  }
  return [...found].map((k) => new Vector3().fromBufferAttribute(points, k));
}
