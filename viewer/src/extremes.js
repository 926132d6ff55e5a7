// SPDX-License-Identifier: Apache-2.0
// Extreme points of a surface in evenly distributed directions; a fitted view must contain them.
import { Vector3 } from "three";

/** Golden angle [rad]: points on a spiral with this step are evenly distributed over the sphere. */
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
 * Extreme points of a surface. Sampling every n-th point could miss the outline of a ring gear if n matches
 * its number of points per tooth.
 * @param {import("three").BufferAttribute} points
 * @param {Vector3[]} ways directions
 * @returns {Vector3[]} at most one per direction, without duplicates
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
