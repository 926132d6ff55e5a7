// SPDX-License-Identifier: Apache-2.0
// Reads the two data elements of a page (docs/scene_format.md) into typed arrays. Errors are sentences with
// the reason.
import { fromPlanes, mixed, spreadChannels } from "./planes.js";

export const FORMAT = "pitchpoint-scene-2";

const TYPES = {
  f8: Float64Array,
  f4: Float32Array,
  i4: Int32Array,
  u4: Uint32Array,
  i2: Int16Array,
  u2: Uint16Array,
  u1: Uint8Array,
};

/** Error in a scene, with a message for the user. */
export class SceneError extends Error {}

/**
 * @typedef {Float64Array|Float32Array|Int32Array|Uint32Array|Int16Array|Uint16Array|Uint8Array} Numbers
 * @typedef {{data: Numbers, shape: number[], width: number, count: number}} Table count rows of width numbers
 */

/**
 * @param {string} text base64
 * @returns {Uint8Array}
 */
function fromBase64(text) {
  let binary;
  try {
    binary = atob(text.trim());
  } catch {
    throw new SceneError(
      "The data of this scene cannot be decoded (not base64). The file may be damaged.",
    );
  }
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < bytes.length; k++) bytes[k] = binary.charCodeAt(k);
  return bytes;
}

/**
 * @param {Uint8Array} packed
 * @returns {Promise<ArrayBuffer>}
 */
async function unzip(packed) {
  if (typeof DecompressionStream === "undefined") {
    throw new SceneError(
      "This browser cannot decompress the data of the scene (no DecompressionStream). Use a newer browser.",
    );
  }
  try {
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return await new Response(stream).arrayBuffer();
  } catch {
    throw new SceneError("The data of this scene cannot be decompressed: the file is truncated or damaged.");
  }
}

/**
 * @param {ArrayBuffer} buffer
 * @param {any} entry array entry of the header
 * @param {string} what name of the array in messages
 * @returns {Table}
 */
export function readTable(buffer, entry, what) {
  const planes = entry?.type === "planes";
  const Type = planes ? Uint8Array : TYPES[entry?.type];
  const shape = entry?.shape;
  if (!Type || !Array.isArray(shape) || !shape.length || shape.some((n) => !Number.isInteger(n) || n < 0)) {
    throw new SceneError(`This scene cannot be read: ${what} has an unknown type or shape.`);
  }
  const length = shape.reduce((product, n) => product * n, 1);
  const at = entry.at;
  const held = planes ? length * entry.bytes : length;
  if (!Number.isInteger(at) || at < 0 || at % 8 || !(at + held * Type.BYTES_PER_ELEMENT <= buffer.byteLength)) {
    throw new SceneError(`This scene is truncated: ${what} is beyond the end of the data.`);
  }
  const bytes = new Type(buffer, at, held);
  const stored = planes ? fromPlanes(bytes, length, entry) : bytes;
  const last = shape[shape.length - 1];
  const width = shape.length > 1 ? length / Math.max(shape[0], 1) : 1;
  const count = shape[0];
  if (!entry.scale && !entry.offset) return { data: stored, shape, width, count };
  const each = shape.length > 1 ? last : 1;
  const scale = entry.scale ?? Array(each).fill(1);
  const offset = (!entry.mix && entry.offset) || Array(each).fill(0);
  const data = new Float64Array(length);
  for (let k = 0; k < length; k++) data[k] = offset[k % each] + scale[k % each] * stored[k];
  if (entry.exponent) data.forEach((x, k) => (data[k] = Math.exp(x)));
  if (!entry.mix) return { data, shape, width, count };
  const wide = entry.offset.length;
  return { data: mixed(data, count, entry.mix, entry.offset), shape: [count, wide], width: wide, count };
}

/**
 * The header with each array entry replaced by a Table.
 * @param {any} node
 * @param {ArrayBuffer} buffer
 * @param {string} what
 * @returns {any}
 */
function withTables(node, buffer, what, known = new Map()) {
  if (Array.isArray(node))
    return node.map((item, k) =>
      withTables(item, buffer, item?.name ? `${what} ${item.name}` : `${what} ${k + 1}`, known),
    );
  if (node === null || typeof node !== "object") return node;
  if ("at" in node && "type" in node && "shape" in node) {
    // Arrays shared by several bodies are unpacked once.
    const key = JSON.stringify(node);
    if (!known.has(key)) known.set(key, readTable(buffer, node, what));
    return known.get(key);
  }
  const out = {};
  for (const [key, value] of Object.entries(node))
    out[key] = withTables(value, buffer, `${key} of ${what}`, known);
  return out;
}

/** @param {boolean} right condition @param {string} sentence */
function check(right, sentence) {
  if (!right) throw new SceneError(`This scene cannot be read: ${sentence}.`);
}

