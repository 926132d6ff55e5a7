// SPDX-License-Identifier: Apache-2.0
// Gears: one tooth of each shape, drawn as instances at the positions of its copies. Copies outside the view
// are omitted, and the level of detail follows the distance.
import {
  BufferAttribute,
  BufferGeometry,
  Frustum,
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  Sphere,
  Vector3,
} from "three";
import { creaseNormals } from "./crease_normals.js";

// Maximum chordal deviation in pixels that is not visible.
const UNSEEN = 0.35;

/** Geometry of a surface from creaseNormals. */
export function geometryOf({ points, normals, index }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setIndex(
    points.length / 3 < 65536
      ? new BufferAttribute(Uint16Array.from(index), 1)
      : new BufferAttribute(Uint32Array.from(index), 1),
  );
  geometry.computeBoundingSphere();
  return geometry;
}

/** Points rotated about the third axis. @param {ArrayLike<number>} points @param {number} angle */
function turned(points, angle) {
  const c = Math.cos(angle),
    s = Math.sin(angle);
  const out = new Float32Array(points.length);
  for (let k = 0; k < points.length; k += 3) {
    out[k] = c * points[k] - s * points[k + 1];
    out[k + 1] = s * points[k] + c * points[k + 1];
    out[k + 2] = points[k + 2];
  }
  return out;
}

/**
 * Geometry of one angular pitch. Its normals include the adjacent pitches, so that no seam is visible between
 * copies.
 * @param {any} level
 * @param {number} pitch angle between copies
 * @param {number} creases
 */
function seamless(level, pitch, creases) {
  const points = level.points.data;
  const triangles = level.triangles.data;
  const count = points.length / 3;
  let size = 0;
  for (const x of points) size = Math.max(size, Math.abs(x));
  const known = new Map();
  const all = [];
  const number = (x, y, z) => {
    const key = [x, y, z].map((v) => Math.round((v / size) * 2e5)).join();
    if (!known.has(key)) {
      known.set(key, all.length / 3);
      all.push(x, y, z);
    }
    return known.get(key);
  };
  const corners = [];
  for (const side of [0, -1, 1]) {
    const beside = side ? turned(points, side * pitch) : points;
    const at = Array.from({ length: count }, (_, k) =>
      number(beside[3 * k], beside[3 * k + 1], beside[3 * k + 2]),
    );
    for (const corner of triangles) corners.push(at[corner]);
  }
  const made = creaseNormals(Float32Array.from(all), Uint32Array.from(corners), creases);
  // Only the pitch itself is kept.
  const index = made.index.subarray(0, triangles.length);
  const kept = new Map();
  const place = Uint32Array.from(index, (k) => {
    if (!kept.has(k)) kept.set(k, kept.size);
    return kept.get(k);
  });
  const pick = (values) => {
    const out = new Float32Array(3 * kept.size);
    for (const [from, to] of kept) out.set(values.subarray(3 * from, 3 * from + 3), 3 * to);
    return out;
  };
  return geometryOf({ points: pick(made.points), normals: pick(made.normals), index: place });
}

const TURN = new Matrix4();
const WORLD = new Matrix4();
const VIEW = new Matrix4();
const SPHERE = new Sphere();
const FRUSTUM = new Frustum();
const POINT = new Vector3();

export class Repeated extends Group {
  /**
   * @param {any} part of Solids
   * @param {(fault: string) => import("three").Material} material of a repeated part
   */
  constructor(part, material) {
    super();
    const { solid } = part;
    this.matrixAutoUpdate = false;
    const pitch = (2 * Math.PI) / Math.max(solid.teeth || 0, 2);
    this.pieces = solid.pieces.map((piece) => {
      const turns = Array.from(piece.turns.data);
      const levels = piece.levels.map((level) => {
        const geometry = seamless(level, pitch, solid.creases ?? 40);
        const mesh = new InstancedMesh(geometry, material(piece.fault), turns.length);
        mesh.instanceMatrix = new InstancedBufferAttribute(new Float32Array(16 * turns.length), 16);
        mesh.frustumCulled = false;
        mesh.matrixAutoUpdate = false;
        mesh.count = 0;
        mesh.visible = false;
        Object.assign(mesh.userData, { part, fault: piece.fault });
        this.add(mesh);
        return { error: level.error, geometry, mesh, shown: [] };
      });
      const { center, radius } = levels[levels.length - 1].geometry.boundingSphere;
      const centres = turns.map((turn) => center.clone().applyMatrix4(TURN.makeRotationZ(turn)));
      return { turns, levels, centres, radius };
    });
  }

