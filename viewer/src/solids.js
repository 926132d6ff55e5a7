// SPDX-License-Identifier: Apache-2.0
// Solids as separate meshes, or as one or two batches if there are hundreds.
import { Color, DoubleSide, FrontSide, Matrix4, Mesh, MeshLambertMaterial, Vector3 } from "three";
import { FAULT, colourOfPart } from "./colours.js";
import { Batch } from "./batch.js";
import { creaseNormals } from "./crease_normals.js";
import { directions, extremes } from "./extremes.js";
import { Repeated, geometryOf } from "./repeated.js";
import { Blend } from "./blend.js";
import { ModalShape } from "./modal_shape.js";

// With more solids, one draw call per solid dominates the drawing time.
const MOST_MESHES = 300;

// Covers larger than this factor times their contents are not included in the fitted view.
const LARGE_COVER = 2.5;

// Pose of hidden members of a batch: triangles without area are not drawn.
const NOWHERE = new Matrix4().multiplyScalar(0);

function material(colour, seeThrough) {
  const made = new MeshLambertMaterial({ color: colour });
  if (seeThrough) Object.assign(made, { transparent: true, opacity: 0.22, depthWrite: false });
  return made;
}

/** Kinds of parts on which the forces of a scene act. */
const DRIVE = new Set(["gear", "bearing", "element"]);

export class Solids {
  /**
   * @param {any} scene result of readScene
   * @param {import("three").Group} root
   * @param {import("./poses.js").Poses} poses
   */
  constructor(scene, root, poses) {
    this.solids = scene.solids;
    this.root = root;
    this.poses = poses;
    this.known = new Map();
    const orders = {};
    this.parts = scene.solids.map((solid) => {
      const order = (orders[solid.kind] = (orders[solid.kind] ?? -1) + 1);
      const part = { solid, colour: colourOfPart(solid.kind, order, solid.schematic) };
      if (solid.pieces) {
        part.repeated = new Repeated(part, (fault) => this.#material(part, fault, "repeated"));
        part.geometry = part.repeated.whole("coarse");
      } else {
        const surface = creaseNormals(solid.points.data, solid.triangles.data, solid.creases ?? 40);
        part.geometry = geometryOf(surface);
        part.blend = solid.blend ? new Blend(solid.blend, part.geometry, surface.source, poses) : null;
        part.modal = solid.modal ? new ModalShape(solid, part.geometry, surface.source, poses) : null;
      }
      const points = part.geometry.attributes.position.array;
      return Object.assign(part, { radius: reach(points), rim: rim(points) });
    });
    this.triangles = this.parts.reduce(
      (sum, part) => sum + (part.repeated?.finest ?? part.geometry.index.count / 3),
      0,
    );
    this.meshes = [];
    this.batches = [];
    if (this.parts.length > MOST_MESHES) this.#batches();
    else this.#meshes();
    this.update(0);
  }

  /** One material for all parts of the same appearance. */
  #material({ colour, solid }, fault = "", how = "") {
    const key = [colour, Boolean(solid.see_through), Boolean(fault), how].join();
    if (!this.known.has(key)) {
      const paint = fault ? new Color(colour).lerp(new Color(FAULT), 0.55) : colour;
      this.known.set(key, material(paint, solid.see_through));
    }
    return this.known.get(key);
  }

  get materials() {
    return [...this.known.values()];
  }

  #meshes() {
    for (const part of this.parts) {
      const mesh = part.repeated ?? new Mesh(part.geometry, this.#material(part));
      mesh.matrixAutoUpdate = false;
      mesh.renderOrder = part.solid.see_through ? 1 : 0;
      mesh.userData.part = part;
      part.mesh = mesh;
      this.meshes.push(...(part.repeated?.meshes ?? [mesh]));
      this.root.add(mesh);
    }
  }

