// SPDX-License-Identifier: Apache-2.0
// The canvas: one viewport (Picture) per result, side by side, with a common viewing direction. Drawn on
// request only.
import {
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Matrix4,
  Raycaster,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { Arrows } from "./arrows.js";
import { Camera } from "./camera.js";
import { Caps } from "./caps.js";
import { Flanks } from "./flanks.js";
import { Poses } from "./poses.js";
import { Solids } from "./solids.js";

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** Renderer type, or null if WebGL 2 is not available. @returns {{software: boolean}|null} */
export function graphics() {
  try {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) return null;
    const info = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return { software: SOFTWARE.test(name) };
  } catch {
    return null;
  }
}

/** Width of a picture on paper [pixels]. */
const PAPER = 1400;

/** Limits of size ratio and relative distance within which results count as variants of one machine. */
const ALIKE = { size: 1.5, away: 0.5 };

class Picture {
  /** @param {any} data one scene @param {Element} element @param {Camera} camera */
  constructor(data, element, camera) {
    this.data = data;
    this.camera = camera;
    /**
     * Transformation from the scene to the camera's world: to follow a body, the scene moves instead of the
     * camera.
     */
    this.seen = new Matrix4();
    /**
     * Size of the viewed object relative to the first viewport, and the point that corresponds to `centre` of
     * the first viewport.
     */
    this.factor = 1;
    this.centre = new Vector3();
    this.scene = new Scene();
    this.over = new Scene();
    this.root = new Group();
    this.overRoot = new Group();
    this.root.matrixAutoUpdate = this.overRoot.matrixAutoUpdate = false;
    this.scene.add(this.root);
    this.over.add(this.overRoot);
    this.lights = [this.scene, this.over].map((scene) => {
      const light = new DirectionalLight("#ffffff", 2.1);
      const sky = new HemisphereLight("#ffffff", "#8f98a3", 1.25);
      scene.add(light, light.target, sky);
      return { light, sky };
    });
    this.poses = new Poses(data);
    this.solids = new Solids(data, this.root, this.poses);
    this.bounds = this.solids.bounds();
    this.caps = new Caps(this.solids, this.bounds);
    this.flanks = new Flanks(data, this.root, this.overRoot, this.poses);
    this.arrows = new Arrows({ arrows: [...data.arrows, ...this.flanks.pairs()] }, this.overRoot, this.poses, element, this.bounds.size);
  }
}

/** Largest radius of a scene, relative to its gears and bearings, whose arrows are larger with it. */
const AROUND = 3;

export class Stage {
  /**
   * @param {HTMLElement} host @param {any[]} scenes @param {boolean} software
   */
  constructor(host, scenes, software) {
    this.host = host;
    this.software = software;
    // Antialiasing slows a software renderer from 12 to 3 frames per second.
    this.renderer = new WebGLRenderer({ antialias: !software, stencil: true, powerPreference: "high-performance" });
    this.renderer.autoClear = false;
    this.renderer.localClippingEnabled = true;
    this.canvas = this.renderer.domElement;
    this.canvas.className = "ppv-canvas";
    host.append(this.canvas);
    this.camera = new Camera(28, 1, 0.01, 100);
    this.pictures = scenes.map((scene, k) => new Picture(scene, host, k ? this.camera.clone() : this.camera));
    this.alike = alike(this.pictures);
    const [{ bounds }] = this.pictures;
    this.meet(this.pictures.map(() => new Vector3()), this.pictures.map((picture) => picture.bounds.size));
    // Results that are compared have a common scale of arrows and colours.
    const size = Math.max(...this.pictures.map((picture) => picture.arrows.size));
    const reach = ({ size: whole, drive }) => Math.min(whole, AROUND * drive);
    const radius = this.alike ? Math.max(...this.pictures.map((picture) => reach(picture.bounds))) : reach(bounds);
    const greatest = Math.max(...this.pictures.map((picture) => picture.flanks.greatest));
    for (const { arrows, flanks, factor } of this.pictures) {
      Object.assign(arrows, { size, radius: factor * radius });
      flanks.greatest = greatest;
    }
    this.background = new Color("#ffffff");
    this.size = { width: 1, height: 1 };
    this.drawn = 0;
    this.coarse = false;
    this.large = false;
    /** Offset of the camera target to the left of the centre, as a fraction of the viewport width. */
    this.shift = 0;
    /** Offset of the camera target below the centre, as a fraction of the height. */
    this.drop = 0;
  }

