// SPDX-License-Identifier: Apache-2.0
// Export as binary glTF: one node per body with tracks of position and rotation, one mesh per solid.
import { Color, Matrix4, Quaternion, Vector3 } from "three";

const [FLOAT, UINT] = [5126, 5125];
const [POINTS, INDICES] = [34962, 34963];

class File {
  constructor() {
    this.pieces = [];
    this.length = 0;
    this.json = {
      asset: { version: "2.0", generator: "pitchpoint" },
      scene: 0,
      scenes: [{ nodes: [] }],
      nodes: [],
      meshes: [],
      materials: [],
      accessors: [],
      bufferViews: [],
      buffers: [{ byteLength: 0 }],
    };
  }

  /**
   * @param {Float32Array|Uint32Array} data
   * @param {string} type
   * @param {number} [target]
   * @param {boolean} ends whether minimum and maximum are written
   */
  put(data, type, target, ends = false) {
    const width = { SCALAR: 1, VEC3: 3, VEC4: 4 }[type];
    this.json.bufferViews.push({
      buffer: 0,
      byteOffset: this.length,
      byteLength: data.byteLength,
      ...(target && { target }),
    });
    const accessor = {
      bufferView: this.json.bufferViews.length - 1,
      componentType: data instanceof Float32Array ? FLOAT : UINT,
      count: data.length / width,
      type,
    };
    if (ends) {
      accessor.min = Array(width).fill(Infinity);
      accessor.max = Array(width).fill(-Infinity);
      data.forEach((x, k) => {
        accessor.min[k % width] = Math.min(accessor.min[k % width], x);
        accessor.max[k % width] = Math.max(accessor.max[k % width], x);
      });
    }
    this.pieces.push(new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
    this.length += data.byteLength;
    return this.json.accessors.push(accessor) - 1;
  }

  /** @returns {Uint8Array} */
  bytes() {
    this.json.buffers[0].byteLength = this.length;
    const text = new TextEncoder().encode(JSON.stringify(this.json));
    const padded = Math.ceil(text.length / 4) * 4;
    const out = new Uint8Array(12 + 8 + padded + 8 + this.length);
    const view = new DataView(out.buffer);
    [0x46546c67, 2, out.length, padded, 0x4e4f534a].forEach((word, k) => view.setUint32(4 * k, word, true));
    out.fill(0x20, 20, 20 + padded);
    out.set(text, 20);
    view.setUint32(20 + padded, this.length, true);
    view.setUint32(24 + padded, 0x004e4942, true);
    let at = 28 + padded;
    for (const piece of this.pieces) {
      out.set(piece, at);
      at += piece.length;
    }
    return out;
  }
}

/**
 * @param {any[]} parts of Solids; deformed solids are written in their current shape
 * @param {any[]} bodies
 * @param {Matrix4[][]} tracks world matrices of each body at each time
 * @param {number[]} times [s]
 * @returns {Uint8Array}
 */
export function glb(parts, bodies, tracks, times) {
  const file = new File();
  const { json } = file;
  const place = new Vector3(),
    rotation = new Quaternion(),
    size = new Vector3();
  const last = new Quaternion();
  const moving = times.length > 1;
  const time = moving
    ? file.put(
        Float32Array.from(times, (t) => t - times[0]),
        "SCALAR",
        undefined,
        true,
      )
    : 0;
  const animation = { name: "record", samplers: [], channels: [] };
  const used = new Set(parts.map(({ solid }) => (solid.blend ? solid.blend.bodies[0] : solid.body)));
  const nodes = new Map();
  for (const k of used) {
    const node = { name: k < 0 ? "ground" : bodies[k].name, children: [] };
    nodes.set(k, node);
    json.scenes[0].nodes.push(json.nodes.push(node) - 1);
    if (k < 0) continue;
    const places = new Float32Array(3 * times.length),
      rotations = new Float32Array(4 * times.length);
    tracks[k].forEach((matrix, n) => {
      matrix.decompose(place, rotation, size);
      // q and -q are the same rotation; equal signs give the shorter interpolation between two keys.
      if (n && rotation.dot(last) < 0) rotation.set(-rotation.x, -rotation.y, -rotation.z, -rotation.w);
      last.copy(rotation);
      place.toArray(places, 3 * n);
      rotation.toArray(rotations, 4 * n);
    });
    node.translation = [...places.slice(0, 3)];
    node.rotation = [...rotations.slice(0, 4)];
    if (!moving) continue;
    for (const [path, data, type, width] of [
      ["translation", places, "VEC3", 3],
      ["rotation", rotations, "VEC4", 4],
    ]) {
      if (data.every((x, n) => x === data[n % width])) continue;
      const sampler =
        animation.samplers.push({ input: time, output: file.put(data, type), interpolation: "LINEAR" }) - 1;
      animation.channels.push({ sampler, target: { node: json.nodes.indexOf(node), path } });
    }
  }
  const materials = new Map();
  for (const { solid, geometry, colour } of parts) {
    const key = colour + Boolean(solid.see_through);
    if (!materials.has(key)) {
      const { r, g, b } = new Color(colour);
      const look = {
        baseColorFactor: [r, g, b, solid.see_through ? 0.22 : 1],
        metallicFactor: 0.1,
        roughnessFactor: 0.7,
      };
      materials.set(
        key,
        json.materials.push({
          pbrMetallicRoughness: look,
          ...(solid.see_through && { alphaMode: "BLEND" }),
        }) - 1,
      );
    }
    const { position, normal } = geometry.attributes;
    const attributes = {
      POSITION: file.put(position.array, "VEC3", POINTS, true),
      NORMAL: file.put(normal.array, "VEC3", POINTS),
    };
    const indices = file.put(Uint32Array.from(geometry.index.array), "SCALAR", INDICES);
    const mesh =
      json.meshes.push({
        name: solid.name,
        primitives: [{ attributes, indices, material: materials.get(key) }],
      }) - 1;
    const node = json.nodes.push({ name: solid.name, mesh }) - 1;
    nodes.get(solid.blend ? solid.blend.bodies[0] : solid.body).children.push(node);
  }
  for (const node of nodes.values()) if (!node.children.length) delete node.children;
  if (animation.channels.length) json.animations = [animation];
  return file.bytes();
}
