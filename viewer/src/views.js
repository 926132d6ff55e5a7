// SPDX-License-Identifier: Apache-2.0
// Named views, following a body, and the look into a mesh.
import { Matrix4, Vector3 } from "three";

export class Views {
  /** @param {import("./stage.js").Stage} stage @param {import("./orbit.js").Orbit} orbit @param {() => any[]} legends that lie over the right edges */
  constructor(stage, orbit, legends = () => []) {
    this.stage = stage;
    this.orbit = orbit;
    this.legends = legends;
    this.body = -1;
    this.turning = false;
    this.anchor = new Matrix4();
  }

  get poses() {
    return this.stage.pictures[0].poses;
  }

  /** Directions from the scene to the camera. */
  directions() {
    const axis = this.poses.axis().transformDirection(this.stage.seen);
    const up = this.orbit.up;
    const side = new Vector3().crossVectors(up, axis);
    if (side.length() < 1e-3) side.crossVectors(new Vector3(1, 0, 0), axis);
    if (side.length() < 1e-3) side.crossVectors(new Vector3(0, 0, 1), axis);
    side.normalize();
    const third = new Vector3().crossVectors(axis, side);
    // what turns about a vertical axis is looked at from the side, not from above
    const upright = Math.abs(axis.dot(up)) > 0.9;
    const [along, across, over] = upright ? [0.55 * Math.sign(axis.dot(up)), 1, 0.7] : [1, 0.75, 0.55];
    return {
      axis,
      front: side,
      top: upright ? axis : third,
      iso: axis.clone().multiplyScalar(along).addScaledVector(side, across).addScaledVector(third, over),
    };
  }

  /** Distance from which a sphere fills the picture. @param {number} radius */
  distanceFor(radius) {
    const { camera } = this.stage;
    const half = Math.atan(Math.tan((camera.fov * Math.PI) / 360) * Math.min(1, camera.aspect));
    return radius / Math.sin(half);
  }

