// SPDX-License-Identifier: Apache-2.0
// Quantity shown by the colours on flanks: load per width, or the resulting Hertzian pressure.
import { reached } from "./contacts.js";
import { number } from "./numbers.js";

/**
 * Hertzian pressure due to a load at a position. The file contains the pressure for 1 N/m along the path of
 * contact. Teeth of bevel gears are similar at all cone distances and become smaller towards the apex.
 * @param {any} contact
 * @param {[number, number]} at position on path of contact and face width, from the pitch point [m]
 * @param {number} load [N/m]
 */
export function pressureAt(contact, [place, z], load) {
  const { data, count } = contact.unit_pressure;
  const [start, end] = contact.path;
  const x = Math.max(0, Math.min(1, (place - start) / (end - start))) * (count - 1);
  const k = Math.min(Math.floor(x), count - 2);
  const size = contact.cone ? Math.exp(z / contact.cone[0]) : 1;
  return (data[k] + (x - k) * (data[k + 1] - data[k])) * Math.sqrt(Math.max(0, load) / size);
}

/**
 * Position of a station of a contact line on path of contact and face width.
 * @param {{place: number, slope: number, from: number, to: number}} line
 * @param {number} share of the length of the line
 * @returns {[number, number]}
 */
export const placeOf = ({ place, slope, from, to }, share) => {
  const z = from + share * (to - from);
  return [place + slope * z, z];
};

/** Maximum pressure of a contact over all frames [Pa]. @param {any} contact */
export function greatestPressure(contact) {
  if (!contact.unit_pressure) return 0;
  let found = 0;
  for (const flank of contact.flanks) {
    if (!flank.loads) continue;
    const [frames, slots, count] = flank.loads.shape;
    for (let frame = 0; frame < frames; frame++) {
      const travel = flank.travel.data[flank.travel.count > 1 ? frame : 0];
      for (const line of reached(contact, flank, travel)) {
        const slot = ((line.pair % slots) + slots) % slots;
        for (let s = 0; s < count; s++) {
          const load = flank.loads.data[(frame * slots + slot) * count + s];
          if (load > 0)
            found = Math.max(found, pressureAt(contact, placeOf(line, s / (count - 1)), load));
        }
      }
    }
  }
  return found;
}

/** Name, legend, number format and maximum of each quantity. */
export const SHADES = {
  load: {
    name: "load per width",
    legend: "load per width",
    format: (value) => `${number(value / 1e3, 3)}\u2009N/mm`,
    of: (contact, at, load) => load,
    greatest: ({ greatest }) => greatest,
  },
  pressure: {
    name: "pressure (Hertz)",
    legend: "Hertzian pressure",
    format: (value) => `${number(value / 1e6, 3)}\u2009MPa`,
    of: pressureAt,
    greatest: (mesh) => (mesh.pressure ??= greatestPressure(mesh.contact)),
  },
};
