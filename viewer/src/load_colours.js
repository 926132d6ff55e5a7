// SPDX-License-Identifier: Apache-2.0
// Colours of loads on flanks: perceptually uniform, dark for small loads.

const STOPS = ["#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"].map((text) =>
  [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16) / 255),
);

/** Red, green and blue in sRGB, from 0 to 1. @param {number} share of the largest load */
export function loadColour(share) {
  const x = Math.max(0, Math.min(1, share)) * (STOPS.length - 1);
  const k = Math.min(Math.floor(x), STOPS.length - 2);
  return STOPS[k].map((low, c) => low + (x - k) * (STOPS[k + 1][c] - low));
}

/** The same colour for shaders, which compute in linear light. @param {number} share */
export const litColour = (share) =>
  loadColour(share).map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));

export const gradient = () =>
  `linear-gradient(to right, ${STOPS.map((stop) => `rgb(${stop.map((x) => Math.round(255 * x)).join(" ")})`).join(", ")})`;
