// SPDX-License-Identifier: Apache-2.0
// Plane of action of bevel gears, whose rays meet at the apex: positions in it, and forces along it.
import { Vector3 } from "three";

/**
 * Position in the plane of action, in the mesh frame.
 * @param {number[] | undefined} cone bevel gears: mean cone distance and pitch cone angle of gear 2
 * @param {Vector3} normal direction of the line of action
 * @param {number} x on the path of contact, at the mean cone distance
 * @param {number} z along the face width: R_m ln(R/R_m)
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
 * Components of the force of a tooth pair on gear 2, in the mesh frame, with respect to the axis of gear 2.
 * @param {number[]} cone
 * @param {number} alpha pressure angle
 * @param {number} tangent of the base spiral angle
 * @param {number} force along the base tangent, positive on front flanks
 * @param {number} x position on the path of contact
 */
export function alongPairs(cone, alpha, tangent, force, x) {
  const [middle, delta] = cone;
  const size = Math.abs(force),
    side = force < 0 ? -1 : 1;
  const c = Math.cos(x / middle),
    s = Math.sin(x / middle);
  // From the directions across and along the ray through the contact to those of the line of action and the
  // pitch ray.
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