  #batches() {
    for (const seeThrough of [false, true]) {
      const parts = this.parts.filter((part) => Boolean(part.solid.see_through) === seeThrough);
      if (!parts.length) continue;
      const shared = material("#ffffff", seeThrough);
      const batch = new Batch(parts, shared);
      // Batches have a single level of detail.
      parts.forEach((part, k) => Object.assign(part, { batch, member: k, repeated: null }));
      batch.renderOrder = seeThrough ? 1 : 0;
      this.known.set(`batch ${seeThrough}`, shared);
      this.batches.push(batch);
      this.root.add(batch);
    }
  }

  /** Update the poses of all solids. @param {number} visible smaller lengths are not visible [m] */
  update(visible) {
    for (const part of this.parts) {
      const matrix = this.poses.ofSolid(part.solid);
      const bent = [part.blend?.update(visible, part.radius), part.modal?.update()].some(Boolean);
      if (!part.batch) part.mesh.matrix.copy(matrix);
      else {
        part.batch.place(part.member, this.shows(part) ? matrix : NOWHERE);
        if (bent) part.batch.bend(part.member);
      }
    }
  }

  /**
   * Choose the level of detail of gears.
   * @param {import("three").Matrix4} seen
   * @param {import("three").PerspectiveCamera} camera
   * @param {number} pixel
   */
  choose(seen, camera, pixel) {
    for (const { repeated } of this.parts) repeated?.choose(seen, camera, pixel);
  }

  /**
   * Parts for files; the level of detail of gears limits the file size.
   * @param {boolean} inBodies in the frames of the bodies instead of the solids
   */
  exported(inBodies) {
    return this.parts.filter((part) => this.shows(part)).map((part) => {
      const geometry = part.repeated ? part.repeated.whole("fine") : part.geometry;
      const { solid } = part;
      if (!inBodies || !(solid.place || solid.axes || solid.between)) return { ...part, geometry };
      // A solid stretched between two bodies is fixed to the first one in its current shape.
      const matrix = this.poses.ofSolid(solid).clone();
      const body = solid.between ? solid.between.bodies[0] : solid.body;
      if (body >= 0) matrix.premultiply(this.poses.world[body].clone().invert());
      return { ...part, solid: { ...solid, body }, geometry: geometry.clone().applyMatrix4(matrix) };
    });
  }

  /** Number of triangles currently drawn. */
  get drawn() {
    return this.parts.reduce(
      (sum, part) =>
        sum + (part.repeated?.drawn ?? (this.shows(part) ? part.geometry.index.count / 3 : 0)),
      0,
    );
  }

  /**
   * Set section planes in the camera's world; none for a view without section.
   * @param {import("three").Plane[]} planes
   */
  cut(planes) {
    for (const each of this.materials) {
      each.clippingPlanes = planes.length ? planes : null;
      each.side = planes.length ? DoubleSide : FrontSide;
      each.needsUpdate = true;
    }
  }

  /** Appearance of housing and other covers. @param {"see-through"|"solid"|"hidden"} how */
  cover(how) {
    const done = new Set();
    for (const part of this.parts) {
      if (!part.solid.see_through) continue;
      part.hidden = how === "hidden";
      this.#visible(part);
      const drawn = part.batch?.material ?? part.mesh.material;
      if (done.has(drawn)) continue;
      done.add(drawn);
      Object.assign(
        drawn,
        how === "solid"
          ? { transparent: false, opacity: 1, depthWrite: true }
          : { transparent: true, opacity: 0.22, depthWrite: false },
      );
      drawn.needsUpdate = true;
    }
  }

  /** Show or hide schematic parts. @param {boolean} on */
  schematics(on) {
    this.plain = !on;
    for (const part of this.parts) if (part.solid.schematic) this.#visible(part);
  }

  shows(part) {
    return !part.hidden && !(this.plain && part.solid.schematic);
  }

  /** Members of a batch become visible with the next update of their poses. */
  #visible(part) {
    if (part.mesh) part.mesh.visible = this.shows(part);
  }

  /**
   * First part hit by a ray; covers count only if nothing else is hit.
   * @param {import("three").Raycaster} ray
   */
  hit(ray) {
    const hits = ray.intersectObjects(
      [...this.meshes, ...this.batches].filter((object) => object.visible),
      false,
    );
    const found = hits
      .map(({ object, member, point }) => ({
        part: object.userData.part ?? object.parts[member],
        fault: object.userData.fault ?? "",
        point,
      }))
      .filter(({ part }) => this.shows(part));
    return (
      found.find(({ part, point }) => !part.solid.see_through && this.#kept(point)) ??
      found.find(({ point }) => this.#kept(point)) ??
      null
    );
  }

  #kept(point) {
    return !this.materials[0]?.clippingPlanes?.some((plane) => plane.distanceToPoint(point) < 0);
  }

  /**
   * Bounds at rest for fitting the view: all solids, without covers that are much larger than their contents.
   * `size` is the radius of the contents, `whole` the bounds of all solids.
   */
  bounds() {
    const open = this.parts.filter(({ solid }) => !solid.see_through || solid.schematic);
    const whole = this.#around(this.parts);
    const held = open.length && open.length < this.parts.length ? this.#around(open) : whole;
    const fits = whole.radius < LARGE_COVER * held.radius ? whole : held;
    const drive = this.parts.filter(({ solid }) => DRIVE.has(solid.kind) && !solid.schematic);
    return { ...fits, size: held.radius, whole, drive: drive.length ? this.#around(drive).radius : held.radius };
  }

  /** @param {any[]} parts */
  #around(parts) {
    const low = new Vector3(Infinity, Infinity, Infinity),
      high = low.clone().negate();
    const point = new Vector3();
    /** Extreme points of each solid for fitting the view. */
    const outline = [];
    const ways = directions(this.parts.length > MOST_MESHES ? 6 : 64);
    for (const part of parts) {
      const matrix = this.poses.ofSolid(part.solid);
      const { center, radius } = part.geometry.boundingSphere;
      part.geometry.computeBoundingBox();
      const { min, max } = part.geometry.boundingBox;
      if (!(radius >= 0)) continue;
      part.reaches ??= extremes(part.geometry.attributes.position, ways);
      for (const at of part.reaches) outline.push(at.clone().applyMatrix4(matrix));
      for (let corner = 0; corner < 8; corner++) {
        point.set(corner & 1 ? max.x : min.x, corner & 2 ? max.y : min.y, corner & 4 ? max.z : min.z);
        // Corners of the bounding box of a round body lie outside the body; they are moved to its bounding
        // sphere.
        point.sub(center).clampLength(0, radius).add(center).applyMatrix4(matrix);
        low.min(point);
        high.max(point);
      }
    }
    if (!(high.x >= low.x))
      return {
        centre: point.set(0, 0, 0),
        radius: 1,
        low: point.clone().set(-1, -1, -1),
        high: point.clone().set(1, 1, 1),
        outline,
      };
    return {
      centre: low.clone().add(high).multiplyScalar(0.5),
      radius: Math.max(low.distanceTo(high) / 2, 1e-9),
      low,
      high,
      outline,
    };
  }

  /** Maximum distance of the points of a body from its origin [m]. @param {number} body */
  reachOf(body) {
    return Math.max(0, ...this.parts.filter((part) => part.solid.body === body).map((part) => part.radius));
  }
}

/** Maximum distance from the third axis. @param {Float32Array} points */
function rim(points) {
  let most = 0;
  for (let k = 0; k < points.length; k += 3) most = Math.max(most, Math.hypot(points[k], points[k + 1]));
  return most;
}

/** Maximum distance from the origin. @param {Float32Array} points */
function reach(points) {
  let most = 0;
  for (let k = 0; k < points.length; k += 3)
    most = Math.max(most, Math.hypot(points[k], points[k + 1], points[k + 2]));
  return most;
}
