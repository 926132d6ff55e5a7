// SPDX-License-Identifier: Apache-2.0
// Vertex normals: smooth across small dihedral angles, split at sharp edges, so that tooth edges remain
// visible.

/**
 * @param {ArrayLike<number>} points three coordinates per point
 * @param {ArrayLike<number>} triangles three indices per triangle
 * @param {number} creases edges with a larger angle between their faces are sharp [degrees]
 * @returns {{points: Float32Array, normals: Float32Array, index: Uint32Array, source: Uint32Array}} points
 *   are duplicated where normals differ; `source` is the index of the original point of each one
 */
export function creaseNormals(points, triangles, creases = 40) {
  const count = points.length / 3;
  const faces = triangles.length / 3;
  const face = new Float64Array(3 * faces);
  const area = new Float64Array(faces);
  for (let f = 0; f < faces; f++) {
    const [a, b, c] = [3 * triangles[3 * f], 3 * triangles[3 * f + 1], 3 * triangles[3 * f + 2]];
    const ux = points[b] - points[a],
      uy = points[b + 1] - points[a + 1],
      uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a],
      vy = points[c + 1] - points[a + 1],
      vz = points[c + 2] - points[a + 2];
    const nx = uy * vz - uz * vy,
      ny = uz * vx - ux * vz,
      nz = ux * vy - uy * vx;
    const size = Math.hypot(nx, ny, nz);
    area[f] = size;
    if (size) face.set([nx / size, ny / size, nz / size], 3 * f);
  }
  // Triangle corners at each point in one list, with the start index of each point.
  const starts = new Uint32Array(count + 1);
  for (let k = 0; k < triangles.length; k++) starts[triangles[k] + 1]++;
  for (let p = 0; p < count; p++) starts[p + 1] += starts[p];
  const fill = starts.slice(0, count);
  const around = new Uint32Array(triangles.length);
  for (let k = 0; k < triangles.length; k++) around[fill[triangles[k]]++] = k;

  const least = Math.cos((creases * Math.PI) / 180);
  const outPoints = [],
    outNormals = [],
    outSource = [];
  const index = new Uint32Array(triangles.length);
  for (let p = 0; p < count; p++) {
    const made = [];
    for (let i = starts[p]; i < starts[p + 1]; i++) {
      const f = 3 * ((around[i] / 3) | 0);
      let nx = 0,
        ny = 0,
        nz = 0;
      for (let j = starts[p]; j < starts[p + 1]; j++) {
        const g = (around[j] / 3) | 0;
        const dot = face[f] * face[3 * g] + face[f + 1] * face[3 * g + 1] + face[f + 2] * face[3 * g + 2];
        if (dot < least) continue;
        nx += area[g] * face[3 * g];
        ny += area[g] * face[3 * g + 1];
        nz += area[g] * face[3 * g + 2];
      }
      const size = Math.hypot(nx, ny, nz) || 1;
      nx /= size;
      ny /= size;
      nz /= size;
      let at = made.find(
        (m) =>
          Math.abs(outNormals[3 * m] - nx) +
            Math.abs(outNormals[3 * m + 1] - ny) +
            Math.abs(outNormals[3 * m + 2] - nz) <
          1e-6,
      );
      if (at === undefined) {
        at = outSource.length;
        made.push(at);
        outSource.push(p);
        outPoints.push(points[3 * p], points[3 * p + 1], points[3 * p + 2]);
        outNormals.push(nx, ny, nz);
      }
      index[around[i]] = at;
    }
  }
  return {
    points: Float32Array.from(outPoints),
    normals: Float32Array.from(outNormals),
    index,
    source: Uint32Array.from(outSource),
  };
}
