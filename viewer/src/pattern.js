// SPDX-License-Identifier: Apache-2.0
// Contact pattern: maximum load up to the current time at each point of a flank, painted on the teeth.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial } from "three";
import { reached } from "./contacts.js";
import { litColour } from "./load_colours.js";

const modulo = (a, n) => ((a % n) + n) % n;
const SAME = 1.004; // smaller relative increases do not change the colour

/**
 * Maximum loads on a grid over a flank, for all teeth combined and for each tooth, accumulated over the
 * frames.
 */
class Record {
  /** @param {any} contact @param {any} flank */
  constructor(contact, flank) {
    this.contact = contact;
    this.flank = flank;
    [this.nz, this.nx] = flank.surfaces[0].points.shape;
    this.frames = flank.travel.count;
    this.clear();
  }

  clear() {
    const { nz, nx, flank } = this;
    this.done = -1;
    /** Loaded teeth in the order of their first load, and changes since the last painting. */
    this.touched = flank.surfaces.map(() => []);
    this.news = { all: true, teeth: flank.surfaces.map(() => new Set()) };
    this.all = new Float32Array(nz * nx);
    this.each = flank.surfaces.map((surface) => new Float32Array(surface.teeth * nz * nx));
  }

  /** Include all frames up to a given one. @param {number} frame */
  upTo(frame) {
    if (frame < this.done) this.clear();
    while (this.done < frame) {
      this.done++;
      this.#sweep(Math.max(0, this.done - 1), this.done);
    }
  }

  /** Load at a position along the face width on the contact line of a tooth pair, null outside the line. */
  #load(row, line, z) {
    const { flank } = this;
    if (!line || z < line.from || z > line.to) return null;
    const count = flank.loads.shape[2];
    const at = row * flank.loads.width + modulo(line.pair, flank.forces.width) * count;
    const x = line.to > line.from ? ((z - line.from) / (line.to - line.from)) * (count - 1) : 0;
    const k = Math.min(Math.floor(x), count - 2);
    const [a, b] = [flank.loads.data[at + k], flank.loads.data[at + k + 1]];
    return a + (x - k) * (b - a);
  }

  /** Lines are swept linearly from frame to frame, unless the travel in between approaches a base pitch. */
  #sweep(before, now) {
    const { contact, flank, nz, nx } = this;
    const [start, end] = contact.path,
      [low, high] = contact.width;
    const step = (end - start) / (nx - 1);
    const travel = flank.travel.data;
    const whole = Math.abs(travel[now] - travel[before]) > 0.75 * contact.base_pitch;
    const lines = whole ? [] : reached(contact, flank, travel[before]);
    for (const line of reached(contact, flank, travel[now])) {
      const { pair, slope } = line;
      const was = lines.find((one) => one.pair === pair);
      for (let j = 0; j < nz; j++) {
        const z = low + ((high - low) * j) / (nz - 1);
        const after = this.#load(now, line, z);
        if (after === null) continue;
        const earlier = this.#load(before, was, z);
        const to = travel[now] - pair * contact.base_pitch + slope * z;
        const from = earlier === null ? to : travel[before] - pair * contact.base_pitch + slope * z;
        const first = Math.max(0, Math.ceil((Math.min(from, to) - start) / step - 0.5));
        const last = Math.min(nx - 1, Math.floor((Math.max(from, to) - start) / step + 0.5));
        for (let k = first; k <= last; k++) {
          const share =
            from === to ? 1 : Math.max(0, Math.min(1, (start + k * step - from) / (to - from)));
          this.#put(pair, j * nx + k, (earlier ?? after) * (1 - share) + after * share);
        }
      }
    }
  }

  #put(pair, at, load) {
    if (!(load > 0)) return;
    if (load > SAME * this.all[at]) {
      this.all[at] = load;
      this.news.all = true;
    }
    this.flank.surfaces.forEach((surface, g) => {
      const tooth = modulo(surface.tooth + surface.step * pair, surface.teeth);
      const place = tooth * this.nz * this.nx + at;
      if (!(load > SAME * this.each[g][place])) return;
      this.each[g][place] = load;
      this.news.teeth[g].add(tooth);
      if (!this.touched[g].includes(tooth)) this.touched[g].push(tooth);
    });
  }
}

