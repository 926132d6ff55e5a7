// SPDX-License-Identifier: Apache-2.0
// Named views, following a body, and views into a mesh, in all viewports.
import { Matrix4, Vector3 } from "three";

export class Views {
  /**
   * @param {import("./stage.js").Stage} stage
   * @param {import("./orbit.js").Orbit} orbit
   * @param {() => any[]} legends at the right edges
   * @param {() => number} panel fraction of the width covered by a panel at the left
   */
  constructor(stage, orbit, legends = () => [], panel = () => 0) {
    this.stage = stage;
    this.orbit = orbit;
    this.legends = legends;
    this.panel = panel;
    /** Names of the bodies that can be followed; those of the first result come first, in their order. */
    this.names = [...new Set(stage.pictures.flatMap(({ data }) => data.bodies.filter(({ part }) => !part).map(({ name }) => name)))];
    this.body = -1;
    this.turning = false;
    this.anchors = stage.pictures.map(() => new Matrix4());
  }

  /**
   * Index of the followed body in a viewport, matched by name; -1 if the result does not contain it.
   * @param {any} picture
   */
  bodyIn({ data }) {
    return this.body < 0 ? -1 : data.bodies.findIndex(({ name }) => name === this.names[this.body]);
  }

  /** Index of the followed body in the first viewport. */
  get first() {
    return this.bodyIn(this.stage.pictures[0]);
  }

  get poses() {
    return this.stage.pictures[0].poses;
  }

  /** Directions from the scene to the camera. */
  directions() {
    const axis = this.poses.axis().transformDirection(this.stage.pictures[0].seen);
    const up = this.orbit.up;
    const side = new Vector3().crossVectors(up, axis);
    if (side.length() < 1e-3) side.crossVectors(new Vector3(1, 0, 0), axis);
    if (side.length() < 1e-3) side.crossVectors(new Vector3(0, 0, 1), axis);
    side.normalize();
    const third = new Vector3().crossVectors(axis, side);
    // With a vertical axis, the oblique view is mainly from the side instead of from above.
    const upright = Math.abs(axis.dot(up)) > 0.9;
    const [along, across, over] = upright ? [0.55 * Math.sign(axis.dot(up)), 1, 0.7] : [1, 0.75, 0.55];
    return {
      axis,
      side,
      top: upright ? axis : third,
      iso: axis.clone().multiplyScalar(along).addScaledVector(side, across).addScaledVector(third, over),
    };
  }

  /** Distance at which a sphere fills the viewport. @param {number} radius */
  distanceFor(radius) {
    const { camera } = this.stage;
    const half = Math.atan(Math.tan((camera.fov * Math.PI) / 360) * Math.min(1, camera.aspect));
    return radius / Math.sin(half);
  }

