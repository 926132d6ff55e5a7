// SPDX-License-Identifier: Apache-2.0
// Outlines of section faces: intersections of the triangles of a solid with a plane.
import { Matrix4, Plane } from "three";

const LOCAL = new Matrix4();
const PLANE = new Plane();

/**
 * Intersections of a mesh with a plane as pairs of points.
 * @param {any} geometry
 * @param {Matrix4} matrix of the mesh
 * @param {Plane} plane in the frame that the matrix leads to
 * @param {number[]} out coordinates are appended, in that frame
 */
export function cutLines(geometry, matrix, plane, out) {
  PLANE.copy(plane).applyMatrix4(LOCAL.copy(matrix).invert());
  const { center, radius } = geometry.boundingSphere;
  if (Math.abs(PLANE.distanceToPoint(center)) > radius) return;
  const { array } = geometry.attributes.position;
  const corners = geometry.index.array;
  const { x, y, z } = PLANE.normal;
  const count = array.length / 3;
  if (HEIGHTS.length < count) HEIGHTS = new Float64Array(2 * count);
  const heights = HEIGHTS;
  for (let k = 0; k < count; k++)
    heights[k] = x * array[3 * k] + y * array[3 * k + 1] + z * array[3 * k + 2] + PLANE.constant;
  const e = matrix.elements;
  const put = (i, j) => {
    const share = heights[i] / (heights[i] - heights[j]);
    const p = array[3 * i] + share * (array[3 * j] - array[3 * i]);
    const q = array[3 * i + 1] + share * (array[3 * j + 1] - array[3 * i + 1]);
    const r = array[3 * i + 2] + share * (array[3 * j + 2] - array[3 * i + 2]);
    out.push(
      e[0] * p + e[4] * q + e[8] * r + e[12],
      e[1] * p + e[5] * q + e[9] * r + e[13],
      e[2] * p + e[6] * q + e[10] * r + e[14],
    );
  };
  for (let k = 0; k < corners.length; k += 3) {
    const a = corners[k],
      b = corners[k + 1],
      c = corners[k + 2];
    const up = (heights[a] >= 0) + 2 * (heights[b] >= 0) + 4 * (heights[c] >= 0);
    if (up === 0 || up === 7) continue;
    // The corner that is alone on its side.
    const alone = up === 1 || up === 6 ? a : up === 2 || up === 5 ? b : c;
    const [next, last] = alone === a ? [b, c] : alone === b ? [c, a] : [a, b];
    put(alone, next);
    put(alone, last);
  }
}

let HEIGHTS = new Float64Array(1024);