export class Pattern {
  /**
   * @param {import("./contacts.js").Contact} contact
   * @param {import("three").Group} root
   * @param {import("./poses.js").Poses} poses
   */
  constructor(contact, root, poses) {
    this.poses = poses;
    this.greatest = contact.greatest;
    this.mode = "off";
    this.parts = contact.contact.flanks
      .filter((flank) => flank.loads)
      .map((flank) => {
        const record = new Record(contact.contact, flank);
        return { record, meshes: flank.surfaces.map((surface, g) => this.#teeth(record, surface, g, root)) };
      });
  }

  /** Mesh of the flanks of all teeth of a gear, initially transparent. */
  #teeth(record, surface, g, root) {
    const { nz, nx } = record;
    const each = nz * nx;
    const position = new Float32Array(3 * each * surface.teeth);
    for (let tooth = 0; tooth < surface.teeth; tooth++) {
      // Tooth numbers increase with the pair number on one gear and decrease on the other.
      const angle = surface.turn * surface.step * (tooth - surface.tooth);
      const c = Math.cos(angle),
        s = Math.sin(angle);
      for (let k = 0; k < each; k++) {
        const [x, y, z] = surface.points.data.subarray(3 * k, 3 * k + 3);
        position.set([c * x - s * y, s * x + c * y, z], 3 * (tooth * each + k));
      }
    }
    // Triangles of one tooth; only loaded teeth are drawn.
    const block = [];
    for (let j = 0; j < nz - 1; j++)
      for (let k = 0; k < nx - 1; k++) {
        const a = j * nx + k;
        block.push(a, a + 1, a + nx, a + 1, a + nx + 1, a + nx);
      }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(position, 3));
    geometry.setAttribute("color", new BufferAttribute(new Uint8Array(4 * each * surface.teeth), 4, true));
    geometry.setIndex(new BufferAttribute(new Uint32Array(block.length * surface.teeth), 1));
    geometry.setDrawRange(0, 0);
    const mesh = new Mesh(
      geometry,
      new MeshBasicMaterial({
        vertexColors: true,
        transparent: true,
        side: DoubleSide,
        depthWrite: false,
        polygonOffset: true,
        polygonOffsetFactor: -2,
        polygonOffsetUnits: -40,
      }),
    );
    mesh.matrixAutoUpdate = false;
    mesh.frustumCulled = false;
    mesh.visible = false;
    mesh.userData = { body: surface.body, gear: g, block, drawn: 0 };
    root.add(mesh);
    return mesh;
  }

  /**
   * @param {"off"|"all"|"each"} mode
   * @param {boolean} hidden
   * @param {number} greatest upper end of the colour scale
   * @param {any} shade entry of SHADES
   */
  update(mode, hidden, greatest, shade) {
    const frame = this.poses.where.share === 1 ? this.poses.where.low + 1 : this.poses.where.low;
    for (const { record, meshes } of this.parts) {
      const on = mode !== "off" && !hidden;
      for (const mesh of meshes) {
        mesh.visible = on;
        if (on) mesh.matrix.copy(this.poses.world[mesh.userData.body]);
      }
      if (!on) continue;
      record.upTo(frame);
      const anew = mode !== this.mode || greatest !== this.painted || shade !== this.shade;
      this.shade = shade;
      for (const mesh of meshes) this.#paint(record, mesh, mode, greatest, anew);
      record.news = { all: false, teeth: record.news.teeth.map(() => new Set()) };
    }
    this.mode = hidden ? "off" : mode;
    this.painted = greatest;
  }

  /** Update the colours of changed teeth. A change of the superimposed pattern affects all teeth. */
  #paint(record, mesh, mode, greatest, anew) {
    const { gear, block } = mesh.userData;
    const each = record.nz * record.nx;
    const touched = record.touched[gear];
    this.#draw(mesh, touched, block, each);
    const whole = anew || (mode === "all" && record.news.all);
    const teeth = whole ? touched : record.news.teeth[gear];
    const { color } = mesh.geometry.attributes;
    for (const tooth of teeth) {
      for (let k = 0; k < each; k++) {
        const load = mode === "all" ? record.all[k] : record.each[gear][tooth * each + k];
        const at = 4 * (tooth * each + k);
        const paint = load > 0 ? litColour(this.#value(record, k, load) / greatest) : NONE;
        for (let c = 0; c < 3; c++) color.array[at + c] = Math.round(255 * paint[c]);
        color.array[at + 3] = load > 0 ? 255 : 0;
      }
      color.needsUpdate = true;
    }
  }

  /** Quantity shown by the colours for a load at a grid point. */
  #value({ contact, nx, nz }, k, load) {
    const [start, end] = contact.path,
      [low, high] = contact.width;
    const at = [start + ((end - start) * (k % nx)) / (nx - 1), low + ((high - low) * Math.floor(k / nx)) / (nz - 1)];
    return this.shade.of(contact, at, load);
  }

  /** Extend the drawn triangles to all loaded teeth. */
  #draw(mesh, touched, block, each) {
    const { geometry, userData } = mesh;
    if (touched.length < userData.drawn) userData.drawn = 0;
    if (touched.length === userData.drawn) return;
    const { array } = geometry.index;
    for (let k = userData.drawn; k < touched.length; k++)
      block.forEach((corner, n) => (array[k * block.length + n] = touched[k] * each + corner));
    userData.drawn = touched.length;
    geometry.index.needsUpdate = true;
    geometry.setDrawRange(0, touched.length * block.length);
  }

  /** @param {import("three").Plane[]} planes */
  cut(planes) {
    for (const { meshes } of this.parts)
      for (const { material } of meshes) {
        material.clippingPlanes = planes.length ? planes : null;
        material.needsUpdate = true;
      }
  }

  /** State for tests: maximum load, covered fraction of the flank, and loaded teeth. */
  words() {
    return this.parts.map(({ record }) => ({
      side: record.flank.side,
      greatest: record.all.reduce((most, x) => Math.max(most, x), 0),
      covered: record.all.filter((x) => x > 0).length / record.all.length,
      teeth: record.touched.map((teeth) => [...teeth].sort((a, b) => a - b)),
    }));
  }
}

const NONE = [0, 0, 0];
