// SPDX-License-Identifier: Apache-2.0
// Plane of action of bevel gears, whose rays meet in the apex: places in it, and forces along it.
import { Vector3 } from "three";

/**
 * A place of the plane of action in the mesh frame.
 * @param {number[] | undefined} cone mean cone distance and pitch cone angle of gear 2 of bevel gears
 * @param {Vector3} normal direction of the line of action
 * @param {number} x on the path, at the mean cone distance @param {number} z on the width: R_m ln(R/R_m)
 */
export function place(cone, normal, x, z) {
  if (!cone) return normal.clone().multiplyScalar(x).setZ(z);
  const [middle] = cone;
  const distance = middle * Math.exp(z / middle);
  const angle = x / middle;
  return normal
    .clone()
    .multiplyScalar(distance * Math.sin(angle))
    .setZ(distance * Math.cos(angle) - middle);
}

/**
 * Parts of the force of a pair on gear 2, in the mesh frame; they refer to the axis of that gear.
 * @param {number[]} cone @param {number} alpha pressure angle @param {number} tangent of the base spiral angle
 * @param {number} force along the base tangent, front positive @param {number} x where on the path it acts
 */
export function alongPairs(cone, alpha, tangent, force, x) {
  const [middle, delta] = cone;
  const size = Math.abs(force),
    side = force < 0 ? -1 : 1;
  const c = Math.cos(x / middle),
    s = Math.sin(x / middle);
  // along the line of action and along the pitch ray: across the ray of the place, and against the spiral
  const across = size * (c - side * tangent * s),
    ray = size * (-s - side * tangent * c);
  const towards = across * Math.sin(alpha);
  const radial = towards * Math.cos(delta) - ray * Math.sin(delta);
  const axial = towards * Math.sin(delta) + ray * Math.cos(delta);
  return {
    circumferential: new Vector3(0, side * across * Math.cos(alpha), 0),
    radial: new Vector3(Math.cos(delta), 0, -Math.sin(delta)).multiplyScalar(radial),
    axial: new Vector3(Math.sin(delta), 0, Math.cos(delta)).multiplyScalar(axial),
  };
}
