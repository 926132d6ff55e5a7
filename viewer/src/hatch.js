// SPDX-License-Identifier: Apache-2.0
// Hatch of section faces: direction and spacing differ between neighbouring parts, as in a drawing.
import { Vector3 } from "three";

const DEGREE = Math.PI / 180;

/** Direction [rad] and relative spacing of the hatches. */
export const HATCHES = [
  [45, 1],
  [135, 1],
  [45, 0.6],
  [135, 0.6],
  [30, 1.4],
  [150, 1.4],
  [60, 0.8],
  [120, 0.8],
].map(([angle, spacing]) => ({ angle: angle * DEGREE, spacing }));

/**
 * A hatch for each part, different from those of the parts whose boxes touch its box.
 * @param {{low: Vector3, high: Vector3}[]} boxes
 * @returns {number[]} indices of HATCHES
 */
export function hatchesOf(boxes) {
  const found = [];
  boxes.forEach((box, k) => {
    const used = HATCHES.map(() => 0);
    for (let other = 0; other < k; other++) if (touches(box, boxes[other])) used[found[other]]++;
    found.push(used.indexOf(Math.min(...used)));
  });
  return found;
}

function touches(a, b) {
  const air = 1e-3 * Math.max(a.low.distanceTo(a.high), b.low.distanceTo(b.high));
  return ["x", "y", "z"].every((axis) => a.low[axis] <= b.high[axis] + air && b.low[axis] <= a.high[axis] + air);
}

/** Box of a part at rest in the world. @param {any} part @param {import("three").Matrix4} matrix */
export function boxOf({ geometry }, matrix) {
  geometry.boundingBox ?? geometry.computeBoundingBox();
  const box = geometry.boundingBox.clone().applyMatrix4(matrix);
  return { low: box.min, high: box.max };
}

/** Whether a surface is closed: the sum of its area vectors vanishes. @param {any} geometry */
export function isClosed({ attributes, index }) {
  const { array } = attributes.position;
  const [a, b, c, sum] = [0, 0, 0, 0].map(() => new Vector3());
  let size = 0;
  for (let k = 0; k < index.count; k += 3) {
    a.fromArray(array, 3 * index.array[k]);
    b.fromArray(array, 3 * index.array[k + 1]).sub(a);
    c.fromArray(array, 3 * index.array[k + 2]).sub(a);
    b.cross(c);
    sum.add(b);
    size += b.length();
  }
  return sum.length() <= 1e-4 * size;
}
