// SPDX-License-Identifier: Apache-2.0
// Number formats.

const THIN = "\u2009";
const MINUS = "\u2212";

/** @param {number} value @param {number} digits significant digits */
export function number(value, digits = 4) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text =
    size >= 1e6 || size < 1e-4
      ? size.toExponential(digits - 1).replace("e+", "e")
      : trim(size.toPrecision(digits));
  return (value < 0 ? MINUS : "") + text;
}

function trim(text) {
  const plain = String(Number(text));
  return text.includes(".") && !text.includes("e") ? text : plain;
}

/** A value with its uncertainty: 32.1 ± 0.4. @param {number} value @param {number} half */
export function within(value, half) {
  const decimals = Math.min(9, Math.max(0, -Math.floor(Math.log10(half) + 1e-9)));
  return `${value.toFixed(decimals).replace("-", MINUS)} ± ${half.toFixed(decimals)}`;
}

/**
 * Format with a fixed number of decimals, chosen for four significant digits of the maximum.
 * @param {number} largest
 */
export function fixed(largest) {
  const decimals = largest > 0 ? 3 - Math.floor(Math.log10(largest)) : 0;
  if (decimals > 9 || decimals < -6) return (value) => number(value, 4);
  return (value) =>
    value
      .toFixed(Math.max(0, decimals))
      .replace(/^-(0(\.0*)?)$/, "$1")
      .replace("-", MINUS);
}

/**
 * A force with a suitable unit prefix.
 * @param {number} value [N or N m]
 * @param {string} unit
 * @param {number} scale magnitude that determines the prefix
 * @param {number} least magnitude that determines the number of decimals
 */
export function force(value, unit, scale = value, least = scale) {
  const size = Math.abs(scale);
  const [factor, prefix] = size >= 1e6 ? [1e-6, "M"] : size >= 1e3 ? [1e-3, "k"] : [1, ""];
  const x = value * factor;
  const digits = Math.abs(least * factor) >= 100 ? 1 : Math.abs(least * factor) >= 10 ? 2 : 3;
  return `${x < 0 ? MINUS : ""}${Math.abs(x).toFixed(digits)}${THIN}${prefix}${unit}`;
}

const LENGTHS = [
  [1, "m"],
  [1e-3, "mm"],
  [1e-6, "µm"],
  [1e-9, "nm"],
];
const TIMES = [
  [1, "s"],
  [1e-3, "ms"],
  [1e-6, "µs"],
];

/** Unit of a time axis, its factor [s] and name. @param {number} most last instant on the axis [s] */
export const timeUnit = (most) => TIMES[most >= 0.02 ? 0 : most >= 2e-5 ? 1 : 2];

function withPrefix(value, prefixes, digits) {
  const [unit, name] =
    prefixes.find(([size]) => Math.abs(value) >= size * 0.999) ?? prefixes[prefixes.length - 1];
  return `${number(value / unit, digits)}${THIN}${name}`;
}

/** @param {number} metres */
export const length = (metres) => withPrefix(metres, LENGTHS, 1).replace(/\.0+(?=\D)/, "");

/** @param {number} seconds */
export const duration = (seconds) => (seconds === 0 ? `0${THIN}s` : withPrefix(seconds, TIMES, 3));

/**
 * An instant with sufficient digits to distinguish consecutive frames.
 * @param {number} t
 * @param {number} step [s]
 */
export function instant(t, step) {
  const [unit, name] = TIMES[step >= 5e-4 ? 0 : step >= 8e-7 || Math.abs(t) >= 1e-3 ? 1 : 2];
  const decimals = Math.max(0, Math.min(6, Math.ceil(-Math.log10(Math.max(step, 1e-12) / unit) - 1e-9)));
  return `${(t / unit).toFixed(decimals).replace("-", MINUS)}${THIN}${name}`;
}

/** @param {number} speed relative to real time */
export function speedWords(speed) {
  if (speed >= 0.999) return "real time";
  const slow = 1 / speed;
  const text =
    slow < 10
      ? String(Number(slow.toPrecision(2)))
      : String(Math.round(slow)).replace(/\B(?=(\d{3})+$)/g, THIN);
  return `1/${text} of real time`;
}
