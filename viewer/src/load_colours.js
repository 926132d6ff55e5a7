// SPDX-License-Identifier: Apache-2.0
// Colours of a load on a flank: perceptually even, dark is little.

const STOPS = ["#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"].map((text) =>
  [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16) / 255),
);

/** Red, green and blue, 0 to 1, as screens have them. @param {number} share of the largest load */
export function loadColour(share) {
  const x = Math.max(0, Math.min(1, share)) * (STOPS.length - 1);
  const k = Math.min(Math.floor(x), STOPS.length - 2);
  return STOPS[k].map((low, c) => low + (x - k) * (STOPS[k + 1][c] - low));
}

/** The same for colours that are lit: shaders reckon in linear light. @param {number} share */
export const litColour = (share) =>
  loadColour(share).map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));

/** As a gradient of CSS. */
export const gradient = () =>
  `linear-gradient(to right, ${STOPS.map((stop) => `rgb(${stop.map((x) => Math.round(255 * x)).join(" ")})`).join(", ")})`;
