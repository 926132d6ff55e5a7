// SPDX-License-Identifier: Apache-2.0
// Tables whose bytes are stored in planes, as differences: docs/scene_format.md, "Planes".

/**
 * Integers of a table.
 * @param {Uint8Array} bytes planes in sequence, lowest byte first
 * @param {number} length number of values in the table
 * @param {any} entry of the header
 * @returns {Float64Array} in the order of the table
 */
export function fromPlanes(bytes, length, { shape, differences, across }) {
  const stored = new Float64Array(length);
  for (let at = 0, weight = 1; at < bytes.length; at += length, weight *= 256)
    for (let k = 0; k < length; k++) stored[k] += weight * bytes[at + k];
  // The lowest bit is the sign.
  for (let k = 0; k < length; k++) stored[k] = stored[k] % 2 ? -(stored[k] + 1) / 2 : stored[k] / 2;
  const rows = across ? shape[shape.length - 1] : shape[0];
  for (let at = 0; rows && at < length; at += rows) add(stored, at, at + rows, differences);
  if (across) return stored;
  const columns = rows ? length / rows : 0;
  const out = new Float64Array(length);
  for (let c = 0; c < columns; c++) for (let r = 0; r < rows; r++) out[r * columns + c] = stored[c * rows + r];
  return out;
}

/**
 * Restore one column from its differences.
 * @param {Float64Array} values
 * @param {number} from
 * @param {number} to
 * @param {number} order
 */
function add(values, from, to, order) {
  if (order === 0) for (let k = from + 1; k < to; k++) values[k] += values[from];
  if (order === 2) for (let k = from + 2; k < to; k++) values[k] += values[k - 1];
  if (order > 0) for (let k = from + 1; k < to; k++) values[k] += values[k - 1];
}

/**
 * Tables that are linear combinations of fewer columns.
 * @param {ArrayLike<number>} data count rows of mix.length columns
 * @param {number} count
 * @param {number[][]} mix contribution of each stored column to each column
 * @param {number[]} offset
 */
export function mixed(data, count, mix, offset) {
  const width = offset.length;
  const out = new Float64Array(count * width);
  for (let k = 0; k < count; k++)
    for (let c = 0; c < width; c++) {
      let sum = offset[c];
      for (let m = 0; m < mix.length; m++) sum += mix[m][c] * data[k * mix.length + m];
      out[k * width + c] = sum;
    }
  return out;
}

/** Steps of a mean between minimum and maximum. */
const MEAN = 63;

/**
 * Assign times, minimum, mean and maximum to each channel, from columns of tables that channels share.
 * @param {any} scene
 */
export function spreadChannels(scene) {
  for (const channel of scene.channels) {
    if (!channel.curve) continue;
    const [number, column] = channel.curve;
    const [offset, step] = channel.from;
    const { times, least, span, mean } = scene.curves[number];
    const pick = (value) => {
      const data = Float64Array.from({ length: least.count }, (_, k) => offset + step * value(k));
      return { data, shape: [least.count], width: 1, count: least.count };
    };
    const at = (table, k) => table.data[k * table.width + column];
    channel.times = times;
    channel.least = pick((k) => at(least, k));
    const wide = span && channel.least.data.some((_, k) => at(span, k) !== 0);
    if (!wide) continue;
    channel.most = pick((k) => at(least, k) + at(span, k));
    if (mean) channel.mean = pick((k) => at(least, k) + (at(mean, k) / MEAN) * at(span, k));
  }
}