  /**
   * Centre the target in the area not covered by legends or panels.
   * @param {number} taken covered fraction of the width, negative at the left
   * @param {number} top covered fraction of the height
   */
  #shift(taken, top = 0) {
    this.stage.shift = this.orbit.shift = taken / 2;
    this.stage.drop = this.orbit.drop = top / 2;
  }

  /** @param {boolean} atOnce */
  fit(atOnce = false) {
    const { alike, pictures } = this.stage;
    const outlines = pictures.map(({ bounds, arrows, seen }) =>
      [...bounds.outline, ...arrows.ends()].map((point) => point.clone().applyMatrix4(seen)),
    );
    // Variants of one machine share a view; different machines are fitted separately.
    const groups = alike
      ? [{ points: outlines.flat(), bounds: this.stage.bounds(), factor: 1 }]
      : pictures.map(({ bounds, seen }, k) => ({
          points: outlines[k],
          bounds: { radius: bounds.radius, centre: bounds.centre.clone().applyMatrix4(seen) },
          factor: bounds.size / pictures[0].bounds.size,
        }));
    const legends = this.legends() ?? [];
    const [wide, strip, high] = ["share", "strip", "drop"].map((side) => Math.max(0, ...legends.map((legend) => legend[side])));
    let [taken, top] = [-this.panel(), 0];
    const framed = () => groups.map(({ points, bounds }) => this.#framed(points, bounds, taken, top));
    let views = framed();
    const covers = (share) => share > 0 && groups.some(({ points }, k) => points.some((point) => views[k].under(point, share, high)));
    // If a legend would cover part of the solids, space is reserved next to it, or below it if it is folded.
    if (covers(wide)) taken = wide;
    else if (covers(strip)) top = high;
    if (taken || top) views = framed();
    this.#shift(taken, top);
    this.#look(
      pictures.map((_, k) => views[alike ? 0 : k].target),
      pictures.map(({ bounds }) => bounds.size),
      { distance: Math.max(...views.map(({ distance }, k) => distance / groups[k].factor)) },
      atOnce,
    );
    this.orbit.chosen = false;
  }

  /**
   * Direct each viewport at its own target.
   * @param {Vector3[]} targets in the camera's world
   * @param {number[]} sizes of the objects that are shown equally large
   * @param {{direction?: Vector3, distance?: number}} view of the first viewport
   * @param {boolean} atOnce
   */
  #look(targets, sizes, view, atOnce = false) {
    this.stage.meet(targets, sizes);
    // Easing applies to the first viewport only; targets that differ between viewports would jump.
    this.orbit.look({ target: targets[0], ...view }, atOnce || !this.stage.alike);
  }

  /**
   * Target and distance at which a set of points fills the viewport.
   * @param {Vector3[]} points
   * @param {{centre: Vector3, radius: number}} bounds
   * @param {number} taken fraction of the width to keep free
   * @param {number} top fraction of the height to keep free
   */
  #framed(points, { centre, radius }, taken, top) {
    const { camera } = this.stage;
    const toward = this.orbit.direction(this.orbit.goal);
    const right = new Vector3().crossVectors(this.orbit.up, toward).normalize();
    const above = new Vector3().crossVectors(toward, right);
    const half = Math.tan((camera.fov * Math.PI) / 360);
    const tall = 0.9 * half * (1 - top);
    const wide = 0.9 * half * camera.aspect * (1 - Math.abs(taken));
    // Two iterations centre the projection of the points, the third one gives the distance.
    const target = centre.clone();
    let distance = this.distanceFor(radius);
    for (let round = 0; points.length && round < 3; round++) {
      const ends = [Infinity, -Infinity, Infinity, -Infinity];
      let least = 0;
      for (const point of points) {
        const from = point.clone().sub(target);
        const [x, y, z] = [from.dot(right), from.dot(above), from.dot(toward)];
        const depth = camera.parallel ? distance : Math.max(distance - z, 1e-3 * radius);
        ends[0] = Math.min(ends[0], x / depth);
        ends[1] = Math.max(ends[1], x / depth);
        ends[2] = Math.min(ends[2], y / depth);
        ends[3] = Math.max(ends[3], y / depth);
        const nearer = camera.parallel ? 0 : z;
        least = Math.max(least, nearer + Math.abs(x) / wide, nearer + Math.abs(y) / tall);
      }
      if (round === 2) {
        distance = least;
        break;
      }
      target.addScaledVector(right, (distance * (ends[0] + ends[1])) / 2);
      target.addScaledVector(above, (distance * (ends[2] + ends[3])) / 2);
    }
    distance = Math.max(distance, 0.1 * radius);
    /** Whether a point lies in the upper right corner given by fractions of width and height. */
    const under = (point, share, drop) => {
      const from = point.clone().sub(target);
      const tip = half * (camera.parallel ? distance : distance - from.dot(toward));
      return from.dot(right) > tip * camera.aspect * (1 - 2 * share) && from.dot(above) > tip * (1 - 2 * drop);
    };
    return { target, distance, under };
  }

  /**
   * Standard view.
   * @param {"axis"|"side"|"front"|"top"|"iso"} name front: another name of the view from the side
   * @param {boolean} atOnce
   */
  named(name, atOnce = false) {
    const directions = this.directions();
    const direction = directions[name === "front" ? "side" : name];
    // In the view from above, the axis is horizontal as in the side view.
    if (name === "top") this.orbit.look({ direction: directions.side });
    this.orbit.look({ direction }, atOnce);
    this.stage.section?.face(direction);
    this.fit(atOnce);
  }

  /**
   * Keep a body at its position in the view.
   * @param {number} body -1 none
   * @param {boolean} turning whether the view also rotates with the body
   */
  follow(body, turning = this.turning) {
    this.body = body;
    this.turning = turning;
    const { pictures } = this.stage;
    if (body < 0) {
      // On return to the fixed view, the camera keeps its distance and the target stays in the centre.
      const targets = pictures.map((picture) =>
        this.stage.targetOf(picture, this.orbit.goal.target).applyMatrix4(picture.seen.clone().invert()),
      );
      for (const { seen } of pictures) seen.identity();
      this.stage.meet(targets);
      this.orbit.look({ target: targets[0] }, true);
      return;
    }
    pictures.forEach((picture, k) => this.anchors[k].multiplyMatrices(picture.seen, this.#frame(picture)));
    this.orbit.changed();
  }

  #frame(picture) {
    const world = picture.poses.world[this.bodyIn(picture)] ?? new Matrix4();
    return this.turning
      ? world.clone()
      : new Matrix4().setPosition(new Vector3().setFromMatrixPosition(world));
  }

  /** Update the transformation of the scene to the current pose of the followed body. */
  update() {
    if (this.body < 0) return;
    this.stage.pictures.forEach((picture, k) =>
      picture.seen.multiplyMatrices(this.anchors[k], this.#frame(picture).invert()),
    );
  }

  /**
   * @param {number[]} target
   * @param {number[]} direction to the camera
   * @param {number} height visible height at the target [m]
   */
  look(target, direction, height) {
    const distance = height / (2 * Math.tan((this.stage.camera.fov * Math.PI) / 360));
    this.#shift(0);
    this.orbit.look(
      { target: new Vector3(...target), direction: direction && new Vector3(...direction), distance },
      true,
    );
  }

  /** Zoom to the followed body. Viewports without it zoom to the same extent. */
  closeUp() {
    if (this.body < 0) return;
    const { pictures } = this.stage;
    const found = pictures.map((picture) => {
      const body = this.bodyIn(picture);
      if (body < 0) return null;
      const target = new Vector3().setFromMatrixPosition(picture.poses.world[body]).applyMatrix4(picture.seen);
      return { target, size: picture.solids.reachOf(body) };
    });
    this.#onto(found, (size) => this.distanceFor(1.15 * size));
  }

  /**
   * Zoom each viewport to the object found in it.
   * @param {({target: Vector3, size: number}|null)[]} found one per viewport
   * @param {(size: number) => number} away distance for a size
   * @param {Vector3} [direction]
   */
  #onto(found, away, direction) {
    const { pictures, alike } = this.stage;
    const { target: goal } = this.orbit.goal;
    const targets = found.map((each, k) => each?.target ?? this.stage.targetOf(pictures[k], goal));
    // A viewport without the object is zoomed to the same size relative to its machine.
    const known = found.findIndex((each) => each?.size > 0);
    if (known < 0) return this.#look(targets, undefined, { direction });
    const unit = found[known].size / pictures[known].bounds.size;
    const sizes = pictures.map(({ bounds }, k) =>
      found[k]?.size > 0 ? found[k].size : unit * (alike ? pictures[known] : { bounds }).bounds.size,
    );
    this.#look(targets, sizes, { direction, distance: away(alike ? Math.max(...sizes) : sizes[0]) });
  }

  /**
   * Gear whose tip circle is closest to a point. Arrows of meshes do not refer to a gear.
   * @param {Vector3} point
   * @param {any} picture
   */
  #gearAt(point, { solids, poses }) {
    let best = null;
    for (const part of solids.parts) {
      if (!part.solid.teeth) continue;
      const frame = poses.ofSolid(part.solid);
      const axis = new Vector3().setFromMatrixColumn(frame, 2);
      const arm = point.clone().sub(new Vector3().setFromMatrixPosition(frame));
      const radius = arm.addScaledVector(axis, -arm.dot(axis)).length();
      const off = Math.abs(part.rim - radius) / part.rim;
      if (!best || off < best.off) best = { off, axis, pitch: (2 * Math.PI * radius) / part.solid.teeth };
    }
    return best;
  }

  /** Position, axis and pitch of a mesh in a viewport. @param {any} picture @param {any} arrow */
  #meshIn(picture, arrow) {
    const { poses, arrows, data, seen, bounds } = picture;
    const point = arrows.forces()[data.arrows.indexOf(arrow)].at;
    const gear = this.#gearAt(point, picture);
    const axis = gear ? gear.axis : poses.axis();
    return { point, axis, target: point.clone().applyMatrix4(seen), size: gear ? gear.pitch : 0.1 * bounds.radius };
  }

  /**
   * View along the gear axis on the point of action of a mesh, in all viewports that contain a mesh of this
   * name.
   * @param {any} arrow
   * @returns {({point: Vector3, axis: Vector3}|null)[]} for a section, in the world of each viewport
   */
  intoMesh(arrow) {
    const { pictures, camera } = this.stage;
    const found = pictures.map((picture) => {
      const same = picture.data.arrows.find(({ kind, name }) => kind === "mesh" && name === arrow.name);
      return same ? this.#meshIn(picture, same) : null;
    });
    const at = found.findIndex(Boolean);
    const direction = found[at].axis.clone().transformDirection(pictures[at].seen);
    this.#onto(found, (pitch) => (1.6 * pitch) / (2 * Math.tan((camera.fov * Math.PI) / 360)), direction);
    return found;
  }
}
