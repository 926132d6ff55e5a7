// SPDX-License-Identifier: Apache-2.0
// Colours of parts, forces and curves. Force colours follow the CSS variables that the plots of the page use
// too.

export const FORCES = ["circumferential", "radial", "axial"];

const FORCE_DEFAULTS = { circumferential: "#d55e00", radial: "#0072b2", axial: "#009e73" };

/** Names and colours of contact states: 1 front flank, -1 back flank, 2 both, 0 no contact. */
export const STATES = {
  1: { word: "front flank", colour: "#e8b400" },
  "-1": { word: "back flank", colour: "#b0489a" },
  2: { word: "both flanks", colour: "#7a5a2a" },
  0: { word: "no contact", colour: "#8a8f98" },
};

// Mating gears differ slightly in hue; muted colours keep the arrows prominent.
const GEARS = ["#93a9c1", "#c1ab8b", "#93b5a0", "#ad9fc2", "#c4a0a0", "#8cb0bb"];
const KINDS = {
  shaft: "#b3b9bf",
  bearing: "#6b7885",
  element: "#d3d8dc",
  housing: "#9fb3c6",
  carrier: "#b9b39c",
  spring: "#8d97a1",
  body: "#a9b6c0",
};

/** Damaged teeth are tinted with this colour. */
export const FAULT = "#c2452d";

/**
 * @param {string} kind
 * @param {number} order index among the parts of this kind
 * @param {boolean} schematic links of mechanisms differ in hue too
 */
export function colourOfPart(kind, order, schematic = false) {
  return kind === "gear" || (kind === "body" && schematic) ? GEARS[order % GEARS.length] : (KINDS[kind] ?? KINDS.body);
}

/** @param {Element} element @param {string} part */
export function colourOfForce(element, part) {
  return getComputedStyle(element).getPropertyValue(`--pp-force-${part}`).trim() || FORCE_DEFAULTS[part];
}

// Blue, orange and violet are reserved for forces. Medium lightness gives contrast on light and dark
// backgrounds.
const CURVES = ["#2296a0", "#c2509a", "#a88a1e", "#d2484f", "#6b8e23", "#8f6b52", "#8a8f98"];

/** @param {string} name of a channel */
export const isForce = (name) => FORCES.some((part) => name.startsWith(`${part}_force`));

/**
 * Colour of a channel; channels of a force component have the colour of that component.
 * @param {Element} element
 * @param {string} name
 * @param {number} order
 */
export function colourOfChannel(element, name, order) {
  const part = FORCES.find((word) => name.startsWith(`${word}_force`));
  return part ? colourOfForce(element, part) : CURVES[order % CURVES.length];
}

const MARKS = ["#d2484f", "#a88a1e", "#8a68c4", "#2296a0", "#2f9e62"];

const MARK_KINDS = {
  contact_loss: "#8a8f98",
  impact: "#d2484f",
  back_flank: "#b0489a",
  front_flank: "#e8b400",
  faulty_tooth: "#2296a0",
};

/** @param {string[]} kinds @param {string} kind */
export function colourOfMark(kinds, kind) {
  return MARK_KINDS[kind] ?? MARKS[Math.max(kinds.indexOf(kind), 0) % MARKS.length];
}