/** @param {any} scene */
function checkShapes(scene) {
  const n = scene.times?.count ?? 0;
  const rows = (table, what) =>
    check(
      !table || table.count === n || table.count === 1,
      `${what} has ${table?.count} rows for ${n} times`,
    );
  for (const { channel, lines, times, levels } of scene.maps)
    check(
      lines?.count > 1 && times?.count > 1 && levels?.data.length === lines.count * times.count,
      `the map of ${channel} has ${levels?.data.length} levels for ${lines?.count} lines at ${times?.count} times`,
    );
  scene.bodies.forEach((body, k) => {
    check(
      Number.isInteger(body.parent ?? -1) && (body.parent ?? -1) < k,
      `body ${body.name} is listed before its parent`,
    );
    for (const part of ["position", "travel", "turn", "spin", "gross", "quaternion"])
      rows(body[part], `${part} of body ${body.name}`);
  });
  for (const solid of scene.solids) {
    check(solid.body >= -1 && solid.body < scene.bodies.length, `solid ${solid.name} refers to an unknown body`);
    const surfaces = solid.pieces ? solid.pieces.flatMap((piece) => piece.levels ?? []) : [solid];
    check(surfaces.length, `solid ${solid.name} has no surface`);
    for (const { points, triangles } of surfaces) {
      check(points?.width === 3 && triangles?.width === 3, `solid ${solid.name} has no surface`);
      for (const corner of triangles.data)
        check(corner < points.count, `solid ${solid.name} has a triangle with an invalid point index`);
    }
    for (const piece of solid.pieces ?? []) check(piece.turns?.count, `solid ${solid.name} has no positions`);
    if (solid.modal) {
      const { shapes, node, coordinates } = solid.modal;
      check(
        shapes?.shape.length === 3 && node?.count === solid.points?.count,
        `solid ${solid.name} has no deformation data`,
      );
      for (const each of node.data) check(each < shapes.shape[1], `solid ${solid.name} has a point with an invalid node index`);
      rows(coordinates, `the modal coordinates of ${solid.name}`);
    }
    for (const body of solid.between?.bodies ?? [])
      check(body >= -1 && body < scene.bodies.length, `solid ${solid.name} refers to an unknown body`);
    for (const body of solid.blend?.bodies ?? [])
      check(body >= -1 && body < scene.bodies.length, `the blend of ${solid.name} refers to an unknown body`);
  }
  for (const arrow of scene.arrows) {
    check(arrow.body >= -1 && arrow.body < scene.bodies.length, `arrow ${arrow.name} refers to an unknown body`);
    for (const part of ["circumferential", "radial", "axial"])
      rows(arrow.components?.[part], `the ${part} force ${arrow.name}`);
    rows(arrow.at, `the position of arrow ${arrow.name}`);
    rows(arrow.state, `the state of arrow ${arrow.name}`);
  }
  for (const contact of scene.contacts) checkContact(scene, contact, rows);
  for (const channel of scene.channels) {
    const k = channel.least?.count;
    check(
      channel.times && k && channel.times.count === k && (channel.most?.count ?? k) === k,
      `channel ${channel.name} has times and values of different length`,
    );
  }
}

/** @param {any} scene @param {any} contact @param {(table: any, what: string) => void} rows */
function checkContact(scene, contact, rows) {
  const { name } = contact;
  for (const part of ["at", "axes", "pressure_angle", "penetration"]) {
    check(contact[part], `contact ${name} has no ${part}`);
    rows(contact[part], `${part} of contact ${name}`);
  }
  check(contact.width?.length === 2 && contact.path?.length === 2, `contact ${name} has no position`);
  check(!contact.unit_pressure || contact.unit_pressure.count > 1, `contact ${name} has no pressures`);
  check(contact.base_pitch > 0 && contact.flanks?.length, `contact ${name} has no flanks`);
  for (const flank of contact.flanks) {
    check(flank.travel?.count === scene.times.count, `contact ${name} does not give the travel at each time`);
    for (const part of ["forces", "loads"]) rows(flank[part], `${part} of contact ${name}`);
    check(Boolean(flank.forces) === Boolean(flank.loads), `contact ${name} has forces without loads, or loads without forces`);
    for (const surface of flank.surfaces ?? []) {
      check(surface.body in scene.bodies, `a flank of contact ${name} refers to an unknown body`);
      check(surface.points?.shape.length === 3 && surface.teeth > 0, `a flank of contact ${name} has no surface`);
    }
  }
}

/**
 * @param {string} suffix "" or "-2"
 * @returns {Promise<any>} the header with tables; missing lists are empty
 */
export async function readScene(suffix = "") {
  const header = document.getElementById(`pp-scene${suffix}`);
  const numbers = document.getElementById(`pp-scene-numbers${suffix}`);
  if (!header || !numbers) throw new SceneError("This page contains no scene.");
  let node;
  try {
    node = JSON.parse(header.textContent ?? "");
  } catch {
    throw new SceneError("The header of this scene cannot be read: the file is truncated or damaged.");
  }
  if (node?.format !== FORMAT) {
    throw new SceneError(`This scene has format "${node?.format}"; this viewer requires "${FORMAT}".`);
  }
  const buffer = await unzip(fromBase64(numbers.textContent ?? ""));
  const lists = {
    bodies: [],
    solids: [],
    arrows: [],
    contacts: [],
    channels: [],
    spectra: [],
    maps: [],
    marks: [],
    modes: [],
    notes: [],
  };
  const scene = {
    title: "",
    subtitle: "",
    up: [0, 1, 0],
    ...lists,
    ...withTables(node, buffer, "this scene"),
  };
  spreadChannels(scene);
  checkShapes(scene);
  return scene;
}
