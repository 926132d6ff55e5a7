// SPDX-License-Identifier: Apache-2.0
// Interpolation of tables between the frames of a time table.

/**
 * @param {ArrayLike<number>} times ascending
 * @param {number} t
 * @returns {{low: number, share: number}} position between frames low and low + 1; clamped at the ends
 */
export function between(times, t) {
  const n = times.length;
  if (n < 2 || t <= times[0]) return { low: 0, share: 0 };
  if (t >= times[n - 1]) return { low: n - 2, share: 1 };
  let low = 0,
    high = n - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  const step = times[low + 1] - times[low];
  return { low, share: step > 0 ? (t - times[low]) / step : 0 };
}

/**
 * Interpolated value in a column of a table; a table with one row is constant.
 * @param {import("./scene_file.js").Table} table
 * @param {{low: number, share: number}} where
 * @param {number} column
 */
export function lerp(table, where, column = 0) {
  const { data, width, count } = table;
  if (count === 1) return data[column];
  const k = where.low * width + column;
  return where.share ? data[k] + where.share * (data[k + width] - data[k]) : data[k];
}

/** Mean of each column. @param {import("./scene_file.js").Table} table */
export function means(table) {
  const sum = new Float64Array(table.width);
  for (let k = 0; k < table.data.length; k++) sum[k % table.width] += table.data[k];
  return sum.map((value) => value / Math.max(table.count, 1));
}