  get meshes() {
    return this.pieces.flatMap(({ levels }) => levels.map(({ mesh }) => mesh));
  }

  /** Number of triangles currently drawn. */
  get drawn() {
    return this.meshes.reduce(
      (sum, mesh) => sum + (mesh.visible ? (mesh.count * mesh.geometry.index.count) / 3 : 0),
      0,
    );
  }

  /** Number of triangles of all copies at the finest level. */
  get finest() {
    return this.pieces.reduce(
      (sum, { turns, levels }) =>
        sum + (turns.length * levels[levels.length - 1].geometry.index.count) / 3,
      0,
    );
  }

  /**
   * Choose the level of detail of each copy.
   * @param {Matrix4} seen transformation from the scene to the camera's world
   * @param {import("three").PerspectiveCamera} camera
   * @param {number} pixel size of a pixel at unit distance
   */
  choose(seen, camera, pixel) {
    WORLD.multiplyMatrices(seen, this.matrix);
    VIEW.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    FRUSTUM.setFromProjectionMatrix(VIEW);
    VIEW.multiplyMatrices(camera.matrixWorldInverse, WORLD);
    for (const piece of this.pieces) {
      const chosen = piece.levels.map(() => []);
      piece.centres.forEach((centre, k) => {
        SPHERE.center.copy(centre).applyMatrix4(WORLD);
        SPHERE.radius = piece.radius;
        if (!FRUSTUM.intersectsSphere(SPHERE)) return;
        const away = camera.parallel ? camera.distance : Math.max(-POINT.copy(centre).applyMatrix4(VIEW).z - piece.radius, camera.near);
        const allowed = UNSEEN * pixel * away;
        let level = piece.levels.findIndex(({ error }) => error <= allowed);
        if (level < 0) level = piece.levels.length - 1;
        chosen[level].push(k);
      });
      piece.levels.forEach((level, n) => this.#show(piece, level, chosen[n]));
    }
  }

  #show(piece, level, copies) {
    const { mesh } = level;
    if (copies.length === level.shown.length && copies.every((k, i) => k === level.shown[i])) return;
    level.shown = copies;
    copies.forEach((k, i) =>
      TURN.makeRotationZ(piece.turns[k]).toArray(mesh.instanceMatrix.array, 16 * i),
    );
    mesh.instanceMatrix.needsUpdate = true;
    mesh.count = copies.length;
    mesh.visible = copies.length > 0;
    mesh.boundingSphere = null;
  }

  /** All copies as one mesh, for files, ray casting and bounds. @param {"coarse"|"fine"} which */
  whole(which) {
    const blocks = this.pieces.flatMap(({ turns, levels }) => {
      const fine = levels.length - (levels.length > 2 ? 2 : 1);
      const { geometry } = levels[which === "fine" ? fine : 0];
      return turns.map((turn) => ({ geometry, turn }));
    });
    const sum = (count) => blocks.reduce((total, { geometry }) => total + count(geometry), 0);
    const points = new Float32Array(sum(({ attributes }) => attributes.position.array.length));
    const normals = new Float32Array(points.length);
    const index = new Uint32Array(sum((geometry) => geometry.index.count));
    let [at, corner] = [0, 0];
    for (const { geometry, turn } of blocks) {
      points.set(turned(geometry.attributes.position.array, turn), at);
      normals.set(turned(geometry.attributes.normal.array, turn), at);
      for (const each of geometry.index.array) index[corner++] = at / 3 + each;
      at += geometry.attributes.position.array.length;
    }
    return geometryOf({ points, normals, index });
  }
}
