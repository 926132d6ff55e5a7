// SPDX-License-Identifier: Apache-2.0
// Merges coincident points of adjacent tooth copies. Each copy is rotated separately, so that rounding errors
// separate their common points.

/**
 * Direction that is not perpendicular to typical edges of machine parts: points with similar coordinates
 * along it are close to each other.
 */
const ALONG = [0.5377, 0.7071, 0.4591];
/** Merging distance relative to the largest coordinate; single precision resolves 6e-8 of it. */
const NEAR = 1e-6;

/**
 * Triangles of a surface after merging coincident points.
 * @param {ArrayLike<number>} points x, y, z of each point
 * @param {ArrayLike<number>} index three corners per triangle
 * @returns {number[]} corners of the remaining triangles; merged points have the index of one of them
 */
export function mergedPoints(points, index) {
  const count = points.length / 3;
  const along = new Float64Array(count);
  let near = 0;
  for (let k = 0; k < count; k++) {
    for (let i = 0; i < 3; i++) {
      along[k] += ALONG[i] * points[3 * k + i];
      near = Math.max(near, NEAR * Math.abs(points[3 * k + i]));
    }
  }
  const order = Uint32Array.from(along.keys()).sort((a, b) => along[a] - along[b]);
  const same = new Uint32Array(count);
  order.forEach((point, k) => {
    same[point] = point;
    for (let j = k - 1; j >= 0 && along[point] - along[order[j]] <= near; j--) {
      const other = same[order[j]];
      const apart = Math.hypot(...[0, 1, 2].map((i) => points[3 * point + i] - points[3 * other + i]));
      if (apart > near) continue;
      same[point] = other;
      break;
    }
  });
  const left = [];
  for (let k = 0; k < index.length; k += 3) {
    const corners = [same[index[k]], same[index[k + 1]], same[index[k + 2]]];
    if (new Set(corners).size === 3) left.push(...corners);
  }
  return left;
}