  /**
   * Reduce the resolution during motion if drawing is slow.
   * @param {boolean} on
   * @returns {boolean} whether it has changed
   */
  coarsen(on) {
    if (on === this.coarse) return false;
    this.coarse = on;
    this.resize();
    return true;
  }

  /** Draw with the resolution of paper, or of the window. @param {boolean} on */
  enlarge(on) {
    this.large = on;
    this.resize();
  }

  get ratio() {
    if (this.large) return Math.min(Math.max(PAPER / this.size.width, 1), 4);
    if (this.coarse) return 0.6;
    return this.software ? 1 : Math.min(window.devicePixelRatio || 1, 2);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height) return;
    this.size = { width, height };
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height);
    for (const { camera } of this.pictures) {
      camera.aspect = width / this.pictures.length / height;
      camera.updateProjectionMatrix();
    }
  }

  get parallel() {
    return this.camera.parallel;
  }

  /** Parallel instead of central projection. @param {boolean} on */
  set parallel(on) {
    for (const { camera } of this.pictures) camera.parallel = on;
  }

  /** Bounds of all viewports that share a target; the centre is in the camera's world. */
  bounds() {
    const each = (this.alike ? this.pictures : this.pictures.slice(0, 1)).map(({ bounds }) => bounds);
    const low = each.reduce((sum, part) => sum.min(part.low), each[0].low.clone());
    const high = each.reduce((sum, part) => sum.max(part.high), each[0].high.clone());
    const centre = low.clone().add(high).multiplyScalar(0.5);
    const radius = Math.max(...each.map((part) => part.centre.distanceTo(centre) + part.radius));
    return { centre: centre.applyMatrix4(this.pictures[0].seen), radius, low, high };
  }

  /**
   * Point of a viewport that corresponds to a point of the first viewport, in the camera's world.
   * @param {any} picture
   * @param {Vector3} point
   */
  targetOf(picture, point) {
    const [first] = this.pictures;
    return picture.centre.clone().addScaledVector(point.clone().sub(first.centre), picture.factor);
  }

  /**
   * Align the viewports: the given points appear at the same position. For different machines, the sizes set
   * the relative zoom.
   * @param {Vector3[]} points one per viewport, in the camera's world
   * @param {number[]} [sizes]
   */
  meet(points, sizes) {
    this.pictures.forEach((picture, k) => {
      picture.centre.copy(points[k]);
      if (sizes && !this.alike) picture.factor = sizes[k] / sizes[0];
    });
  }

  /**
   * Place the camera of a viewport; its distance is proportional to the size of the viewed object.
   * @param {any} picture
   * @param {import("./orbit.js").Orbit} orbit
   */
  #aim(picture, orbit) {
    const { camera, seen, factor } = picture;
    const { whole } = picture.bounds;
    const distance = factor * orbit.now.distance,
      target = this.targetOf(picture, orbit.now.target);
    if (camera !== this.camera) {
      camera.position.copy(target).addScaledVector(orbit.direction(), distance);
      camera.quaternion.copy(this.camera.quaternion);
    }
    const away = target.distanceTo(whole.centre.clone().applyMatrix4(seen));
    camera.distance = distance;
    // In parallel projection, parts behind the camera are visible too.
    camera.near = Math.max(camera.parallel ? -Infinity : 0.01 * distance, distance - away - 1.3 * whole.radius);
    camera.far = distance + away + 2.5 * whole.radius;
    const part = this.size.width / this.pictures.length;
    camera.setViewOffset(part, this.size.height, this.shift * part, -this.drop * this.size.height, part, this.size.height);
    camera.updateMatrixWorld();
  }

  /** @param {import("./orbit.js").Orbit} orbit */
  render(orbit) {
    const { renderer } = this;
    this.setLights();
    renderer.setScissorTest(true);
    const width = this.size.width / this.pictures.length;
    // Size of a drawn pixel at unit distance. Software renderers use a coarser level of detail.
    const drawn = this.size.height * Math.min(1, this.ratio);
    const pixel = ((this.software ? 2.5 : 1) * 2 * Math.tan((this.camera.fov * Math.PI) / 360)) / drawn;
    this.pictures.forEach((picture, k) => {
      const { camera, seen } = picture;
      this.#aim(picture, orbit);
      renderer.setViewport(k * width, 0, width, this.size.height);
      renderer.setScissor(k * width, 0, width, this.size.height);
      renderer.setClearColor(this.background, 1);
      renderer.clear();
      picture.root.matrix.copy(seen);
      picture.overRoot.matrix.copy(seen);
      picture.solids.choose(seen, camera, pixel);
      renderer.render(picture.scene, camera);
      if (this.section?.on) {
        const size = (2 * camera.distance * Math.tan((camera.fov * Math.PI) / 360)) / this.size.height;
        picture.caps.render(renderer, camera, this.section.planes[k], seen, size, {
          left: k * width,
          width,
          height: this.size.height,
        });
      }
      if ((picture.arrows.hidden || !picture.arrows.shown.size) && !picture.flanks.over) return;
      renderer.clearDepth();
      renderer.render(picture.over, camera);
    });
    this.drawn++;
  }

  setLights() {
    const light = new Vector3(-0.45, 0.7, 0.9).applyQuaternion(this.camera.quaternion);
    const above = new Vector3(0, 1, 0).applyQuaternion(this.camera.quaternion);
    for (const picture of this.pictures) {
      for (const each of picture.lights) {
        each.light.position.copy(light);
        each.sky.position.copy(above);
      }
    }
  }

  /** Part at a point of the window. @param {number} x @param {number} y */
  hit(x, y) {
    const box = this.canvas.getBoundingClientRect();
    const width = box.width / this.pictures.length;
    const k = Math.floor((x - box.left) / width);
    const picture = this.pictures[k];
    if (!picture) return null;
    const at = new Vector2(
      ((x - box.left - k * width) / width) * 2 - 1,
      1 - ((y - box.top) / box.height) * 2,
    );
    const ray = new Raycaster();
    ray.setFromCamera(at, picture.camera);
    if (picture.camera.parallel) ray.ray.origin.addScaledVector(ray.ray.direction, Math.min(0, picture.camera.near));
    const found = picture.solids.hit(ray);
    return found && { ...found, picture: k };
  }

  /** Window position of a point of the scene. @param {Vector3} point @param {number} picture */
  onScreen(point, picture = 0) {
    const { seen, camera } = this.pictures[picture];
    const p = point.clone().applyMatrix4(seen).project(camera);
    const width = this.size.width / this.pictures.length;
    return { x: (picture + (p.x + 1) / 2) * width, y: ((1 - p.y) / 2) * this.size.height, front: p.z < 1 };
  }
}

/** Whether all viewports can share a camera: similar size and position. @param {any[]} pictures */
function alike(pictures) {
  const [{ bounds: first }] = pictures;
  return pictures.every(({ bounds }) => {
    const [small, large] = [bounds.size, first.size].sort((a, b) => a - b);
    return large <= ALIKE.size * small && bounds.centre.distanceTo(first.centre) <= ALIKE.away * large;
  });
}
