// SPDX-License-Identifier: Apache-2.0
// Solids as meshes: one mesh each, or one or two crowds where there are hundreds of them.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  FrontSide,
  Mesh,
  MeshLambertMaterial,
  Vector3,
} from "three";
import { colourOfPart } from "./colours.js";
import { Crowd } from "./crowd.js";
import { creaseNormals } from "./crease_normals.js";
import { Skin } from "./skin.js";

// Beyond this, a draw call for each solid costs more than what it draws.
const MOST_MESHES = 300;

/** Back faces seen through a cut are the cut: flat, hatched, whatever the light. */
function drawCut(material) {
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace(
      "#include <opaque_fragment>",
      `#ifdef DOUBLE_SIDED
        if (!gl_FrontFacing) {
          float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0);
          outgoingLight = diffuseColor.rgb * (stripe < 1.1 ? 0.66 : 0.86);
        }
      #endif
      #include <opaque_fragment>`,
    );
  };
}

function material(colour, seeThrough) {
  const made = new MeshLambertMaterial({ color: colour });
  if (seeThrough) Object.assign(made, { transparent: true, opacity: 0.22, depthWrite: false });
  drawCut(made);
  return made;
}

export class Solids {
  /**
   * @param {any} scene as readScene gives it
   * @param {import("three").Group} root
   * @param {import("./poses.js").Poses} poses
   */
  constructor(scene, root, poses) {
    this.solids = scene.solids;
    this.root = root;
    this.poses = poses;
    const orders = {};
    this.parts = scene.solids.map((solid) => {
      const order = (orders[solid.kind] = (orders[solid.kind] ?? -1) + 1);
      const { points, normals, index, source } = creaseNormals(
        solid.points.data,
        solid.triangles.data,
        solid.creases ?? 40,
      );
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(points, 3));
      geometry.setAttribute("normal", new BufferAttribute(normals, 3));
      geometry.setIndex(
        points.length / 3 < 65536
          ? new BufferAttribute(Uint16Array.from(index), 1)
          : new BufferAttribute(index, 1),
      );
      geometry.computeBoundingSphere();
      const skin = solid.skin ? new Skin(solid.skin, geometry, source, poses) : null;
      return {
        solid,
        geometry,
        skin,
        colour: colourOfPart(solid.kind, order),
        radius: reach(points),
        rim: rim(points),
      };
    });
    this.triangles = scene.solids.reduce((sum, solid) => sum + solid.triangles.count, 0);
    this.materials = [];
    this.meshes = [];
    this.crowds = [];
    if (this.parts.length > MOST_MESHES) this.#crowds();
    else this.#meshes();
    this.update(0);
  }

  #meshes() {
    const known = new Map();
    for (const part of this.parts) {
      const key = part.colour + Boolean(part.solid.see_through);
      if (!known.has(key)) known.set(key, material(part.colour, part.solid.see_through));
      const mesh = new Mesh(part.geometry, known.get(key));
      mesh.matrixAutoUpdate = false;
      mesh.renderOrder = part.solid.see_through ? 1 : 0;
      mesh.userData.part = part;
      part.mesh = mesh;
      this.meshes.push(mesh);
      this.root.add(mesh);
    }
    this.materials = [...known.values()];
  }

  #crowds() {
    for (const seeThrough of [false, true]) {
      const parts = this.parts.filter((part) => Boolean(part.solid.see_through) === seeThrough);
      if (!parts.length) continue;
      const shared = material("#ffffff", seeThrough);
      const crowd = new Crowd(parts, shared);
      parts.forEach((part, k) => Object.assign(part, { crowd, member: k, skin: null })); // a crowd does not bend
      crowd.renderOrder = seeThrough ? 1 : 0;
      this.materials.push(shared);
      this.crowds.push(crowd);
      this.root.add(crowd);
    }
  }

  /** Places of all solids from the poses. @param {number} visible lengths below this are not seen [m] */
  update(visible) {
    for (const part of this.parts) {
      const matrix = this.poses.ofSolid(part.solid);
      if (part.crowd) part.crowd.place(part.member, matrix);
      else part.mesh.matrix.copy(matrix);
      part.skin?.update(visible, part.radius);
    }
  }

  /** Cut by planes of the camera's world, or whole. @param {import("three").Plane[]} planes */
  cut(planes) {
    for (const each of this.materials) {
      each.clippingPlanes = planes.length ? planes : null;
      each.side = planes.length ? DoubleSide : FrontSide;
      each.needsUpdate = true;
    }
  }

  /** Housing and other covers: see-through, solid or hidden. @param {"see-through"|"solid"|"hidden"} how */
  cover(how) {
    const done = new Set();
    for (const part of this.parts) {
      if (!part.solid.see_through) continue;
      if (part.crowd) part.crowd.visible = how !== "hidden";
      else part.mesh.visible = how !== "hidden";
      const drawn = part.crowd?.material ?? part.mesh.material;
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

  /** What a ray meets first, covers last. @param {import("three").Raycaster} ray */
  hit(ray) {
    const hits = ray.intersectObjects([...this.meshes, ...this.crowds].filter((object) => object.visible));
    const found = hits.map(({ object, member, point }) => ({
      part: object.userData.part ?? object.parts[member],
      point,
    }));
    return (
      found.find(({ part, point }) => !part.solid.see_through && this.#kept(point)) ??
      found.find(({ point }) => this.#kept(point)) ??
      null
    );
  }

  #kept(point) {
    return !this.materials[0]?.clippingPlanes?.some((plane) => plane.distanceToPoint(point) < 0);
  }

  /** Centre and radius of all solids at rest, without covers where there is anything else. */
  bounds() {
    const open = this.parts.filter((part) => !part.solid.see_through);
    const low = new Vector3(Infinity, Infinity, Infinity),
      high = low.clone().negate();
    const point = new Vector3();
    /** some points of every solid, from which a view is fitted */
    const outline = [];
    for (const part of open.length ? open : this.parts) {
      const matrix = this.poses.ofSolid(part.solid);
      const { center, radius } = part.geometry.boundingSphere;
      part.geometry.computeBoundingBox();
      const { min, max } = part.geometry.boundingBox;
      if (!(radius >= 0)) continue;
      const points = part.geometry.attributes.position;
      const step = Math.max(1, Math.ceil(points.count / (this.parts.length > MOST_MESHES ? 4 : 80)));
      for (let k = 0; k < points.count; k += step)
        outline.push(new Vector3().fromBufferAttribute(points, k).applyMatrix4(matrix));
      for (let corner = 0; corner < 8; corner++) {
        point.set(corner & 1 ? max.x : min.x, corner & 2 ? max.y : min.y, corner & 4 ? max.z : min.z);
        // a corner of a box reaches further than a round body does
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

  /** Largest distance of a point of a body from its origin [m]. @param {number} body */
  reachOf(body) {
    return Math.max(0, ...this.parts.filter((part) => part.solid.body === body).map((part) => part.radius));
  }
}

/** Largest distance from the third axis. @param {Float32Array} points */
function rim(points) {
  let most = 0;
  for (let k = 0; k < points.length; k += 3) most = Math.max(most, Math.hypot(points[k], points[k + 1]));
  return most;
}

/** Largest distance from the origin. @param {Float32Array} points */
function reach(points) {
  let most = 0;
  for (let k = 0; k < points.length; k += 3)
    most = Math.max(most, Math.hypot(points[k], points[k + 1], points[k + 2]));
  return most;
}