  /** What is looked at goes to the middle of what no legend covers. @param {number} taken part of the width */
  #shift(taken) {
    this.stage.shift = this.orbit.shift = taken / 2;
  }

  /** @param {boolean} atOnce */
  fit(atOnce = false) {
    const { seen, pictures } = this.stage;
    const points = pictures.flatMap((picture) =>
      [...picture.bounds.outline, ...picture.arrows.ends()].map((point) => point.clone().applyMatrix4(seen)),
    );
    const legends = this.legends() ?? [];
    const [wide, high] = ["share", "drop"].map((side) => Math.max(0, ...legends.map((legend) => legend[side])));
    let taken = 0;
    let view = this.#framed(points, taken);
    // room for the legends where something would lie under them
    if (wide && points.some((point) => view.under(point, wide, high)))
      view = this.#framed(points, (taken = wide));
    this.#shift(taken);
    this.orbit.look({ target: view.target, distance: view.distance }, atOnce);
    this.orbit.chosen = false;
  }

  /**
   * Target and distance from which points fill the picture.
   * @param {Vector3[]} points @param {number} taken part of the width that is left free
   */
  #framed(points, taken) {
    const { centre, radius } = this.stage.bounds();
    const { camera } = this.stage;
    const toward = this.orbit.direction(this.orbit.goal);
    const right = new Vector3().crossVectors(this.orbit.up, toward).normalize();
    const above = new Vector3().crossVectors(toward, right);
    const tall = 0.9 * Math.tan((camera.fov * Math.PI) / 360);
    const wide = tall * camera.aspect * (1 - taken);
    // twice: the first look tells how far the middle of the picture is from the middle of the solids
    const target = centre.clone();
    let distance = this.distanceFor(radius);
    for (let round = 0; points.length && round < 3; round++) {
      const ends = [Infinity, -Infinity, Infinity, -Infinity];
      let least = 0;
      for (const point of points) {
        const from = point.clone().sub(target);
        const [x, y, z] = [from.dot(right), from.dot(above), from.dot(toward)];
        const depth = Math.max(distance - z, 1e-3 * radius);
        ends[0] = Math.min(ends[0], x / depth);
        ends[1] = Math.max(ends[1], x / depth);
        ends[2] = Math.min(ends[2], y / depth);
        ends[3] = Math.max(ends[3], y / depth);
        least = Math.max(least, z + Math.abs(x) / wide, z + Math.abs(y) / tall);
      }
      if (round === 2) {
        distance = least;
        break;
      }
      target.addScaledVector(right, (distance * (ends[0] + ends[1])) / 2);
      target.addScaledVector(above, (distance * (ends[2] + ends[3])) / 2);
    }
    distance = Math.max(distance, 0.1 * radius);
    /** whether a point is shown in a corner at the upper right, in parts of the picture */
    const under = (point, share, drop) => {
      const from = point.clone().sub(target);
      const half = (tall / 0.9) * (distance - from.dot(toward));
      return (
        from.dot(right) > half * camera.aspect * (1 - 2 * share) && from.dot(above) > half * (1 - 2 * drop)
      );
    };
    return { target, distance, under };
  }

  /** @param {"axis"|"front"|"top"|"iso"} name @param {boolean} atOnce */
  named(name, atOnce = false) {
    const directions = this.directions();
    // from above the axis lies across, as it does from the side
    if (name === "top") this.orbit.look({ direction: directions.front });
    this.orbit.look({ direction: directions[name] }, atOnce);
    this.fit(atOnce);
  }

  /**
   * Keep a body where it is in the picture.
   * @param {number} body -1 none @param {boolean} turning also its rotation
   */
  follow(body, turning = this.turning) {
    this.body = body;
    this.turning = turning;
    if (body < 0) {
      // back to the world: the camera keeps its distance, what it looked at stays in the middle
      const target = this.orbit.goal.target.clone().applyMatrix4(this.stage.seen.clone().invert());
      this.stage.seen.identity();
      this.anchor.identity();
      this.orbit.look({ target }, true);
      return;
    }
    this.anchor.multiplyMatrices(this.stage.seen, this.#frame());
    this.orbit.changed();
  }

  #frame() {
    const world = this.poses.world[this.body];
    return this.turning
      ? world.clone()
      : new Matrix4().setPosition(new Vector3().setFromMatrixPosition(world));
  }

  /** The world as seen at the instant of the poses. */
  update() {
    if (this.body >= 0) this.stage.seen.multiplyMatrices(this.anchor, this.#frame().invert());
  }

  /** @param {number[]} target @param {number[]} direction to the camera @param {number} height of what is seen there [m] */
  look(target, direction, height) {
    const distance = height / (2 * Math.tan((this.stage.camera.fov * Math.PI) / 360));
    this.#shift(0);
    this.orbit.look(
      { target: new Vector3(...target), direction: direction && new Vector3(...direction), distance },
      true,
    );
  }

  /** Middle of the followed body, closer. */
  closeUp() {
    if (this.body < 0) return;
    const { solids } = this.stage.pictures[0];
    const target = new Vector3()
      .setFromMatrixPosition(this.poses.world[this.body])
      .applyMatrix4(this.stage.seen);
    const radius = solids.reachOf(this.body);
    this.orbit.look({ target, distance: radius > 0 ? this.distanceFor(1.15 * radius) : undefined });
  }

  /** The gear whose rim a point is nearest to: arrows of meshes count in the world and name no gear. @param {Vector3} point @param {any} picture */
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

  /**
   * Along the axis of its gear on the point where a mesh acts.
   * @param {any} arrow @returns {{point: Vector3, axis: Vector3}} in the world, for a section through it
   */
  intoMesh(arrow) {
    const picture = this.stage.pictures.find(({ data }) => data.arrows.includes(arrow));
    const { poses, arrows, data } = picture;
    const force = arrows.forces()[data.arrows.indexOf(arrow)];
    const gear = this.#gearAt(force.at, picture);
    const axis = gear ? gear.axis : poses.axis();
    const pitch = gear ? gear.pitch : 0.1 * this.stage.bounds().radius;
    this.orbit.look({
      target: force.at.clone().applyMatrix4(this.stage.seen),
      direction: axis.clone().transformDirection(this.stage.seen),
      distance: (1.6 * pitch) / (2 * Math.tan((this.stage.camera.fov * Math.PI) / 360)),
    });
    return { point: force.at, axis };
  }
}
